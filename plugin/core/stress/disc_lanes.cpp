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
};

SHERD_WIDE_VECTORS
void toLocal(const PlaceLanes& at, const Vec3& centre, const Mat3& axes_in_radii, LocalLanes& local) {
    // Copies, which what is written cannot change.
    const double c[3] = {centre[0], centre[1], centre[2]};
    double a[9];
    std::copy_n(axes_in_radii.data(), 9, a);  // column by column
    for (int l = 0; l < lane_count; ++l) {
        const double u = at.x[0][l] - c[0], v = at.x[1][l] - c[1], w = at.x[2][l] - c[2];
        const double z = a[2] * u + a[5] * v + a[8] * w;
        local.x[l] = a[0] * u + a[3] * v + a[6] * w;
        local.y[l] = a[1] * u + a[4] * v + a[7] * w;
        local.depth[l] = z > 0 ? z : 0;
        local.height[l] = -z > under_disc::on_plane ? -z : 0;
    }
}

/// What of the field counts before the plane. Takes longer than `toLocal`, and most places are behind it.
SHERD_WIDE_VECTORS
void sharesBefore(const LocalLanes& at, Lane& share) {
    for (int l = 0; l < lane_count; ++l) {
        const double x = at.x[l], y = at.y[l], height = at.height[l];
        const double distance = std::sqrt(x * x + y * y + height * height);
        share[l] = height > 0 ? under_disc::shareBefore(height / (distance > 1 ? distance : 1)) : 1;
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

SHERD_WIDE_VECTORS
bool anyIsClose(const LocalLanes& at, const Lane& depth) {
    long long any = 0;
    for (int l = 0; l < lane_count; ++l)
        any |= squaredDistance(at, depth, l) < under_disc::far * under_disc::far;
    return any != 0;
}

void stressBehind(const LocalLanes& at, const Lane& depth, const DiscField::Traction& of, Lane* stress) {
    anyIsClose(at, depth) ? stressAnywhereBehind(at, depth, of, stress)
                          : stressFarBehind(at, depth, of, stress);
}

SHERD_WIDE_VECTORS
void multiply(const Lane& share, Lane* stress) {
    for (int i = 0; i < 6; ++i)
        for (int l = 0; l < lane_count; ++l) stress[i][l] *= share[l];
}

/// Adds a stress on the axes of the disc.
SHERD_WIDE_VECTORS
void addTurned(const DiscField::Turning& turning, const Lane* local, StressLanes& sum) {
    for (int i = 0; i < 6; ++i) {
        const double* factors = turning[i].data();
        Lane turned;
        for (int l = 0; l < lane_count; ++l)
            turned[l] = factors[0] * local[0][l] + factors[1] * local[1][l] + factors[2] * local[2][l] +
                        factors[3] * local[3][l] + factors[4] * local[4][l] + factors[5] * local[5][l];
        for (int l = 0; l < lane_count; ++l) sum.s[i][l] += turned[l];
    }
}

SHERD_WIDE_VECTORS
bool anyIsPositive(const Lane& lane) {
    long long any = 0;
    for (int l = 0; l < lane_count; ++l) any |= lane[l] > 0;
    return any != 0;
}

}  // namespace

void DiscField::addStressAt(const PlaceLanes& at, StressLanes& sum) const {
    LocalLanes local;
    toLocal(at, centre_, axes_in_radii_, local);
    const bool any_before = anyIsPositive(local.height);
    Lane share;
    if (any_before) {
        sharesBefore(local, share);
        if (!anyIsPositive(share)) return;
    }
    Lane stress[6];
    stressBehind(local, local.depth, traction_, stress);
    if (hollow_ && any_before) {
        Lane mirrored[6];
        stressBehind(local, local.height, traction_, mirrored);
        for (int i = 0; i < 6; ++i)
            for (int l = 0; l < lane_count; ++l)
                if (local.height[l] > 0) stress[i][l] = 2 * stress[i][l] - mirrored[i][l];
    }
    if (any_before) multiply(share, stress);
    addTurned(turning_, stress, sum);
}

}  // namespace sherd
