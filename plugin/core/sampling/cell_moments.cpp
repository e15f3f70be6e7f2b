#include "core/sampling/cell_moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/numerics/parallel_chunks.h"
#include "core/numerics/union_find.h"
#include "core/sampling/neighbour_lists.h"
#include "core/sampling/sliver_links.h"
#include "core/sampling/voxel_moments.h"
#include "core/sampling/voxel_points.h"

namespace sherd {
namespace {

constexpr double smallest_part = 1e-10;  // of a cell: less is rounding
constexpr double smallest_face = 1e-9;   // of a voxel face: parts that share less do not touch
constexpr double no_difference = 1e-13;  // of a cell's fill from 1: rounding
constexpr int chunk_count = 16;

/// The solid's voxels by the parts of cells that they make. The lowest voxel of a part is its root.
struct VoxelGroups {
    std::vector<int> root;                  // #voxels
    std::vector<std::vector<int>> members;  // #voxels, empty but at roots
    std::vector<int> wanted;                // the roots in the wanted columns, ascending by cell
};

/// Cells without parts.
CellParts emptyCells(const SamplingGrid& grid, int order) {
    const int per_cell = grid.cells_per_spacing;
    CellParts cells;
    cells.origin = grid.origin;
    cells.edges = grid.cell_size * per_cell;
    // The layer of voxels on the top planes has cells of its own, so that every point of the surface lies in
    // a cell.
    cells.count = (grid.count + Eigen::Vector3i::Constant(per_cell - 1)) / per_cell;
    cells.voxels_per_cell = per_cell;
    cells.order = order;
    return cells;
}

/// Groups voxels of the same cell that are connected through faces.
VoxelGroups groupVoxels(const SamplingGrid& grid, const SolidVoxels& solid, const CellParts& cells,
                        const CellColumns& columns) {
    const int voxel_count = static_cast<int>(solid.index.size());
    std::vector<int> cell_of(voxel_count);
    for (int v = 0; v < voxel_count; ++v)
        cell_of[v] = cells.cellIndex(grid.voxelAt(solid.index[v]) / grid.cells_per_spacing);
    UnionFind sets(voxel_count);
    for (const VoxelFace& face : solid.faces)
        if (face.area >= smallest_face && cell_of[face.voxels[0]] == cell_of[face.voxels[1]])
            sets.unite(face.voxels[0], face.voxels[1]);

    VoxelGroups groups;
    groups.root = sets.roots();
    groups.members.resize(voxel_count);
    for (int v = 0; v < voxel_count; ++v) groups.members[groups.root[v]].push_back(v);
    for (int v = 0; v < voxel_count; ++v) {
        const int column = grid.voxelAt(solid.index[v]).x() / grid.cells_per_spacing;
        if (groups.root[v] == v && column >= columns.first && column < columns.last)
            groups.wanted.push_back(v);
    }
    std::stable_sort(groups.wanted.begin(), groups.wanted.end(),
                     [&](int a, int b) { return cell_of[a] < cell_of[b]; });
    return groups;
}

/// The part that some voxels make; `add(voxel, position, sum)` adds the moments of one.
template <class Add>
CellPart measurePart(const SamplingGrid& grid, const SolidVoxels& solid, const std::vector<int>& voxels,
                     const VoxelMoments& moments, const Add& add, int order) {
    const int per_cell = grid.cells_per_spacing, n = order + 1;
    CellPart part;
    part.cell = grid.voxelAt(solid.index[voxels[0]]) / per_cell;
    part.fill = 1;
    if (static_cast<int>(voxels.size()) == per_cell * per_cell * per_cell &&
        std::all_of(voxels.begin(), voxels.end(), [&](int v) { return moments.isWhole(v); }))
        return part;
    part.moments.assign(n * n * n, 0.0);
    for (const int v : voxels) {
        const Eigen::Vector3i position = grid.voxelAt(solid.index[v]);
        add(v, position, part.moments);
        part.voxels.push_back(position);
    }
    part.fill = part.moments[0];
    if (std::abs(part.fill - 1) > no_difference) return part;
    part.moments.clear();  // the surface only lies on the cell's border
    part.fill = 1;
    return part;
}

/// The same without moments, from the volumes of the voxels.
CellPart fillPart(const SamplingGrid& grid, const SolidVoxels& solid, const std::vector<int>& voxels) {
    const int per_cell = grid.cells_per_spacing;
    CellPart part;
    part.cell = grid.voxelAt(solid.index[voxels[0]]) / per_cell;
    for (const int v : voxels) {
        part.fill += solid.moments[v].volume / (per_cell * per_cell * per_cell);
        part.voxels.push_back(grid.voxelAt(solid.index[v]));
    }
    return part;
}

/// Lists the parts by cell, those of no volume left out, and returns which part each wanted root became, or
/// -1; #voxels.
std::vector<int> listParts(const VoxelGroups& groups, std::vector<CellPart> parts, CellParts& cells) {
    std::vector<int> part_of_root(groups.root.size(), -1);
    cells.first_part.assign(cells.count.prod() + 1, 0);
    for (size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].fill < smallest_part) continue;
        part_of_root[groups.wanted[p]] = static_cast<int>(cells.parts.size());
        ++cells.first_part[cells.cellIndex(parts[p].cell) + 1];
        cells.parts.push_back(std::move(parts[p]));
    }
    std::partial_sum(cells.first_part.begin(), cells.first_part.end(), cells.first_part.begin());
    for (CellPart& part : cells.parts) {
        const int cell = cells.cellIndex(part.cell);
        if (cells.first_part[cell + 1] - cells.first_part[cell] == 1) part.voxels.clear();
    }
    return part_of_root;
}

