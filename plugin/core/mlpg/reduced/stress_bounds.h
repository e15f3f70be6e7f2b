#pragma once

#include <sherd/settings.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/mlpg/reduced/gradient_lanes.h"
#include "core/mlpg/splines/spline_field.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// A range that holds all principal stresses, Pa; `smallest` <= 0 <= `largest`.
struct PrincipalRange {
    float smallest = 0, largest = 0;
};
/// That of a stress, from its mean and the size of its deviator, widened by `spread` (the largest principal
/// value of what may be added to it), and by what clearing a free surface of traction may add to it.
inline PrincipalRange principalRange(const Eigen::Matrix3f& stress, float spread, float coupling) {
    constexpr float rounding = 1e-4f;
    const float mean = (stress(0, 0) + stress(1, 1) + stress(2, 2)) / 3;
    const float x = stress(0, 0) - mean, y = stress(1, 1) - mean, z = stress(2, 2) - mean;
    const float xy = stress(0, 1), yz = stress(1, 2), zx = stress(2, 0);
    const float size =
        std::sqrt(x * x + y * y + z * z + 2 * (xy * xy + yz * yz + zx * zx));  // of the deviator
    const float slack = spread + rounding * (size + 2 * std::abs(mean));       // more than that of the stress
    const float of_deviator = std::sqrt(2.0f / 3) * size;
    const float largest = std::max(0.0f, mean + of_deviator + slack);
    const float smallest = std::min(0.0f, mean - of_deviator - slack);
    return {smallest - coupling * largest, largest - coupling * smallest};
}

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

    /// Per part, of the stress at all its samples. `raw`: coefficients of all functions, the fourth row zero;
    /// `functions`: those of each part. `dilatation`: the projected volumetric strain in float, see
    /// VolumetricProjection; empty: that of the displacement.
    std::vector<PrincipalRange> ranges(const Eigen::Matrix4Xf& raw,
                                       const std::vector<std::vector<int>>& functions,
                                       const Eigen::MatrixXf& dilatation = {}) const;
    /// Of the stress at points where the displacement has these gradients. `may_be_freed`: 1 where
    /// withTraction may change it, else 0.
    struct RangeLanes {
        GradientLanes::Lane smallest, largest;  ///< Pa
    };
    void rangesAt(const GradientLanes& points, const GradientLanes::Lane& may_be_freed,
                  RangeLanes& ranges) const;

  private:
    static constexpr int most = largest_spline_degree + 1;
    /// Bernstein coefficients on an interval of the pieces of the splines, and what a difference of them is
    /// divided by, m.
    struct Interval {
        std::array<float, most * most> coefficients{};
        float per_length = 0;
    };
    Interval intervalOf(double from, double to, double edge) const;
    struct Lanes;
    void load(const Eigen::Matrix4Xf& raw, const std::vector<int>& functions, int part, int lane,
              Lanes& lanes) const;
    PrincipalRange range(const Lanes& lanes, int lane) const;
    PrincipalRange projectedRange(const Lanes& lanes, int lane, const std::array<Interval, 3>& box,
                                  const Eigen::VectorXf& dilatation) const;
    Eigen::Matrix3f stressOf(const Eigen::Matrix3f& gradient) const {
        Eigen::Matrix3f stress = mu_pa_ * (gradient + gradient.transpose());
        stress.diagonal().array() += lambda_pa_ * gradient.trace();
        return stress;
    }

    int width_;
    Eigen::MatrixXd pieces_;
    std::vector<std::array<Interval, 3>> boxes_;  ///< per part
    /// Weights of the differences of neighbours along one direction, for the slope in the middle: those along
    /// it fastest.
    std::vector<float> middle_slopes_;
    float lambda_pa_, mu_pa_, coupling_, projected_share_;
};

}  // namespace sherd
