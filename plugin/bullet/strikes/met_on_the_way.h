#pragma once

#include <LinearMath/btScalar.h>

#include <memory>
#include <vector>

class btPersistentManifold;

namespace sherd {

class StepSnapshot;

/// How two bodies met that have since gone deep into each other. Bullet's contacts say how they come apart on
/// the shortest way, which is sideways where a pillar lands on the seam of two bodies or on an edge, and
/// onwards where a ball is more than half through a plate: nothing closes along that. Set back to where the
/// step began, and moved on until they touch, they meet as they did. nullptr where the contacts of the
/// manifold say enough: something closes along one of them, or the overlap is not of this step. Of round and
/// polyhedral shapes and compounds of them, by the parts that overlap most. Bullet's solver has not stopped
/// them there: the impulse is the one that would.
std::unique_ptr<btPersistentManifold> metOnTheWay(const btPersistentManifold& manifold,
                                                  const StepSnapshot& before, double time_step_s);

/// Whether a body of the manifold is sunk about as deep, on the same side, in another body of `all`: then it
/// comes over a seam between them, and has not met the edge there.
bool isSunkBeside(const btPersistentManifold& manifold, const std::vector<btPersistentManifold*>& all);

}  // namespace sherd
