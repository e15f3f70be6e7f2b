#pragma once

#include <vector>

#include "core/sampling/voxel_boxes.h"

namespace sherd {

/// Moves the faces of a block of voxels from the grid to where the solid ends, as the fills of its voxels and
/// of the layers beside it tell: a wall that fills 0.4 of each of two layers becomes a box of that thickness
/// in its place, not one layer of the two. Where the solid is no such box but lies across the grid, the faces
/// stay.
class BoxFit {
  public:
    /// `wanted` (#voxels): whose boxes these are. `covered` (#voxels): which voxels blocks cover.
    BoxFit(const Discretisation& solid, const std::vector<char>& wanted, const std::vector<char>& covered)
        : solid_(solid), wanted_(wanted), covered_(covered) {}

    /// The box of the block from voxel `low` to voxel `high`, both in it. A face stays on the grid where the
    /// solid goes on behind it, in another block or in a piece that is not wanted.
    Box fit(const Eigen::Vector3i& low, const Eigen::Vector3i& high) const;

  private:
    /// Along one axis: how full the block's layers and those on both sides are, relative to its fullest.
    struct Profile {
        std::vector<double> fill;
        double below = 0, above = 0;
        bool free_below = true, free_above = true;  ///< whether the face may move
        /// Whether there are too few layers to say how thick the solid is.
        bool isOpen() const;
    };
    /// Where the lower and the upper face are, in layers from the lower side of the block.
    struct Faces {
        double lower = 0, upper = 0;
    };
    Profile profileOf(const Eigen::Vector3i& low, const Eigen::Vector3i& high, int axis) const;
    double layerBeside(Eigen::Vector3i low, Eigen::Vector3i high, int axis, int layer, bool& free) const;
    Faces facesFromMoments(const Profile& profile, Eigen::Vector3i low, Eigen::Vector3i high, int axis) const;
    Faces facesOf(const Profile& profile, const Eigen::Vector3i& low, const Eigen::Vector3i& high,
                  int axis) const;

    const Discretisation& solid_;
    const std::vector<char>& wanted_;
    const std::vector<char>& covered_;
};

}  // namespace sherd
