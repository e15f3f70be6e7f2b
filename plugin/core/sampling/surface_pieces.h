#pragma once

#include <sherd/triangle_mesh.h>

#include <array>
#include <functional>
#include <vector>

#include "core/sampling/polygon_clipping.h"
#include "core/sampling/sampling_grid.h"

namespace sherd {

/// The part of one triangle inside one voxel. Grid coordinates, relative to the voxel's centre.
struct SurfacePiece {
    int cut_voxel = -1;
    Vec3 area = Vec3::Zero();  ///< area times the outward unit normal
    Vec3 centroid = Vec3::Zero();
};

/// Integrals over all pieces of the surface in one voxel, coordinates (x, y, z) from its centre, n dA the
/// outward area: with them the divergence theorem gives the moments of the solid in the voxel and on its
/// faces.
struct SurfaceFlux {
    /// of n_x times x, x^2/2, xy, xz, x^3/3, x^2 y/2, x^2 z/2, x y^2, xyz, x z^2
    std::array<double, 10> volume{};
    /// face[d]: of n_d times 1, u, v with u = x[(d + 1) % 3], v = x[(d + 2) % 3], and for d = 0 also uu, uv,
    /// vv
    std::array<std::array<double, 6>, 3> face{};

    SurfaceFlux& operator+=(const SurfaceFlux& other);
};

/// A closed surface cut by the grid.
struct CutSurface {
    std::vector<long long> voxels;     ///< #cut voxels, index on the grid
    std::vector<SurfaceFlux> flux;     ///< #cut voxels
    std::vector<SurfacePiece> pieces;  ///< ordered by triangle
    std::vector<int> cut_voxel_at;     ///< #voxels of the grid: index of the cut voxel, or -1
};

/// Calls visit(voxel, polygon) for the part of every triangle inside every voxel of the grid, in the order of
/// the triangles from `first` to below `last`; polygons in grid coordinates.
void forEachVoxelPiece(const TriangleMesh& surface, int first, int last, const SamplingGrid& grid,
                       const std::function<void(const Eigen::Vector3i&, const Polygon&)>& visit);

CutSurface cutSurface(const TriangleMesh& surface, const SamplingGrid& grid);

}  // namespace sherd
