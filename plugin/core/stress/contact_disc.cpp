#include "core/stress/contact_disc.h"

#include <algorithm>
#include <cmath>

#include "core/stress/disc_potentials.h"

namespace sherd {

Vec3 ContactDisc::tractionAt(const Vec3& x) const {
    const Vec3 offset = x - centre;
    const double depth = offset.dot(inward);
    return contactProfile((offset.squaredNorm() - depth * depth) / (radius * radius)) * traction_pa;
}

namespace {

/// Of A^T local A, `axes` being A.
DiscField::Turning turningOf(const Mat3& axes) {
    constexpr int rows[6] = {0, 1, 2, 0, 1, 2}, columns[6] = {0, 1, 2, 1, 2, 0};
    DiscField::Turning turning;
    for (int i = 0; i < 6; ++i) {
        const Vec3 p = axes.col(rows[i]), q = axes.col(columns[i]);
        turning[i] = {p[0] * q[0],
                      p[1] * q[1],
                      p[2] * q[2],
                      p[0] * q[1] + p[1] * q[0],
                      p[1] * q[2] + p[2] * q[1],
                      p[2] * q[0] + p[0] * q[2]};
    }
    return turning;
}

}  // namespace

DiscField::DiscField(const ContactDisc& disc, double poisson_ratio)
    : centre_(disc.centre), hollow_(disc.hollow), traction_{poisson_ratio, 0, 0} {
    traction_.inward_pa = disc.traction_pa.dot(disc.inward);
    Vec3 along = disc.traction_pa - traction_.inward_pa * disc.inward;
    traction_.along_pa = along.norm();
    along = traction_.along_pa > 1e-12 * disc.traction_pa.norm() ? Vec3(along / traction_.along_pa)
                                                                 : Vec3(disc.inward.unitOrthogonal());
    axes_ << along.transpose(), disc.inward.cross(along).transpose(), disc.inward.transpose();
    axes_in_radii_ = axes_ / disc.radius;
    turning_ = turningOf(axes_);
}

Mat3 DiscField::stressAt(const Vec3& place) const {
    using namespace under_disc;
    const Vec3 local = axes_in_radii_ * (place - centre_);
    const double height = -local.z();
    if (!(height > on_plane)) return turned(behind(local.x(), local.y(), std::max(local.z(), 0.0)));
    // Much higher up is another part of the body, that the field says nothing of.
    const double steepness = height / std::max(1.0, local.norm());
    if (steepness >= too_steep) return Mat3::Zero();
    const double share = shareBefore(steepness);
    const Mat3 on = behind(local.x(), local.y(), 0);
    // A hollow surface rises above the plane. There the field goes on as straight as it came.
    return turned(share * (hollow_ ? Mat3(2 * on - behind(local.x(), local.y(), height)) : on));
}

Mat3 DiscField::turned(const Mat3& local) const {
    return axes_.transpose() * local * axes_;
}

Mat3 DiscField::behind(double x, double y, double z) const {
    using namespace under_disc;
    const double s = x * x + y * y;
    const auto angle_of = [](Complex a) { return std::atan2(a.im, a.re); };
    const Potentials h = s + z * z < far * far ? underDisc(s, z, angle_of) : underFarDisc(s, z);
    const LocalStress local = stressUnder(h, traction_, x, y, z);
    Mat3 stress;
    stress << local.xx, local.xy, local.zx, local.xy, local.yy, local.yz, local.zx, local.yz, local.zz;
    return stress;
}

}  // namespace sherd
