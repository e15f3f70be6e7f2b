#pragma once

#include <sherd/settings.h>

#include "core/linear_algebra/block_matrix.h"
#include "core/mlpg/splines/spline_inertia.h"
#include "core/mlpg/splines/spline_supports.h"
#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

/// The stress problem of a body in splines, as it stays from blow to blow.
struct SplineProblem {
    std::shared_ptr<const Discretisation> solid;
    Elasticity elasticity;
    double density_kg_m3;
    std::vector<double> shares;  ///< of the stiffness, per part; empty: nothing is damaged
    std::shared_ptr<const SplineSpace> space;
    RigidMotions motions;
    std::vector<SupportSpring> supports;
    std::vector<char> held;  ///< per component: by supports
    Eigen::Matrix4Xd inertia_moments;
    InertiaRelief inertia;
    std::shared_ptr<const VolumetricProjection> projection;  ///< null: the material changes its volume

    const CellParts& parts() const { return solid->parts; }
    /// The displacement that unknowns stand for.
    SplineField fieldOf(const Eigen::VectorXd& unknowns) const;
};

/// An error if the solid was sampled for a lower degree, or if the supports do not hold it.
Result<SplineProblem> makeSplineProblem(std::shared_ptr<const Discretisation> solid, const Material& material,
                                        Basis basis, const std::vector<SupportPoint>& supports,
                                        const std::vector<char>& damaged);

/// Point forces at the unknowns. The error says which load is not finite or acts outside the body.
Result<Eigen::VectorXd> forcesAt(const SplineProblem& problem, const std::vector<PointForce>& loads);

/// The stiffness that supports and undamaged material give, see splineStiffness.
BlockMatrix stiffnessOf(const SplineProblem& problem);

/// Unknowns that hold the rigid motions of components without supports.
std::vector<int> pinnedUnknowns(const SplineProblem& problem, const BlockMatrix& stiffness);

/// Sets the resultants of held components to zero: their supports balance the loads.
void clearHeld(const SplineProblem& problem, Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants);

}  // namespace sherd
