#include "core/mlpg/splines/internal_forces.h"

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/part_integrals.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int chunk_count = 16;

/// int sigma(u) grad phi_a dV over a part, 3 x #functions, for its own coefficients u.
Eigen::Matrix3Xd partForces(const PartIntegrals& integrals, const CellPart& part,
                            const Elasticity& elasticity, const Eigen::Matrix3Xd& u) {
    const PartIntegrals::Gram own =
        part.moments.empty() ? PartIntegrals::Gram{} : integrals.gradientProducts(part);
    const PartIntegrals::Gram& gram = part.moments.empty() ? integrals.wholeCell() : own;
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, u.cols());
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i <= j; ++i) {
            const Eigen::MatrixXd& g = gram[3 * i + j];
            forces.row(i) += elasticity.lambda_pa * u.row(j) * g.transpose();
            forces.row(j) += elasticity.mu_pa * u.row(i) * g.transpose();
            if (i == j) {
                forces += elasticity.mu_pa * u * g.transpose();
                continue;
            }
            forces.row(j) += elasticity.lambda_pa * u.row(i) * g;
            forces.row(i) += elasticity.mu_pa * u.row(j) * g;
        }
    return forces;
}

}  // namespace

Eigen::Matrix3Xd splineInternalForces(const CellParts& solid, const SplineSpace& space,
                                      const Elasticity& elasticity, const std::vector<PointSpring>& springs,
                                      const VolumetricProjection* projection,
                                      const Eigen::Matrix3Xd& displacement) {
    const PartIntegrals integrals(space.degree, solid.edges);
    const Elasticity by_parts = projection ? withoutLambda(elasticity) : elasticity;
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<Eigen::Matrix3Xd> own(part_count);
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, part_count);
        Eigen::Matrix3Xd u(3, space.perPart());
        for (int p = chunkBegin(chunk, chunk_count, part_count); p < end; ++p) {
            for (int a = 0; a < space.perPart(); ++a) u.col(a) = displacement.col(space.raw_of[p][a]);
            own[p] = partForces(integrals, solid.parts[p], by_parts, u);
        }
    });
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, space.raw_count);
    for (int p = 0; p < part_count; ++p)
        for (int a = 0; a < space.perPart(); ++a) forces.col(space.raw_of[p][a]) += own[p].col(a);
    if (projection) forces += projection->forces(elasticity.lambda_pa, displacement);
    std::vector<double> values;
    for (const PointSpring& spring : springs) {
        splineValues(space.degree, spring.xi, values);
        const std::vector<int>& functions = space.raw_of[spring.part];
        Vec3 force = Vec3::Zero();
        for (size_t a = 0; a < functions.size(); ++a) force += values[a] * displacement.col(functions[a]);
        force *= spring.stiffness_n_m;
        for (size_t a = 0; a < functions.size(); ++a) forces.col(functions[a]) += values[a] * force;
    }
    return forces;
}

}  // namespace sherd
