#pragma once

#include <sherd/settings.h>

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "core/mlpg/splines/spline_field.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// A range that holds all principal stresses, Pa; `smallest` <= 0 <= `largest`.
struct PrincipalRange {
    float smallest = 0, largest = 0;
};
/// That of a stress, from its mean and the size of its deviator, widened by `spread` (the largest principal
/// value of what may be added to it), and by what clearing a free surface of traction may add to it.
PrincipalRange principalRange(const Eigen::Matrix3f& stress, float spread, float coupling);

/// Bounds of the stress of splines on the boxes that hold the samples of each part, from coefficients alone.
/// On a box the splines are Bernstein polynomials, and a derivative is one of a degree less whose
/// coefficients are differences of neighbours. A polynomial lies within its Bernstein coefficients, so the
/// gradient anywhere in the box differs from that in its middle by no more than the differences do.
class StressBounds {
  public:
    /// `samples` of all parts, each in a part or in none.
    StressBounds(const CellParts& solid, int degree, const Elasticity& elasticity,
                 const std::vector<GridPoint>& samples);

    /// Writes the boxes of all parts, or reads them (see archive.h beside this file).
    template <class Archive>
    void archiveBoxes(Archive& archive);

    /// Of the stress at all samples of a part. `raw`: coefficients of all functions, the fourth row zero.
    PrincipalRange range(const Eigen::Matrix4Xf& raw, const std::vector<int>& functions, int part) const;

  private:
    static constexpr int most = largest_spline_degree + 1;
    /// Bernstein coefficients on an interval of the pieces of the splines, and what a difference of them is
    /// divided by, m.
    struct Interval {
        std::array<float, most * most> coefficients{};
        float per_length = 0;
    };
    Interval intervalOf(double from, double to, double edge) const;

    int width_;
    Eigen::MatrixXd pieces_;
    std::vector<std::array<Interval, 3>> boxes_;  ///< per part
    std::vector<float> middle_;                   ///< Bernstein polynomials in the middle of an interval
    std::vector<float> middle_slopes_;            ///< differences of neighbours there
    float lambda_pa_, mu_pa_, coupling_;
};

}  // namespace sherd
