#pragma once

#include <LinearMath/btTransform.h>

#include "render/types.h"

namespace demo {

inline btVector3 toBullet(const render::Vec3& v) {
    return btVector3(v.x(), v.y(), v.z());
}

inline render::Vec3 toRender(const btVector3& v) {
    return render::Vec3(v.x(), v.y(), v.z());
}

inline render::Mat4 toRender(const btTransform& transform) {
    render::Mat4 matrix;
    transform.getOpenGLMatrix(matrix.data());
    return matrix;
}

}  // namespace demo
