#pragma once

#include "core/mlpg/splines/reading_points.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/stress/near_field.h"

namespace sherd {

/// What loads a body besides the near field of its contacts, as forces at the unknowns. With sigma that of
/// the near field, which balances itself, the rest of the displacement has the weak form
///     a(rest, v) = int_Gamma (t - sigma n) v
/// on the whole surface, and the loads that no disc stands for. Where the surface is flat under a contact
/// t = sigma n, so that what is left acts on the other faces and changes as slowly as the distance to the
/// contact is large. `faces`: those of the points, which stand for them far from the contacts. An error if a
/// load is not finite or outside the body.
Result<Eigen::VectorXd> contactRemainder(const SplineProblem& problem, const ReadingPoints& points,
                                         const SurfaceFaces& faces, const ContactField& contact);

}  // namespace sherd
