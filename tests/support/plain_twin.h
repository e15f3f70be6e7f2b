#pragma once

#include <memory>

#include "bullet/shapes/rigid_body_factory.h"

namespace sherd {

/// A body of Bullet's alone with the mass and the collision shape that Sherd would give it, at the origin.
inline OwnedBody plainTwin(const BreakableSolid& solid, const ShapeChoice& shape) {
    const btTransform frame = principalFrame(solid.moments()).body_from_asset;
    return makeRigidBody(solid, std::make_shared<OwnedShape>(makeShape(solid, shape, {}, frame)), 1);
}

}  // namespace sherd
