#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <vector>

#include "bullet/ground/standing_base.h"

class btDiscreteDynamicsWorld;
class btRigidBody;

namespace sherd {

/// Puts the contacts of a fragment with even ground (evenGround) where its vertices are. Bullet finds them by
/// iterations in single precision, which on a floor of 100 m are wrong by millimetres; of those that it finds
/// it keeps four, which may all be on one side of the centre of mass, and none of them where the fragment is
/// deep in the ground; and on a triangle mesh it takes edges between triangles of one plane for walls. A
/// splinter then falls freely for a step, and at 60 Hz it spins after that, on and on. The contacts become
/// the base on which it stands: the lowest vertex and up to three more that are hardly higher, by `even` or
/// by half of what the lowest is deep, m. What else may touch the ground in this step, the vertices up to
/// `reach` above it, becomes up to four contacts in an extra manifold. A contact that was there before keeps
/// what it knows. `inside`: a point of the fragment that tells its side of the ground. Returns whether it
/// did: nothing is done on other ground, to shapes without vertices, or where the app changes contacts itself
/// (CF_CUSTOM_MATERIAL_CALLBACK) or has friction anchors.
bool standOnEvenGround(btDiscreteDynamicsWorld& world, btPersistentManifold& manifold, bool fragment_is_a,
                       const btVector3& inside, btScalar reach, btScalar even);

/// Up to four vertices of a fragment that are in a surface that is even there, such that it could stand on
/// them; none if there are no such. `inside` as above.
std::vector<Foot> feetIn(const btCollisionObject& surface, const btRigidBody& fragment,
                         const btVector3& inside);

}  // namespace sherd
