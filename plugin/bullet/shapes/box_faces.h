#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransform.h>

#include <memory>

namespace sherd {

/// A manifold of a hull and a box whose normals are those of the box's faces: those that Bullet finds (GJK,
/// EPA) are off by up to half a degree, and where the hull has come deep into the box now and then by 30.
/// Points at edges of the box are left as they are. nullptr: all of them are so already. `stood_a` and
/// `stood_b`: where the bodies were when Bullet found the points.
std::unique_ptr<btPersistentManifold> onBoxFaces(const btPersistentManifold& manifold,
                                                 const btTransform& stood_a, const btTransform& stood_b);

}  // namespace sherd
