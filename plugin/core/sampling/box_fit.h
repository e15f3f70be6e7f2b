#pragma once

#include <vector>

#include "core/sampling/voxel_boxes.h"
#include "core/sampling/voxel_index.h"

namespace sherd {

/// Moves the faces of a block of voxels from the grid to where the solid ends, as the fills of its voxels and
/// of the layers beside it tell: a wall that fills 0.4 of each of two layers becomes a box of that thickness
/// in its place, not one layer of the two. Where the solid is no such box but lies across the grid, the faces
/// stay.
class BoxFit {
  public:
    /// Whose boxes these are.
    struct Piece {
        const std::vector<int>& owner;        ///< #voxels, the piece that each belongs to
        const std::vector<char>& is_covered;  ///< #voxels, 1 for those of the piece that blocks cover
        int number;
    };
    BoxFit(const Discretisation& solid, const VoxelIndex& index, const Piece& piece)
        : solid_(solid), index_(index), piece_(piece) {}

    /// The box of the block from voxel `low` to voxel `high`, both in it. A face stays on the grid where the
    /// solid goes on behind it, in another block or in a piece that is not wanted.
    Box fit(const Eigen::Vector3i& low, const Eigen::Vector3i& high) const;

  private:
    bool isWanted(int v) const { return piece_.owner[v] == piece_.number; }
    bool isCovered(int v) const { return isWanted(v) && piece_.is_covered[v]; }

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
    const VoxelIndex& index_;
    Piece piece_;
};

}  // namespace sherd
