#pragma once

#include "core/mls/shape_functions.h"

namespace sherd {

/// Finds the sub-domain that a load acts on, and the values of the shape functions there.
class LoadPlacement {
  public:
    /// All arguments must outlive this object.
    LoadPlacement(const Discretisation& solid, const SupportGraph& supports, const TrialSpace& space)
        : solid_(&solid), evaluator_(solid, supports, space) {}

    /// Owner of the integration cell whose centroid is nearest to x; -1 when x is farther from it than two spacings,
    /// that is, well outside the solid.
    int ownerAt(const Vec3& x) const;

    Evaluation evaluate(const Vec3& x, int owner, ShapeFunctions& shapes) {
        return evaluator_.evaluate(x, owner, false, shapes);
    }

  private:
    const Discretisation* solid_;
    ShapeEvaluator evaluator_;
};

}  // namespace sherd
