#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <algorithm>

namespace sherd {

/// The integration grid over a solid's bounding box. Grid coordinates u = (x - origin) / cell_size make every
/// plane of the grid an integer, so that cutting compares with exact numbers. A coordinate on a plane counts
/// as above it.
struct SamplingGrid {
    Vec3 origin = Vec3::Zero();     ///< lower corner of voxel (0, 0, 0), m
    Vec3 cell_size = Vec3::Zero();  ///< edges of a voxel, m
    Eigen::Vector3i count =
        Eigen::Vector3i::Zero();  ///< voxels, with one empty layer above for what lies on the top plane
    Eigen::Vector3i particle_cells = Eigen::Vector3i::Zero();  ///< cells of `cells_per_spacing`^3 voxels
    int cells_per_spacing = 1;
    /// Whether the grid covers the whole solid, or all of it along x but only a range of rows along y and z.
    bool window = false;

    double voxelVolume() const { return cell_size.prod(); }
    long long voxelCount() const { return 1LL * count.x() * count.y() * count.z(); }
    long long indexOf(const Eigen::Vector3i& v) const {
        return (1LL * v.z() * count.y() + v.y()) * count.x() + v.x();
    }
    Eigen::Vector3i voxelAt(long long index) const {
        return {int(index % count.x()), int(index / count.x() % count.y()),
                int(index / count.x() / count.y())};
    }
    Vec3 toGrid(const Vec3& x) const {
        const Vec3 u = (x - origin).cwiseQuotient(cell_size);
        return window ? Vec3(std::max(0.0, u.x()), u.y(), u.z()) : Vec3(u.cwiseMax(0.0));
    }
    Vec3 toWorld(const Vec3& u) const { return origin + u.cwiseProduct(cell_size); }

    /// Index of the particle cell that a voxel lies in, ascending in (z, y, x).
    long long particleCellOf(const Eigen::Vector3i& voxel) const;
};

/// Lays particle cells of edge `spacing_m` over the surface's bounding box and splits each into
/// `cells_per_spacing`^3 voxels. Where the box takes a whole number of cells to within 15 % they are
/// stretched to fit it, else they are centred on it. Fails with a sentence when the grid would be too large,
/// naming a spacing that would do.
Result<SamplingGrid> makeGrid(const TriangleMesh& surface, double spacing_m, int cells_per_spacing);

}  // namespace sherd
