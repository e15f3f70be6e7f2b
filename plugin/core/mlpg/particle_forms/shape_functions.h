#pragma once

#include <sherd/settings.h>

#include <vector>

#include "core/mlpg/particle_forms/support_graph.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// The functions in which the displacement is sought: u(x) = sum_a phi_a(x) u_a. Every particle i carries one
/// function (mls: the datum is u(x_i)) or four (gmls: u(x_i) and h_i du/dx_j(x_i), j = 1..3, h_i the
/// particle's spacing).
struct TrialSpace {
    TrialFunction trial_function = TrialFunction::gmls;
    Basis basis = Basis::linear;

    int functionsPerParticle() const { return trial_function == TrialFunction::gmls ? 4 : 1; }
    /// Of u as a vector: unknown 3 * (functionsPerParticle() * particle + k) + component.
    int unknownsPerParticle() const { return 3 * functionsPerParticle(); }
};

/// What had to be changed to evaluate the shape functions at a point; each value includes those before it.
enum class Evaluation {
    regular,
    widened,   ///< supports widened for this point: too few or badly placed neighbours
    reduced,   ///< quadratic basis given up for the linear one
    deficient  ///< neighbours are coplanar or fewer: linear fields are not reproduced at this point
};

/// Shape functions that differ from zero at one point.
struct ShapeFunctions {
    std::vector<int> particles;
    std::vector<double> values;   ///< functionsPerParticle() for each particle
    std::vector<Vec3> gradients;  ///< the same count, 1/m; only if asked for
};

/// Evaluates (generalised) moving least squares (paper, Eq. 6-11). The gradient terms of Eq. 11 are data as
/// the values are, so that linear fields stay exact; Eq. 12 by itself would lose that. Holds scratch memory:
/// one object per thread.
class ShapeEvaluator {
  public:
    /// All arguments must outlive this object.
    ShapeEvaluator(const Discretisation& solid, const SupportGraph& supports, const TrialSpace& space);

    /// At a point of the sub-domain of particle `owner`.
    Evaluation evaluate(const Vec3& x, int owner, bool with_gradients, ShapeFunctions& out);

    /// At a point of the face between two sub-domains: only particles that both see take part.
    Evaluation evaluateBetween(const Vec3& x, int owner, int other, bool with_gradients, ShapeFunctions& out);

  private:
    template <int N>
    bool fit(const Vec3& x, double widening, bool with_gradients, ShapeFunctions& out);
    template <int N>
    bool widenUntilFit(const Vec3& x, int owner, int other, bool with_gradients, Evaluation& state,
                       ShapeFunctions& out);
    void fitDeficient(const Vec3& x, bool with_gradients, ShapeFunctions& out) const;
    void gatherCandidates(int owner, int other, double widening);

    const Discretisation* solid_;
    const SupportGraph* supports_;
    const TrialSpace* space_;
    std::vector<int> candidates_;  // of the point at hand
    double scale_ = 1;             // lengths in the basis are in units of the owner's support radius
    double widening_ = 1;
};

}  // namespace sherd
