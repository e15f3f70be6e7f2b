#pragma once

#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Finds the voxels of a solid by their place on the grid.
class VoxelIndex {
  public:
    explicit VoxelIndex(const Discretisation& solid) {
        Eigen::AlignedBox3i box;
        for (const Discretisation::Voxel& voxel : solid.voxels) box.extend(voxel.index);
        if (box.isEmpty()) return;
        low_ = box.min();
        size_ = box.sizes() + Eigen::Vector3i::Ones();
        number_at_.assign(static_cast<std::size_t>(size_.cast<double>().prod()), -1);
        for (std::size_t v = 0; v < solid.voxels.size(); ++v)
            number_at_[place(solid.voxels[v].index - low_)] = static_cast<int>(v);
    }

    /// The number of a voxel, or -1 where there is none.
    int at(const Eigen::Vector3i& index) const {
        const Eigen::Vector3i i = index - low_;
        if ((i.array() < 0).any() || (i.array() >= size_.array()).any()) return -1;
        return number_at_[place(i)];
    }

  private:
    std::size_t place(const Eigen::Vector3i& i) const {
        return static_cast<std::size_t>(i.x()) +
               static_cast<std::size_t>(size_.x()) *
                   (static_cast<std::size_t>(i.y()) +
                    static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(i.z()));
    }

    Eigen::Vector3i low_ = Eigen::Vector3i::Zero(), size_ = Eigen::Vector3i::Zero();
    std::vector<int> number_at_;
};

}  // namespace sherd
