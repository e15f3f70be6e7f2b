#include "core/stress/stress_lanes.h"

#include "core/stress/principal_bound.h"

namespace sherd {

namespace {

constexpr int lane_count = PlaceLanes::count;

SHERD_WIDE_VECTORS
void stressOfLanes(double lambda, double mu, const PlaceLanes::Lane (*g)[3], PlaceLanes::Lane* stress) {
    for (int l = 0; l < lane_count; ++l) {
        const double xx = g[0][0][l], yy = g[1][1][l], zz = g[2][2][l], xy = g[0][1][l] + g[1][0][l],
                     yz = g[1][2][l] + g[2][1][l], zx = g[2][0][l] + g[0][2][l];
        const double equal = lambda * (xx + (yy + zz));
        stress[0][l] = equal + mu * (xx + xx);
        stress[1][l] = equal + mu * (yy + yy);
        stress[2][l] = equal + mu * (zz + zz);
        stress[3][l] = mu * xy;
        stress[4][l] = mu * yz;
        stress[5][l] = mu * zx;
    }
}

/// With v = raw n - t_t, in components:
///     sigma = raw - n v^T - v n^T + (raw_nn + t_n - c) n n^T + c I, c = nu / (1 - nu) (t_n - raw_nn).
SHERD_WIDE_VECTORS
void applyTractionInLanes(const SurfaceLanes& surface, double coupling, StressLanes& stress) {
    for (int l = 0; l < lane_count; ++l) {
        const double a = surface.normal[0][l], b = surface.normal[1][l], c = surface.normal[2][l];
        const double size = std::sqrt(a * a + b * b + c * c), per_size = size > 0 ? 1 / size : 0;
        const double x = a * per_size, y = b * per_size, z = c * per_size;
        const double t = surface.traction_pa[0][l], u = surface.traction_pa[1][l],
                     w = surface.traction_pa[2][l];
        const double along = t * x + u * y + w * z;
        const double xx = stress.s[0][l], yy = stress.s[1][l], zz = stress.s[2][l], xy = stress.s[3][l],
                     yz = stress.s[4][l], zx = stress.s[5][l];
        const double on_x = xx * x + xy * y + zx * z, on_y = xy * x + yy * y + yz * z,
                     on_z = zx * x + yz * y + zz * z;
        const double outward = on_x * x + on_y * y + on_z * z;
        const double v = on_x - (t - along * x), p = on_y - (u - along * y), q = on_z - (w - along * z);
        const double within = coupling * (along - outward), both = outward + along - within;
        const bool known = surface.is_known[l] > 0;
        stress.s[0][l] = known ? xx - 2 * x * v + both * x * x + within : xx;
        stress.s[1][l] = known ? yy - 2 * y * p + both * y * y + within : yy;
        stress.s[2][l] = known ? zz - 2 * z * q + both * z * z + within : zz;
        stress.s[3][l] = known ? xy - (x * p + v * y) + both * x * y : xy;
        stress.s[4][l] = known ? yz - (y * q + p * z) + both * y * z : yz;
        stress.s[5][l] = known ? zx - (z * v + q * x) + both * z * x : zx;
    }
}

SHERD_WIDE_VECTORS
void boundLanes(const StressLanes& stress, PlaceLanes::Lane& smallest, PlaceLanes::Lane& largest) {
    constexpr double rounding = 1e-12;
    for (int l = 0; l < lane_count; ++l)
        boundPrincipal(stress.s[0][l], stress.s[1][l], stress.s[2][l], stress.s[3][l], stress.s[4][l],
                       stress.s[5][l], rounding, smallest[l], largest[l]);
}

}  // namespace

void stressOf(const Elasticity& elasticity, const PlaceLanes::Lane (&gradient)[3][3], StressLanes& stress) {
    stressOfLanes(elasticity.lambda_pa, elasticity.mu_pa, gradient, stress.s);
}

void applyTraction(const SurfaceLanes& surface, const Elasticity& elasticity, StressLanes& stress) {
    applyTractionInLanes(surface, elasticity.lambda_pa / (elasticity.lambda_pa + 2 * elasticity.mu_pa),
                         stress);
}

void boundPrincipal(const StressLanes& stress, PlaceLanes::Lane& smallest_pa, PlaceLanes::Lane& largest_pa) {
    boundLanes(stress, smallest_pa, largest_pa);
}

}  // namespace sherd
