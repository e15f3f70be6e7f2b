#pragma once

#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btPersistentManifold;

namespace sherd {

/// A manifold beside those that Bullet makes, for a solve; nullptr if Bullet has no room for one. It is among
/// the predictive contacts of the world, but its points are on the bodies themselves, not on a swept sphere.
btPersistentManifold* addExtraManifold(btDiscreteDynamicsWorld& world, const btCollisionObject& a,
                                       const btCollisionObject& b);

bool isExtra(const btPersistentManifold& manifold);

/// For after a solve, before the app can delete a body or Bullet goes through predictive contacts. Bullet
/// tells the app that a contact has ended (gContactEndedCallback) when it releases a manifold that has
/// points; these never began for the app, and end without a word.
void releaseExtraManifolds(btDiscreteDynamicsWorld& world);

/// The predictive contacts of continuous collision, without the extra manifolds: by their addresses, for
/// look-up only.
std::vector<const btPersistentManifold*> predictiveContacts(btDiscreteDynamicsWorld& world);

/// Whether a manifold is among those.
bool isAmong(const std::vector<const btPersistentManifold*>& predictive,
             const btPersistentManifold* manifold);

}  // namespace sherd
