#include "core/mlpg/splines/high_stress.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/sampling/surface_quadrature.h"
#include "core/stress/principal_stresses.h"

namespace sherd {
namespace {

constexpr double high_tension = 0.4;  // of the peak, with its error

using Cube = std::array<int, 3>;  // z, y, x

Cube cubeOf(const CellParts& grid, double cells, const Vec3& x) {
    const Vec3 u = (x - grid.origin).cwiseQuotient(grid.edges) / cells;
    const Eigen::Vector3i cube = u.array().floor().cast<int>();
    return {cube.z(), cube.y(), cube.x()};
}

/// Which of 24 directions a vector points to: the axis of its largest component, and the signs of all.
int directionOf(const Vec3& vector) {
    int axis = 0;
    vector.cwiseAbs().maxCoeff(&axis);
    return 8 * axis + 4 * (vector.x() < 0) + 2 * (vector.y() < 0) + (vector.z() < 0);
}

}  // namespace

std::vector<SurfaceSample> surfaceSamples(const TriangleMesh& surface, const CellParts& grid) {
    std::map<std::pair<Cube, int>, SurfaceNode> largest;
    for (const SurfaceNode& node : surfaceQuadrature(surface, grid, 1)) {
        SurfaceNode& kept = largest[{cubeOf(grid, 0.5, node.position), directionOf(node.area)}];
        if (node.area.squaredNorm() > kept.area.squaredNorm()) kept = node;
    }
    std::vector<SurfaceSample> samples;
    for (const auto& [place, node] : largest)
        if (!node.area.isZero(0)) samples.push_back({node.position, node.area.normalized()});
    return samples;
}

std::vector<SampledStress> stressAtSamples(const SplineField& field, const Elasticity& elasticity,
                                           const std::vector<SurfaceSample>& all,
                                           const std::vector<int>& samples) {
    std::vector<SampledStress> stresses;
    for (const int s : samples) {
        const GridPoint place = locate(*field.parts, all[s].position);
        if (place.part < 0) continue;
        const Mat3 stress = elasticity.stress(gradientOn(field, place.part, place.xi));
        stresses.push_back(
            {s, principalStresses(toSymmetricTensor(stress)).largest, (stress * all[s].normal).norm()});
    }
    return stresses;
}

std::vector<HighStress> highStresses(const CellParts& grid, int cells_of_cube,
                                     const std::vector<SurfaceSample>& all,
                                     const std::vector<SampledStress>& stresses, double peak_pa,
                                     double error_share) {
    std::map<Cube, HighStress> cubes;
    for (const SampledStress& stress : stresses) {
        HighStress& high = cubes[cubeOf(grid, cells_of_cube, all[stress.sample].position)];
        high.samples.push_back(stress.sample);
        const double tension = stress.tension_pa + stress.error_pa;
        if (tension > high_tension * peak_pa && stress.error_pa > error_share * peak_pa)
            high.rank = std::max(high.rank, tension * stress.error_pa);
    }
    std::vector<HighStress> found;
    for (auto& [cube, high] : cubes) {
        if (!(high.rank > 0)) continue;
        const Eigen::Vector3i lower = cells_of_cube * Eigen::Vector3i(cube[2], cube[1], cube[0]);
        high.cells = {lower, lower + Eigen::Vector3i::Constant(cells_of_cube)};
        found.push_back(std::move(high));
    }
    return found;
}

}  // namespace sherd
