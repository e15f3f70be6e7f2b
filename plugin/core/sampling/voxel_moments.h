#pragma once

#include <vector>

#include "core/sampling/moment_flux.h"
#include "core/sampling/solid_voxels.h"

namespace sherd {

/// Integrals of all monomials up to an order over the solid part of every voxel, in coordinates of the cell
/// that it lies in (see CellPart::moments). By the divergence theorem with the flux along x: a voxel's
/// moments are the flux through its lower and its upper x face and through its surface.
class VoxelMoments {
  public:
    /// `flux`: that of the surface in every cut voxel (see momentFlux).
    VoxelMoments(const SamplingGrid& grid, const CutSurface& cut, const SolidVoxels& solid,
                 std::vector<MomentFlux> flux, int order);

    /// Of whole voxels only.
    VoxelMoments(const SamplingGrid& grid, const CutSurface& cut, const SolidVoxels& solid, int order);

    /// Whether no triangle cuts a voxel of the solid.
    bool isWhole(int voxel) const { return cut_of_[voxel] < 0; }

    /// Adds the moments of a voxel of the solid at `position` on the grid.
    void addTo(int voxel, const Eigen::Vector3i& position, std::vector<double>& sum) const;

  private:
    double coordinate(int k) const { return static_cast<double>(k) / grid_.cells_per_spacing - 0.5; }
    void sweepRows(const CutSurface& cut, const SolidVoxels& solid);
    void passCutVoxel(MomentFlux& flux, int local, std::vector<double>& upper) const;
    void passUncutVoxel(const Eigen::Vector3i& position, bool whole, std::vector<double>& upper) const;

    const SamplingGrid& grid_;
    int n_;                    // powers of each coordinate
    std::vector<int> cut_of_;  // per voxel of the solid: which of the cut voxels it is, or -1
    std::vector<MomentFlux> flux_;
    std::vector<std::vector<double>> intervals_;  // 1-d moments of the voxels along one edge of a cell
};

}  // namespace sherd
