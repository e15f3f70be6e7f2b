#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <algorithm>

namespace sherd {

/// The integration grid over a solid's bounding box. In grid coordinates u = (x - origin) / cell_size every
/// plane of the grid is an integer, so that cutting compares with exact numbers. A point on a plane counts as
/// above it.
struct SamplingGrid {
    Vec3 origin = Vec3::Zero();     ///< lower corner of voxel (0, 0, 0), m
    Vec3 cell_size = Vec3::Zero();  ///< edges of a voxel, m
    Eigen::Vector3i count =
        Eigen::Vector3i::Zero();  ///< voxels; includes an empty layer on top for points on the top plane
    Eigen::Vector3i particle_cells = Eigen::Vector3i::Zero();  ///< cells of `cells_per_spacing`^3 voxels
    int cells_per_spacing = 1;
    /// False: the grid covers the whole solid. True: along x it does, along y and z only a range of rows.
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

    /// Index of the particle cell that a voxel lies in: x fastest, z slowest.
    long long particleCellOf(const Eigen::Vector3i& voxel) const;
};

/// Lays particle cells of edge `spacing_m` over the surface's bounding box and splits each into
/// `cells_per_spacing`^3 voxels. Along each axis the cells are stretched or shrunk by up to 35 % so that a
/// whole number of them fits the box; where that is not enough they are centred on it. Fails with a sentence
/// when the grid would be too large, naming a spacing that would do.
Result<SamplingGrid> makeGrid(const TriangleMesh& surface, double spacing_m, int cells_per_spacing);

}  // namespace sherd
