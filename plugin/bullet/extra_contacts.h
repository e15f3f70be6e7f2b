#pragma once

#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btPersistentManifold;

namespace sherd {

/// A manifold beside those that Bullet makes; it lasts until the next step, as predictive contacts do. Other
/// than in these, its points are where the surfaces touch.
btPersistentManifold& addExtraManifold(btDiscreteDynamicsWorld& world, const btCollisionObject& a,
                                       const btCollisionObject& b);

bool isExtra(const btPersistentManifold& manifold);

/// Takes their points away, for after a step: when Bullet releases a manifold that has any, it tells the app
/// that a contact has ended (gContactEndedCallback), and these never began for it.
void emptyExtraManifolds(btDiscreteDynamicsWorld& world);

/// The predictive contacts of continuous collision, without the extra manifolds.
std::vector<const btPersistentManifold*> foreseenContacts(btDiscreteDynamicsWorld& world);

}  // namespace sherd
