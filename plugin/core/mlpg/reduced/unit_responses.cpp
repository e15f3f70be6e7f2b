#include "core/mlpg/reduced/unit_responses.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"

namespace sherd {

namespace {

using SparseColumns = std::vector<UnitResponses::Load>;  // per patch

/// What a unit force on each patch is at the functions.
SparseColumns valuesOf(const SplineProblem& problem, const std::vector<UnitPatch>& patches) {
    const SplineSpace& space = *problem.space;
    SparseColumns columns;
    std::vector<double> values, sums(static_cast<std::size_t>(space.function_count), 0.0);
    for (const UnitPatch& patch : patches) {
        std::vector<int> touched;
        for (const UnitPatch::Point& point : patch.points) {
            const GridPoint place = locate(problem.parts(), point.position);
            if (place.part < 0) continue;
            splineValues(space.degree, place.xi, values);
            const std::vector<int>& raw = space.raw_of[place.part];
            for (std::size_t a = 0; a < raw.size(); ++a)
                for (const SplineTies::Term& term : space.termsOf(raw[a])) {
                    touched.push_back(term.function);
                    sums[term.function] += point.weight * values[a] * term.factor;
                }
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        columns.emplace_back();
        for (const int function : touched) {
            columns.back().push_back({function, sums[function]});
            sums[function] = 0;
        }
    }
    return columns;
}

/// Rows of a component's unknowns; the others are zero.
Eigen::MatrixXd ofComponent(const SplineProblem& problem, int component, const InertiaRelief::Forces& all) {
    Eigen::MatrixXd own = all;
    for (Eigen::Index u = 0; u < own.rows(); ++u)
        if (problem.motions.componentOfUnknown(u) != component) own.row(u).setZero();
    return own;
}

/// The balanced loads, #unknowns x 3 #patches, and the accelerations that balance them, 6 #components x 3
/// #patches.
void balancedLoads(const SplineProblem& problem, const SparseColumns& columns, Eigen::MatrixXd& forces,
                   Eigen::MatrixXd& accelerations) {
    const RigidMotions& motions = problem.motions;
    const auto count = static_cast<Eigen::Index>(3 * columns.size());
    forces = Eigen::MatrixXd::Zero(motions.coefficients.rows(), count);
    accelerations.resize(6L * motions.componentCount(), count);
    for (Eigen::Index load = 0; load < count; ++load) {
        Eigen::Matrix<double, 6, Eigen::Dynamic> resultants;
        resultants.setZero(6, motions.componentCount());
        for (const auto& [function, value] : columns[load / 3]) {
            const Eigen::Index unknown = 3L * function + load % 3;
            forces(unknown, load) = value;
            resultants.col(motions.componentOfUnknown(unknown)) +=
                value * motions.coefficients.row(unknown).transpose();
        }
        clearHeld(problem, resultants);
        accelerations.col(load) = problem.inertia.accelerationOf(resultants).reshaped();
    }
    for (int component = 0; component < motions.componentCount(); ++component)
        forces.noalias() += ofComponent(problem, component, problem.inertia.forces()) *
                            accelerations.middleRows(6L * component, 6);
}

/// Takes the rigid motion of every free component out of displacements, in the mean over its mass.
void removeRigidMotion(const SplineProblem& problem, Eigen::MatrixXd& displacements) {
    for (int component = 0; component < problem.motions.componentCount(); ++component) {
        if (problem.held[component]) continue;
        const Eigen::MatrixXd momenta =
            ofComponent(problem, component, problem.inertia.forces()).transpose() * displacements;
        const Eigen::MatrixXd motion =
            problem.inertia.mass(component).completeOrthogonalDecomposition().solve(momenta);
        displacements.noalias() -= ofComponent(problem, component, problem.motions.coefficients) * motion;
    }
}

/// Finds the responses to `unit.loads`, without rigid motion, and the accelerations that balance the loads.
/// The loads of all patches at once would take as much memory as the responses, several times over.
Status solveInBatches(const SplineProblem& problem, const SparseSolver& factor,
                      const std::vector<int>& pinned, const Progress& progress, UnitResponses& unit) {
    constexpr std::size_t batch = 128;  // patches; enough for two cores
    const SparseColumns& columns = unit.loads;
    const auto load_count = static_cast<Eigen::Index>(3 * columns.size());
    unit.displacements.resize(problem.motions.coefficients.rows(), load_count);
    unit.accelerations.resize(6L * problem.motions.componentCount(), load_count);
    for (std::size_t first = 0; first < columns.size(); first += batch) {
        const std::size_t last = std::min(first + batch, columns.size());
        const SparseColumns own(columns.begin() + static_cast<long>(first),
                                columns.begin() + static_cast<long>(last));
        Eigen::MatrixXd forces, balancing, displacements;
        balancedLoads(problem, own, forces, balancing);
        for (const int unknown : pinned) forces.row(unknown).setZero();
        if (!factor.solve(forces, displacements))
            return Error{"The stress solve failed in the linear solver."};
        removeRigidMotion(problem, displacements);
        const auto place = static_cast<Eigen::Index>(3 * first);
        unit.displacements.middleCols(place, displacements.cols()) = displacements;
        unit.accelerations.middleCols(place, balancing.cols()) = balancing;
        if (progress) progress(static_cast<double>(last) / static_cast<double>(columns.size()));
    }
    return success();
}

}  // namespace

Result<UnitResponses> unitResponses(const SplineProblem& problem, const SparseSolver& factor,
                                    const std::vector<int>& pinned, std::vector<UnitResponses::Load> loads,
                                    const Progress& progress) {
    UnitResponses unit;
    unit.loads = std::move(loads);
    if (const Status solved = solveInBatches(problem, factor, pinned, progress, unit); !solved)
        return Error{solved.error()};
    return unit;
}

Result<UnitResponses> unitResponses(const SplineProblem& problem, const SparseSolver& factor,
                                    const std::vector<int>& pinned, const std::vector<UnitPatch>& patches,
                                    const Progress& progress) {
    return unitResponses(problem, factor, pinned, valuesOf(problem, patches), progress);
}

}  // namespace sherd
