#pragma once

#include <LinearMath/btTransform.h>
#include <sherd/types.h>

namespace sherd {

inline Vec3 fromBullet(const btVector3& v) {
    return Vec3(v.x(), v.y(), v.z());
}

inline bool isFinite(const btVector3& v) {
    return fromBullet(v).allFinite();
}

inline btVector3 toBullet(const Vec3& v) {
    return btVector3(static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()),
                     static_cast<btScalar>(v.z()));
}

inline Mat3 fromBullet(const btMatrix3x3& m) {
    Mat3 result;
    for (int row = 0; row < 3; ++row) result.row(row) = fromBullet(m.getRow(row)).transpose();
    return result;
}

inline btMatrix3x3 toBullet(const Mat3& m) {
    btMatrix3x3 result;
    for (int row = 0; row < 3; ++row) result[row] = toBullet(Vec3(m.row(row)));
    return result;
}

}  // namespace sherd
