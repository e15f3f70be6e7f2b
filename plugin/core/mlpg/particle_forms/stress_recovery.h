#pragma once

#include <vector>

#include "core/mlpg/particle_forms/support_graph.h"

namespace sherd {

/// Smooths the stresses of cells: around a point a linear function is fitted to them (least squares, weighted
/// by volume and distance, neighbours through the solid only) and evaluated there. At the particles and at
/// the surface points the fits depend on the body alone and are made once.
class StressRecovery {
  public:
    /// `solid` must outlive this object. `support_radius` of the shape functions in particle spacings.
    StressRecovery(const Discretisation& solid, const SupportGraph& supports, double support_radius);

    /// `cells`: symmetric stresses of the #cells cells, Pa. Fills `particles` (#particles) and `surface`
    /// (#surface points).
    void recover(const std::vector<Mat3>& cells, std::vector<SymmetricTensor>& particles,
                 std::vector<SymmetricTensor>& surface) const;

    /// At any point of the sub-domain of particle `owner`.
    SymmetricTensor recoverAt(const std::vector<Mat3>& cells, const Vec3& x, int owner) const;

  private:
    /// Factor of a cell's stress in the stress at a point.
    struct Term {
        int cell;
        double factor;
    };
    void fit(const Vec3& x, int owner, std::vector<Term>& terms) const;

    const Discretisation* solid_;
    double fit_radius_;                    // in particle spacings
    std::vector<std::vector<int>> balls_;  // #particles: whose cells may take part in its fits
    std::vector<int> starts_;              // #particles + #surface points + 1, into terms_
    std::vector<Term> terms_;
};

}  // namespace sherd