std::vector<CellPart> measureParts(const TriangleMesh& surface, const SamplingGrid& grid,
                                   const CutSurface& cut, const SolidVoxels& solid, int order,
                                   MomentRule rule, const CellColumns& columns, const VoxelGroups& groups) {
    const bool exact = rule == MomentRule::exact;
    const VoxelMoments moments =
        exact ? VoxelMoments(grid, cut, solid, momentFlux(surface, grid, cut, columns, order), order)
              : VoxelMoments(grid, cut, solid, order);
    const auto add = [&](int voxel, const Eigen::Vector3i& position, std::vector<double>& sum) {
        const int per_cell = grid.cells_per_spacing;
        if (exact || moments.isWhole(voxel)) return moments.addTo(voxel, position, sum);
        const Eigen::Vector3i local = position - position / per_cell * per_cell;
        addVoxelPoints(solid.moments[voxel], local, per_cell, order, sum);
    };
    std::vector<CellPart> parts(groups.wanted.size());
    forEachChunk(chunk_count, [&](int chunk) {
        const int total = static_cast<int>(parts.size());
        const int end = chunkBegin(chunk + 1, chunk_count, total);
        for (int p = chunkBegin(chunk, chunk_count, total); p < end; ++p)
            parts[p] = measurePart(grid, solid, groups.members[groups.wanted[p]], moments, add, order);
    });
    return parts;
}

CellParts measureColumns(const TriangleMesh& surface, const SamplingGrid& grid, const CutSurface& cut,
                         const SolidVoxels& solid, int order, MomentRule rule, const CellColumns& columns) {
    CellParts cells = emptyCells(grid, order);
    const VoxelGroups groups = groupVoxels(grid, solid, cells, columns);
    std::vector<CellPart> parts;
    if (order == 0)
        for (const int root : groups.wanted) parts.push_back(fillPart(grid, solid, groups.members[root]));
    else
        parts = measureParts(surface, grid, cut, solid, order, rule, columns, groups);
    const std::vector<int> part_of_root = listParts(groups, std::move(parts), cells);
    std::vector<std::array<int, 2>> links;
    for (const VoxelFace& face : solid.faces) {
        if (face.area < smallest_face) continue;
        const int a = part_of_root[groups.root[face.voxels[0]]],
                  b = part_of_root[groups.root[face.voxels[1]]];
        if (a >= 0 && b >= 0 && a != b) links.push_back({a, b});
    }
    const std::vector<std::array<int, 2>> slivers = sliverLinks(cells, links);
    links.insert(links.end(), slivers.begin(), slivers.end());
    cells.neighbours = neighbourLists(cells.parts.size(), links);
    return cells;
}

}  // namespace

CellParts measureCellParts(const TriangleMesh& surface, const SamplingGrid& grid, const CutSurface& cut,
                           const SolidVoxels& solid, int order, MomentRule rule) {
    return measureColumns(surface, grid, cut, solid, order, rule, {0, grid.count.x()});
}

Result<CellParts> refineCellParts(const TriangleMesh& surface, const CellParts& coarse,
                                  const Eigen::Vector3i& lower, const Eigen::Vector3i& upper) {
    constexpr int voxels_per_cell = 2;
    SamplingGrid grid;
    grid.window = true;
    grid.cells_per_spacing = voxels_per_cell;
    grid.cell_size = coarse.edges / (2 * voxels_per_cell);
    const int first = std::min(0, lower.x()), last = std::max(coarse.count.x(), upper.x());
    const Eigen::Vector3i corner(first, lower.y(), lower.z());
    grid.origin = coarse.origin + corner.cast<double>().cwiseProduct(coarse.edges);
    grid.particle_cells = 2 * Eigen::Vector3i(last - first, upper.y() - lower.y(), upper.z() - lower.z());
    grid.count = voxels_per_cell * grid.particle_cells + Eigen::Vector3i::UnitX();
    const CutSurface cut = cutSurface(surface, grid);
    const Result<SolidVoxels> solid = fillVoxels(grid, cut);
    if (!solid) return Error{solid.error()};
    return measureColumns(surface, grid, cut, solid.value(), coarse.order, MomentRule::exact,
                          {2 * (lower.x() - first), 2 * (upper.x() - first)});
}

}  // namespace sherd
