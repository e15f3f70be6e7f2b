#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

namespace sherd {

/// For what an object's anisotropic friction counts, as `setAnisotropicFriction` takes it.
inline int anisotropicFrictionMode(const btCollisionObject& object) {
    int mode = btCollisionObject::CF_ANISOTROPIC_FRICTION_DISABLED;
    for (const int flag : {int(btCollisionObject::CF_ANISOTROPIC_FRICTION),
                           int(btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION)})
        if (object.hasAnisotropicFriction(flag)) mode |= flag;
    return mode;
}

}  // namespace sherd
