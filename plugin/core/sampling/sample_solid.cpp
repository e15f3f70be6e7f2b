#include "core/sampling/sample_solid.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/numerics/parallel_chunks.h"
#include "core/sampling/cell_moments.h"
#include "core/sampling/cut_cells.h"
#include "core/sampling/sampling_grid.h"
#include "core/sampling/solid_voxels.h"
#include "core/sampling/sub_domains.h"
#include "core/sampling/surface_pieces.h"
#include "core/sampling/surface_points.h"

namespace sherd {
namespace {

Status checkInput(const TriangleMesh& surface, double spacing_m, const SamplingSettings& settings) {
    if (!(spacing_m > 0) || !std::isfinite(spacing_m))
        return Error{"The particle spacing must be a positive length in metres."};
    if (const Status valid = settings.validate(); !valid) return valid;
    if (surface.triangles.empty())
        return Error{"The surface has no triangles, so there is no solid to sample."};
    const int count = int(surface.vertices.size());
    for (const auto& triangle : surface.triangles)
        for (const int v : triangle) {
            if (v < 0 || v >= count)
                return Error{"A triangle of the surface names a vertex that does not exist."};
            if (!surface.vertices[std::size_t(v)].allFinite())
                return Error{"Vertex " + std::to_string(v) + " of the surface is not a finite point."};
        }
    return success();
}

void listVoxels(const SamplingGrid& grid, const SolidVoxels& solid, const CutCells& cells,
                Discretisation& result) {
    result.voxels.reserve(solid.index.size());
    for (std::size_t v = 0; v < solid.index.size(); ++v) {
        const double fill = std::min(1.0, solid.moments[v].volume);
        if (cells.of_voxel[v] >= 0 && fill > 1e-12)
            result.voxels.push_back({grid.voxelAt(solid.index[v]), cells.of_voxel[v], fill});
    }
}

void listCells(CutCells cells, const SubDomains& domains, Discretisation& result) {
    result.particle_cells.resize(std::size_t(domains.count));
    result.cells.resize(cells.moments.size());
    for (std::size_t c = 0; c < cells.moments.size(); ++c) {
        result.cells[c] = {cells.moments[c], domains.of_cell[c]};
        result.particle_cells[std::size_t(domains.of_cell[c])].push_back(int(c));
    }
    result.faces = std::move(cells.faces);
}

/// Integrals of n n^T over the surface of each particle.
std::vector<Mat3> facingOf(const Discretisation& solid) {
    std::vector<Mat3> facing(solid.particles.size(), Mat3::Zero());
    for (const SurfacePoint& point : solid.surface_points) {
        const double area = point.area.norm();
        if (area > 0) facing[solid.cells[point.cell].particle] += point.area * point.area.transpose() / area;
    }
    return facing;
}

Result<Discretisation> sample(const TriangleMesh& surface, double spacing_m, const SamplingSettings& settings,
                              MomentRule rule) {
    const Status checked = checkInput(surface, spacing_m, settings);
    if (!checked) return Error{checked.error()};
    const Result<SamplingGrid> made = makeGrid(surface, spacing_m, settings.cells_per_spacing);
    if (!made) return Error{made.error()};
    const SamplingGrid& grid = made.value();

    const CutSurface cut = cutSurface(surface, grid);
    const Result<SolidVoxels> filled = fillVoxels(grid, cut);
    if (!filled) return Error{filled.error()};
    const SolidVoxels& solid = filled.value();
    CutCells cells = mergeCells(grid, solid);
    if (cells.moments.empty())
        return Error{"The surface encloses no volume, so there is no solid to sample."};
    const SubDomains domains = findSubDomains(grid, cells, settings.smallest_fill);

    Discretisation result;
    result.spacing = spacing_m;
    result.surface = std::make_shared<const TriangleMesh>(surface);
    result.cell_size = grid.cell_size;
    result.grid_origin = grid.origin;
    const auto measure = [&] {
        if (settings.moment_order > 0)
            result.parts = measureCellParts(surface, grid, cut, solid, settings.moment_order, rule);
    };
    const auto placePoints = [&] {
        result.surface_points = surfacePoints(grid, cut, solid, cells);
        result.particles = placeParticles(grid, cells, domains);
        result.neighbours = neighboursThroughSolid(cells, domains);
    };
    forEachChunk(2, [&](int task) { task == 0 ? measure() : placePoints(); });
    listVoxels(grid, solid, cells, result);
    listCells(std::move(cells), domains, result);
    result.facing = facingOf(result);
    return result;
}

/// The error of a sampling that runs out of memory, in practice.
template <class Sampled, class Sample>
Result<Sampled> errorIfThrown(const Sample& sampling) {
    try {
        return sampling();
    } catch (const std::exception& trouble) {
        return Error{std::string("The solid could not be sampled (") + trouble.what() +
                     "); use a larger particle spacing."};
    }
}

}  // namespace

Result<CellParts> sampleParts(const TriangleMesh& surface, double spacing_m, int cells_per_spacing, int order,
                              MomentRule rule) {
    return errorIfThrown<CellParts>([&]() -> Result<CellParts> {
        const Result<SamplingGrid> grid = makeGrid(surface, spacing_m, cells_per_spacing);
        if (!grid) return Error{grid.error()};
        const CutSurface cut = cutSurface(surface, grid.value());
        const Result<SolidVoxels> solid = fillVoxels(grid.value(), cut);
        if (!solid) return Error{solid.error()};
        return measureCellParts(surface, grid.value(), cut, solid.value(), order, rule);
    });
}

Result<Discretisation> sampleSolid(const TriangleMesh& surface, double spacing_m,
                                   const SamplingSettings& settings, MomentRule rule) {
    return errorIfThrown<Discretisation>([&] { return sample(surface, spacing_m, settings, rule); });
}

}  // namespace sherd
