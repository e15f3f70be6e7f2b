#pragma once

#include <algorithm>
#include <vector>

#include "geometry/cutting/crack_complex.h"

namespace sherd {

/// Finds crack triangles near a box. The lattice cells that they were made in are the grid: each lies in one,
/// and those of a row of cells follow each other.
class CrackCells {
  public:
    CrackCells(const LabelLattice& lattice, const CrackComplex& crack) : lattice_(lattice), crack_(crack) {
        boxes_.reserve(crack.triangles.size());
        for (const auto& [a, b, c] : crack.triangles) {
            const Vec3 &p = crack.points[a], &q = crack.points[b], &r = crack.points[c];
            boxes_.push_back({p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)});
        }
    }

    /// Calls visit(triangle) for those whose bounding boxes meet the box [low, high], in ascending order.
    template <class Visit>
    void visitNear(const Vec3& low, const Vec3& high, const Visit& visit) const {
        // Nodes are jittered, so a cell reaches beyond its place on the grid. The lattice begins in the air
        // below the solid, so all of this is positive and truncation rounds down.
        const double reach = lattice_.jitter + 1e-6, cells_per_m = 1 / lattice_.spacing;
        const Vec3 from = (low - lattice_.origin) * cells_per_m, to = (high - lattice_.origin) * cells_per_m;
        const int first[3] = {static_cast<int>(from.x() - reach), static_cast<int>(from.y() - reach),
                              static_cast<int>(from.z() - reach)},
                  last[3] = {static_cast<int>(to.x() + reach), static_cast<int>(to.y() + reach),
                             static_cast<int>(to.z() + reach)};
        for (int k = first[2]; k <= last[2]; ++k)
            for (int j = first[1]; j <= last[1]; ++j) {
                const int begin = crack_.first_of_cell[lattice_.index(first[0], j, k)],
                          end = crack_.first_of_cell[lattice_.index(last[0], j, k) + 1];
                for (int t = begin; t < end; ++t)
                    if (boxes_[t].meets(low, high)) visit(t);
            }
    }

  private:
    struct Box {
        Vec3 low, high;
        bool meets(const Vec3& other_low, const Vec3& other_high) const {
            return low.x() <= other_high.x() && high.x() >= other_low.x() && low.y() <= other_high.y() &&
                   high.y() >= other_low.y() && low.z() <= other_high.z() && high.z() >= other_low.z();
        }
    };

    const LabelLattice& lattice_;
    const CrackComplex& crack_;
    std::vector<Box> boxes_;
};

}  // namespace sherd
