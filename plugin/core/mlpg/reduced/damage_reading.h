#pragma once

#include <memory>
#include <vector>

#include "core/damage/damage.h"
#include "core/mlpg/reduced/stress_bounds.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// Finds the damage that a displacement does, and its largest stress, without reading the stress everywhere:
/// where a bound is below the strength, and below the largest stress found so far, nothing is read.
class DamageReading {
  public:
    DamageReading(std::shared_ptr<const SplineProblem> problem, std::vector<GridPoint> samples);
    /// With bounds that were made before.
    DamageReading(std::shared_ptr<const SplineProblem> problem, std::vector<GridPoint> samples,
                  StressBounds bounds);

    /// As damagedParticles of readStress and freeSurface, for a displacement under `loads`. The overstress of
    /// particles below half their strength may be 0.
    Damage damage(const Eigen::VectorXf& unknowns, const std::vector<PointForce>& loads, double scale,
                  const Strength& strength) const;

    const std::vector<GridPoint>& samples() const { return samples_; }
    const StressBounds& bounds() const { return bounds_; }

  private:
    class Reader;

    Eigen::Matrix4Xf expand(const Eigen::VectorXf& unknowns) const;

    std::shared_ptr<const SplineProblem> problem_;
    std::vector<GridPoint> samples_;     ///< particles, then surface points
    std::vector<int> starts_, of_part_;  ///< samples, sorted by part
    std::vector<int> particle_of_;       ///< per sample
    Eigen::MatrixXf powers_;             ///< of the pieces of the splines
    StressBounds bounds_;
};

}  // namespace sherd
