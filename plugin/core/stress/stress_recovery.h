#pragma once

#include <vector>

#include "core/mls/support_graph.h"

namespace sherd {

/// Smooths the stresses of cells: at every particle a linear function is fitted to the cells around it (least squares,
/// weighted by volume and distance, neighbours through the solid only), and evaluated at the particle and at the surface
/// points of its sub-domain. The fits depend on the body alone and are made once.
class StressRecovery {
  public:
    StressRecovery(const Discretisation& solid, const SupportGraph& supports);

    /// `cells`: symmetric stresses of the #cells cells, Pa. Fills `particles` (#particles) and `surface` (#surface points).
    void recover(const std::vector<Mat3>& cells, std::vector<Voigt>& particles, std::vector<Voigt>& surface) const;

  private:
    struct Term {
        int cell;
        double value;
        Vec3 slope;
    };
    const Discretisation* solid_;
    std::vector<int> starts_;  // #particles + 1, into terms_
    std::vector<Term> terms_;
    std::vector<Vec3> means_;  // #particles: where the fit has its mean value
};

}  // namespace sherd
