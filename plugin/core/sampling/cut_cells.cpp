#include "core/sampling/cut_cells.h"

#include "core/sampling/merge_small.h"

namespace sherd {
namespace {

// Of a voxel: smaller cells matter little to the stress and cost as much as the others.
constexpr double smallest_cell = 0.15;
constexpr double no_volume = 1e-12;  // of a voxel: rounding

std::vector<int> mergeVoxels(const SolidVoxels& solid) {
    std::vector<double> volumes(solid.moments.size());
    for (std::size_t v = 0; v < volumes.size(); ++v) volumes[v] = solid.moments[v].volume;
    std::vector<SharedFace> shared;
    shared.reserve(solid.faces.size());
    for (const VoxelFace& face : solid.faces) shared.push_back({{face.voxels[0], face.voxels[1]}, face.area});
    return mergeSmall(std::move(volumes), shared, smallest_cell);
}

/// From integrals about the middle of a voxel, in grid coordinates, to volume and centroid in metres.
Moments toWorld(const SamplingGrid& grid, const Vec3& centre, const RawMoments& raw) {
    const Vec3& edge = grid.cell_size;
    Moments moments;
    moments.volume = raw.volume * edge.prod();
    moments.centroid = grid.toWorld(centre + raw.first / raw.volume);
    const Mat3 second = raw.second - raw.first * raw.first.transpose() / raw.volume;
    moments.second = edge.prod() * (edge.asDiagonal() * second * edge.asDiagonal());
    return moments;
}

IntegrationFace toWorld(const SamplingGrid& grid, const VoxelFace& face, const Vec3& upper_voxel) {
    const int d = face.axis, e = (d + 1) % 3, f = (d + 2) % 3;
    Vec3 u = upper_voxel;
    u[e] += 0.5 + face.u;
    u[f] += 0.5 + face.v;
    IntegrationFace result;
    result.area[d] = face.area * grid.cell_size[e] * grid.cell_size[f];
    result.centroid = grid.toWorld(u);
    return result;
}

}  // namespace

CutCells mergeCells(const SamplingGrid& grid, const SolidVoxels& solid) {
    const int count = int(solid.index.size());
    const std::vector<int> root = mergeVoxels(solid);
    const auto position = [&](int voxel) {
        return grid.voxelAt(solid.index[std::size_t(voxel)]).cast<double>().eval();
    };

    std::vector<RawMoments> sums(solid.moments.size());
    for (int v = 0; v < count; ++v) {
        const int r = root[std::size_t(v)];
        const RawMoments& own = solid.moments[std::size_t(v)];
        sums[std::size_t(r)] += r == v ? own : own.shifted(position(v) - position(r));
    }
    CutCells cells;
    cells.moments.reserve(sums.size());
    cells.home_voxel.reserve(sums.size());
    std::vector<int> cell_of_root(sums.size(), -1);
    for (int v = 0; v < count; ++v) {
        if (root[std::size_t(v)] != v || sums[std::size_t(v)].volume < no_volume) continue;
        cell_of_root[std::size_t(v)] = int(cells.moments.size());
        cells.home_voxel.push_back(solid.index[std::size_t(v)]);
        cells.moments.push_back(toWorld(grid, position(v) + Vec3::Constant(0.5), sums[std::size_t(v)]));
    }
    cells.faces.reserve(solid.faces.size());
    cells.of_voxel.resize(std::size_t(count));
    for (int v = 0; v < count; ++v)
        cells.of_voxel[std::size_t(v)] = cell_of_root[std::size_t(root[std::size_t(v)])];
    for (const VoxelFace& face : solid.faces) {
        const int a = cells.of_voxel[std::size_t(face.voxels[0])],
                  b = cells.of_voxel[std::size_t(face.voxels[1])];
        if (a == b || a < 0 || b < 0) continue;
        cells.faces.push_back(toWorld(grid, face, position(face.voxels[1])));
        cells.faces.back().cells[0] = a;
        cells.faces.back().cells[1] = b;
    }
    return cells;
}

}  // namespace sherd
