#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

class btDiscreteDynamicsWorld;

namespace sherd {

/// Puts the contacts of a fragment with flat ground (a static plane, or a face of a static box that the whole
/// convex part is over) where its vertices are. Bullet finds them by iterations in single precision, which on
/// a floor of 100 m are wrong by millimetres, and of those that it finds it keeps four, which may all be on
/// one side of the centre of mass, and none of them where the fragment is deep in the ground: a splinter then
/// falls freely for a step, and at 60 Hz it spins after that, on and on. The contacts become the base on
/// which it stands: the lowest vertex and up to three more that are hardly higher, by `even` or by half of
/// what the lowest is deep, m. What else may touch the ground in this step, the vertices up to `reach` above
/// it, becomes up to four contacts in an extra manifold. A contact that was there before keeps what it
/// knows. Returns whether it did: nothing is done on other ground, to shapes without vertices, or where the
/// app changes contacts itself (CF_CUSTOM_MATERIAL_CALLBACK) or has friction anchors.
bool standOnFlatGround(btDiscreteDynamicsWorld& world, btPersistentManifold& manifold, bool fragment_is_a,
                       btScalar reach, btScalar even);

}  // namespace sherd
