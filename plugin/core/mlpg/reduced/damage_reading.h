#pragma once

#include <memory>
#include <vector>

#include "core/damage/damage.h"
#include "core/damage/material_strength.h"
#include "core/mlpg/reduced/contact_reading.h"
#include "core/mlpg/reduced/stress_bounds.h"
#include "core/mlpg/splines/reading_points.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

struct PartDisplacement;

/// Finds the damage that a displacement does, and its largest stress, without reading the stress everywhere:
/// where a bound is below the strength, and below the largest stress found so far, nothing is read.
class DamageReading {
  public:
    DamageReading(std::shared_ptr<const SplineProblem> problem, const std::vector<GridPoint>& samples);
    /// With points and bounds that were made before.
    DamageReading(std::shared_ptr<const SplineProblem> problem, ReadingPoints points, StressBounds bounds);

    /// As damagedParticles of readStress and freeSurface, for the displacement that is left besides the near
    /// field of contacts. The overstress of particles below half their strength may be 0.
    Damage damage(const Eigen::VectorXf& unknowns, const ContactField& contact, double scale,
                  const Strength& strength) const;
    /// Adds the damage of one of many displacements under the same contacts. `scale` multiplies both. What
    /// is no nearer to failure than `sum` has it already is not read: the hardest displacement first.
    /// Overstress below 1 is that of the displacements from the first that fails something on.
    void addDamage(const Eigen::VectorXf& unknowns, const ContactReading& contact, double scale,
                   const Strength& strength, Damage& sum) const;
    ContactReading contactReading(const ContactField& contact) const {
        return ContactReading(*problem_, points_, contact);
    }

    /// What `strength` is at the points, Pa.
    std::vector<double> strengths(const MaterialStrength& strength) const;

    const ReadingPoints& points() const { return points_; }
    const SurfaceFaces& faces() const { return faces_; }
    const StressBounds& bounds() const { return bounds_; }

  private:
    struct Bounds;

    Eigen::Matrix4Xf expand(const Eigen::VectorXf& unknowns) const;
    double weakest(int part, const Strength& strength) const;
    Bounds boundsOf(const PartDisplacement& displacement, const ContactReading& contact, double scale,
                    const Strength& strength) const;

    std::shared_ptr<const SplineProblem> problem_;
    ReadingPoints points_;
    SurfaceFaces faces_;
    Eigen::MatrixXf powers_;  ///< of the pieces of the splines
    StressBounds bounds_;
};

}  // namespace sherd
