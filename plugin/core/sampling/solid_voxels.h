#pragma once

#include <sherd/result.h>

#include <vector>

#include "core/sampling/surface_pieces.h"

namespace sherd {

/// Integrals of 1, x and x x^T over a piece of the solid, with x from a reference point that is kept
/// elsewhere. Grid coordinates. Unlike a centroid they have a meaning even where the volume is as small as
/// rounding.
struct RawMoments {
    double volume = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();

    RawMoments& operator+=(const RawMoments& other);
    /// The same integrals about another point: x becomes x + `shift`.
    RawMoments shifted(const Vec3& shift) const;
};

/// The solid part of the face between two voxels, seen from the lower one. Grid coordinates.
struct VoxelFace {
    int voxels[2] = {-1, -1};  ///< the second lies above the first
    int axis = 0;
    double area = 0;  ///< part of the face that is solid, 0 to 1
    double u = 0;     ///< its centroid from the middle of the face, along axis + 1
    double v = 0;     ///< and along axis + 2
};

/// The voxels of the grid that hold solid.
struct SolidVoxels {
    std::vector<long long> index;     ///< #voxels on the grid, ascending
    std::vector<RawMoments> moments;  ///< #voxels, about the voxel's centre
    std::vector<VoxelFace> faces;     ///< between two of them, with positive area
    std::vector<int> of_cut_voxel;    ///< #cut voxels: which of these it is
};

/// Moments of the solid in every voxel and on every face between voxels, exact to rounding, by the divergence
/// theorem: the solid part of a face equals the flux through the surface in the row of voxels above it, and a
/// voxel's integrals are the flux through its two x faces and its surface. Fails with a sentence where the
/// surface does not close.
Result<SolidVoxels> fillVoxels(const SamplingGrid& grid, const CutSurface& surface);

}  // namespace sherd
