#include <algorithm>

#include "core/numerics/arc_tangent.h"
#include "core/stress/disc_potentials.h"

namespace sherd {

namespace {

constexpr int lane_count = PlaceLanes::count;
using Lane = PlaceLanes::Lane;

/// Coordinates on the axes of a disc, in radii.
struct LocalLanes {
    Lane x, y, depth;  ///< depth 0 before the plane
    Lane height;       ///< before the plane, else 0
    Lane share;        ///< of the field that counts there
};

SHERD_WIDE_VECTORS
void toLocal(const PlaceLanes& at, const Vec3& centre, const Mat3& axes, double radius, LocalLanes& local) {
    // Copies, which what is written cannot change.
    const double c[3] = {centre[0], centre[1], centre[2]};
    double a[9];
    std::copy_n(axes.data(), 9, a);  // column by column
    for (int l = 0; l < lane_count; ++l) {
        const double u = at.x[0][l] - c[0], v = at.x[1][l] - c[1], w = at.x[2][l] - c[2];
        const double x = (a[0] * u + a[3] * v + a[6] * w) / radius;
        const double y = (a[1] * u + a[4] * v + a[7] * w) / radius;
        const double z = (a[2] * u + a[5] * v + a[8] * w) / radius;
        const double distance = std::sqrt(x * x + y * y + z * z);
        const bool is_before = -z > under_disc::on_plane;
        const double share = under_disc::shareBefore(-z / (distance > 1 ? distance : 1));
        local.x[l] = x;
        local.y[l] = y;
        local.depth[l] = z > 0 ? z : 0;
        local.height[l] = is_before ? -z : 0;
        local.share[l] = is_before ? share : 1;
    }
}

SHERD_INLINED under_disc::Potentials either(bool first, const under_disc::Potentials& a,
                                            const under_disc::Potentials& b) {
    under_disc::Potentials h;
    h.h_m2 = first ? a.h_m2 : b.h_m2;
    h.h_m1 = first ? a.h_m1 : b.h_m1;
    h.d_m1 = first ? a.d_m1 : b.d_m1;
    h.d_0 = first ? a.d_0 : b.d_0;
    h.dd_0 = first ? a.dd_0 : b.dd_0;
    h.d_1 = first ? a.d_1 : b.d_1;
    h.dd_1 = first ? a.dd_1 : b.dd_1;
    h.ddd_1 = first ? a.ddd_1 : b.ddd_1;
    h.dd_2 = first ? a.dd_2 : b.dd_2;
    h.ddd_2 = first ? a.ddd_2 : b.ddd_2;
    return h;
}

SHERD_INLINED void putInLane(const under_disc::LocalStress& local, int lane, Lane* stress) {
    stress[0][lane] = local.xx;
    stress[1][lane] = local.yy;
    stress[2][lane] = local.zz;
    stress[3][lane] = local.xy;
    stress[4][lane] = local.yz;
    stress[5][lane] = local.zx;
}

SHERD_INLINED double squaredDistance(const LocalLanes& at, const Lane& depth, int lane) {
    return at.x[lane] * at.x[lane] + at.y[lane] * at.y[lane] + depth[lane] * depth[lane];
}

/// Where all lanes are so far away that the disc is hardly more than a point.
SHERD_WIDE_VECTORS
void stressFarBehind(const LocalLanes& at, const Lane& depth, const DiscField::Traction& of, Lane* stress) {
    const DiscField::Traction traction = of;
    for (int l = 0; l < lane_count; ++l) {
        const double x = at.x[l], y = at.y[l], z = depth[l];
        putInLane(under_disc::stressUnder(under_disc::underFarDisc(x * x + y * y, z), traction, x, y, z), l,
                  stress);
    }
}

SHERD_WIDE_VECTORS
void stressAnywhereBehind(const LocalLanes& at, const Lane& depth, const DiscField::Traction& of,
                          Lane* stress) {
    using namespace under_disc;
    const DiscField::Traction traction = of;
    for (int l = 0; l < lane_count; ++l) {
        const double x = at.x[l], y = at.y[l], z = depth[l], s = x * x + y * y;
        const auto angle_of = [](Complex a) { return pi / 2 - arcTangent(a.re / a.im); };
        const bool is_close = squaredDistance(at, depth, l) < far * far;
        const Potentials h = either(is_close, underDisc(s, z, angle_of), underFarDisc(s, z));
        putInLane(stressUnder(h, traction, x, y, z), l, stress);
    }
}

void stressBehind(const LocalLanes& at, const Lane& depth, const DiscField::Traction& of, Lane* stress) {
    bool any_close = false;
    for (int l = 0; l < lane_count; ++l)
        any_close |= squaredDistance(at, depth, l) < under_disc::far * under_disc::far;
    any_close ? stressAnywhereBehind(at, depth, of, stress) : stressFarBehind(at, depth, of, stress);
}

/// Adds A^T local A times the share of each place.
SHERD_WIDE_VECTORS
void addTurned(const Lane* local, const Lane& share, const Mat3& axes, StressLanes& sum) {
    const double* a = axes.data();
    for (int i = 0; i < 6; ++i) {
        constexpr int rows[6] = {0, 1, 2, 0, 1, 2}, columns[6] = {0, 1, 2, 1, 2, 0};
        const double *p = a + 3 * rows[i], *q = a + 3 * columns[i];
        const double factors[6] = {p[0] * q[0],
                                   p[1] * q[1],
                                   p[2] * q[2],
                                   p[0] * q[1] + p[1] * q[0],
                                   p[1] * q[2] + p[2] * q[1],
                                   p[2] * q[0] + p[0] * q[2]};
        Lane turned;
        for (int l = 0; l < lane_count; ++l)
            turned[l] = factors[0] * local[0][l] + factors[1] * local[1][l] + factors[2] * local[2][l] +
                        factors[3] * local[3][l] + factors[4] * local[4][l] + factors[5] * local[5][l];
        for (int l = 0; l < lane_count; ++l) sum.s[i][l] += share[l] * turned[l];
    }
}

}  // namespace

void DiscField::addStressAt(const PlaceLanes& at, StressLanes& sum) const {
    LocalLanes local;
    toLocal(at, centre_, axes_, radius_, local);
    const auto is_positive = [](double value) { return value > 0; };
    if (std::none_of(local.share, local.share + lane_count, is_positive)) return;
    Lane stress[6];
    stressBehind(local, local.depth, traction_, stress);
    if (hollow_ && std::any_of(local.height, local.height + lane_count, is_positive)) {
        Lane mirrored[6];
        stressBehind(local, local.height, traction_, mirrored);
        for (int i = 0; i < 6; ++i)
            for (int l = 0; l < lane_count; ++l)
                if (local.height[l] > 0) stress[i][l] = 2 * stress[i][l] - mirrored[i][l];
    }
    addTurned(stress, local.share, axes_, sum);
}

}  // namespace sherd
