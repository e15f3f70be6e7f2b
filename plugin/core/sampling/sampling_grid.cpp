#include "core/sampling/sampling_grid.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/numerics/mesh_measures.h"

namespace sherd {
namespace {

constexpr double largest_grid = 30e6;     // voxels, filled or empty: 4 bytes each
constexpr double largest_solid = 3e6;     // filled voxels: some 500 bytes each with their faces
constexpr double largest_stretch = 0.35;  // change of a cell's edge, relative, to fit the bounding box

std::string describe(double value) {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

/// Number of particle cells along one axis, and their edge.
std::pair<double, double> fitCells(double extent, double spacing) {
    const double count = std::max(1.0, std::round(extent / spacing));
    const double edge = extent / count;
    if (std::abs(edge - spacing) <= largest_stretch * spacing) return {count, edge};
    return {std::max(1.0, std::ceil(extent / spacing)), spacing};
}

Error tooLarge(double voxels, double limit, double spacing, const char* what) {
    const double enough = spacing * std::cbrt(voxels / limit) * 1.05;
    return {"The particle spacing of " + describe(spacing) + " m needs " + describe(voxels) + " " + what +
            ", more than the limit of " + describe(limit) + "; use a spacing of at least " +
            describe(enough) + " m."};
}

}  // namespace

long long SamplingGrid::particleCellOf(const Eigen::Vector3i& voxel) const {
    // The empty layer on top has no particle cells of its own.
    const Eigen::Vector3i cell =
        (voxel / cells_per_spacing).cwiseMin(particle_cells - Eigen::Vector3i::Ones());
    return (1LL * cell.z() * particle_cells.y() + cell.y()) * particle_cells.x() + cell.x();
}

Result<SamplingGrid> makeGrid(const TriangleMesh& surface, double spacing_m, int cells_per_spacing) {
    Vec3 lower = surface.vertices.at(surface.triangles[0][0]), upper = lower;
    for (const auto& triangle : surface.triangles)
        for (const int v : triangle) {
            lower = lower.cwiseMin(surface.vertices[v]);
            upper = upper.cwiseMax(surface.vertices[v]);
        }
    SamplingGrid grid;
    grid.cells_per_spacing = cells_per_spacing;
    double voxels = 1;
    std::array<double, 3> cells;
    for (int d = 0; d < 3; ++d) {
        const auto [count, edge] = fitCells(upper[d] - lower[d], spacing_m);
        cells[d] = count;
        grid.cell_size[d] = edge / cells_per_spacing;
        grid.origin[d] = lower[d] - (count * edge - (upper[d] - lower[d])) / 2;
        voxels *= count * cells_per_spacing + 1;
    }
    if (!(voxels <= largest_grid))
        return tooLarge(voxels, largest_grid, spacing_m, "grid cells over its bounding box");
    const double filled =
        enclosedVolume(surface.vertices, surface.triangles, (lower + upper) / 2) / grid.voxelVolume();
    if (filled > largest_solid)
        return tooLarge(filled, largest_solid, spacing_m, "grid cells inside the solid");
    for (int d = 0; d < 3; ++d) {
        grid.particle_cells[d] = int(cells[d]);
        grid.count[d] = grid.particle_cells[d] * cells_per_spacing + 1;
    }
    return grid;
}

}  // namespace sherd
