#pragma once

namespace sherd {

/// How the moments of cut cells are found.
enum class MomentRule {
    /// By the divergence theorem over the surface, of all orders (momentFlux).
    exact,
    /// From the volume, centroid and second moments of each voxel, which are exact: the higher ones to about
    /// a thousandth of a cell (addVoxelPoints), in less than half the time. For solids that are solved once
    /// or twice.
    quick,
};

}  // namespace sherd
