#include "core/mlpg/reduced/compliance_matrix.h"

#include <utility>

#include "core/mlpg/reduced/unit_responses.h"

namespace sherd {

Result<ComplianceMatrix> ComplianceMatrix::make(const SplineProblem& problem, const SparseSolver& factor,
                                                const std::vector<int>& pinned, const Progress& progress) {
    std::vector<UnitResponses::Load> on_functions;
    for (int function = 0; function < problem.space->function_count; ++function)
        on_functions.push_back({{function, 1.0}});
    const auto unit = unitResponses(problem, factor, pinned, std::move(on_functions), progress);
    if (!unit) return Error{unit.error()};
    const Eigen::MatrixXd& columns = unit.value().displacements;
    return ComplianceMatrix{(0.5 * (columns + columns.transpose())).cast<float>()};
}

Result<ReducedResponse> ComplianceMatrix::respond(const Eigen::VectorXf& forces) const {
    ReducedResponse response{Eigen::VectorXf::Zero(entries.rows())};
    for (Eigen::Index function = 0; function < entries.cols() / 3; ++function) {
        const Eigen::Vector3f force = forces.segment<3>(3 * function);
        if (!force.isZero(0)) response.unknowns.noalias() += entries.middleCols<3>(3 * function) * force;
    }
    // The inertia forces do no work: the displacement has no rigid motion.
    response.strain_energy_j = 0.5 * double(forces.dot(response.unknowns));
    if (!response.unknowns.allFinite()) return Error{"The displacement under the loads is not finite."};
    return response;
}

}  // namespace sherd
