#include "core/mlpg/reduced/proper_modes.h"

#include <algorithm>
#include <cmath>

#include "core/linear_algebra/dense_kernels.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr double largest_entry = 32767;
constexpr double least_energy = 1e-9;  // of the softest mode: below it, modes are rounding

using SparseColumns = std::vector<std::vector<std::pair<int, double>>>;  // per patch: function, value

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

/// The responses to unit loads, without rigid motion, and the accelerations that balance the loads. The loads
/// of all patches at once would take as much memory as the responses, several times over.
Status solveInBatches(const SplineProblem& problem, const SparseSolver& factor,
                      const std::vector<int>& pinned, const SparseColumns& columns, const Progress& tell,
                      Eigen::MatrixXd& responses, Eigen::MatrixXd& accelerations) {
    constexpr std::size_t batch = 64;  // patches
    const auto load_count = static_cast<Eigen::Index>(3 * columns.size());
    responses.resize(problem.motions.coefficients.rows(), load_count);
    accelerations.resize(6L * problem.motions.componentCount(), load_count);
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
        responses.middleCols(static_cast<Eigen::Index>(3 * first), displacements.cols()) = displacements;
        accelerations.middleCols(static_cast<Eigen::Index>(3 * first), balancing.cols()) = balancing;
        tell(static_cast<double>(last) / static_cast<double>(columns.size()));
    }
    return success();
}

/// U^T F. Inertia forces do no work on displacements without rigid motion, so loads alone count.
Eigen::MatrixXd workOf(const SparseColumns& columns, const Eigen::MatrixXd& displacements) {
    const auto count = static_cast<Eigen::Index>(3 * columns.size());
    Eigen::MatrixXd work = Eigen::MatrixXd::Zero(displacements.cols(), count);
    for (Eigen::Index i = 0; i < displacements.cols(); ++i)
        for (Eigen::Index load = 0; load < count; ++load)
            for (const auto& [function, value] : columns[load / 3])
                work(i, load) += value * displacements(3L * function + load % 3, i);
    return work;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    Eigen::MatrixXd c(a.rows(), b.cols());
    setToProduct(a.data(), static_cast<int>(a.rows()), b.data(), static_cast<int>(b.cols()),
                 static_cast<int>(a.cols()), c.data());
    return c;
}

std::vector<float> rowByRow(const Eigen::MatrixXd& matrix) {
    std::vector<float> rows;
    rows.reserve(static_cast<std::size_t>(matrix.size()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) rows.push_back(static_cast<float>(matrix(i, j)));
    return rows;
}

/// In 16 bits, row by row, each column by a scale of its own.
void pack(const Eigen::MatrixXd& matrix, UnsetVector<std::int16_t>& entries, std::vector<float>& scales) {
    for (Eigen::Index m = 0; m < matrix.cols(); ++m)
        scales.push_back(static_cast<float>(matrix.col(m).cwiseAbs().maxCoeff() / largest_entry));
    entries.reserve(static_cast<std::size_t>(matrix.size()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index m = 0; m < matrix.cols(); ++m) {
            const double scale = scales[m] > 0 ? scales[m] : 1;
            entries.push_back(static_cast<std::int16_t>(
                std::clamp(std::round(matrix(i, m) / scale), -largest_entry, largest_entry)));
        }
}

void sortByFunction(const SparseColumns& columns, int function_count, ProperModes& modes) {
    modes.unit_starts.assign(static_cast<std::size_t>(function_count) + 1, 0);
    for (const auto& column : columns)
        for (const auto& entry : column) ++modes.unit_starts[entry.first + 1];
    for (int f = 0; f < function_count; ++f) modes.unit_starts[f + 1] += modes.unit_starts[f];
    std::vector<int> next(modes.unit_starts.begin(), modes.unit_starts.end() - 1);
    modes.unit_loads.resize(static_cast<std::size_t>(modes.unit_starts.back()));
    for (std::size_t patch = 0; patch < columns.size(); ++patch)
        for (const auto& [function, value] : columns[patch])
            modes.unit_loads[next[function]++] = {static_cast<int>(patch), static_cast<float>(value)};
}

/// u[i] = sum of entries times c, for the rows from `first` to `last`.
SHERD_WIDE_VECTORS
void multiplyRows(const std::int16_t* entries, const float* c, int count, long first, long last, float* u) {
    constexpr int lanes = ProperModes::lanes;
    for (long row = first; row < last; ++row) {
        const std::int16_t* entry = entries + row * count;
        float sums[lanes] = {};
        for (int m = 0; m < count; m += lanes)
            for (int l = 0; l < lanes; ++l) sums[l] += static_cast<float>(entry[m + l]) * c[m + l];
        static_assert(lanes == 16);  // loops of fixed lengths stay in registers
        for (int l = 0; l < 8; ++l) sums[l] += sums[l + 8];
        for (int l = 0; l < 4; ++l) sums[l] += sums[l + 4];
        u[row] = (sums[0] + sums[2]) + (sums[1] + sums[3]);
    }
}

/// columns = the unit loads on a function, times their combinations: count x 3.
SHERD_WIDE_VECTORS
void setToUnitLoads(const ProperModes::UnitLoad* loads, int load_count, const ProperModes& modes,
                    float* columns) {
    const int size = 3 * modes.count;
    std::fill(columns, columns + size, 0.0f);
    for (int i = 0; i < load_count; ++i) {
        const std::int16_t* entry = modes.combinations.data() + static_cast<long>(loads[i].patch) * size;
        const float value = loads[i].value;
        for (int j = 0; j < size; ++j) columns[j] += value * static_cast<float>(entry[j]);
    }
    for (int k = 0; k < 3; ++k)
        for (int m = 0; m < modes.count; ++m) columns[k * modes.count + m] *= modes.combination_scales[m];
}

}  // namespace

Result<ProperModes> ProperModes::make(const SplineProblem& problem, const SparseSolver& factor,
                                      const std::vector<int>& pinned, const std::vector<UnitPatch>& patches,
                                      int largest_count, const Progress& progress) {
    const auto tell = [&](double done) {
        if (progress) progress(done);
    };
    tell(0);
    const SparseColumns columns = valuesOf(problem, patches);
    constexpr double solves_done = 0.7;  // about: share of the time
    Eigen::MatrixXd responses, accelerations;
    const auto tell_solved = [&](double done) { tell(solves_done * done); };
    if (const Status solved =
            solveInBatches(problem, factor, pinned, columns, tell_solved, responses, accelerations);
        !solved)
        return Error{solved.error()};

    Eigen::MatrixXd vectors = workOf(columns, responses);
    vectors = (0.5 * (vectors + vectors.transpose())).eval();
    Eigen::VectorXd values(vectors.rows());  // ascending
    if (!vectors.allFinite() ||
        !symmetricEigenvectors(vectors.data(), static_cast<int>(vectors.rows()), values.data()))
        return Error{"The modes of the solid could not be found; try another particle spacing."};
    int count = 0;
    while (count < std::min<int>(largest_count, static_cast<int>(values.size())) &&
           values[values.size() - 1 - count] > least_energy * values[values.size() - 1])
        ++count;
    count -= count % lanes;
    if (count == 0)
        return Error{
            "The solid is too small for a reduced model; use a smaller spacing or a higher quality."};
    const Eigen::MatrixXd combinations = vectors.rightCols(count).rowwise().reverse() *
                                         values.tail(count).reverse().cwiseSqrt().cwiseInverse().asDiagonal();
    ProperModes modes;
    modes.count = count;
    pack(product(responses, combinations), modes.entries, modes.scales);
    pack(combinations, modes.combinations, modes.combination_scales);
    modes.accelerations = rowByRow(accelerations * combinations);
    sortByFunction(columns, problem.space->function_count, modes);
    tell(1);
    return modes;
}

Eigen::VectorXf ProperModes::displacement(const Eigen::VectorXf& coefficients) const {
    const Eigen::VectorXf scaled =
        coefficients.cwiseProduct(Eigen::Map<const Eigen::VectorXf>(scales.data(), count));
    const auto unknowns = static_cast<long>(entries.size()) / count;
    Eigen::VectorXf u(unknowns);
    multiplyRows(entries.data(), scaled.data(), count, 0, unknowns, u.data());
    return u;
}

void ProperModes::addWork(int unknown, float force, Eigen::VectorXf& sum) const {
    const std::int16_t* entry = entries.data() + static_cast<long>(unknown) * count;
    for (int m = 0; m < count; ++m) sum[m] += static_cast<float>(entry[m]) * scales[m] * force;
}

void ProperModes::forcesOn(const SplineProblem& problem, int function, float* forces) const {
    setToUnitLoads(unit_loads.data() + unit_starts[function],
                   unit_starts[function + 1] - unit_starts[function], *this, forces);
    Eigen::Map<Eigen::MatrixXf> columns(forces, count, 3);
    const int component = problem.space->component[function];
    if (problem.held[component]) return;
    const Eigen::Map<const Eigen::MatrixXf> of_motions(accelerations.data() + 6L * component * count, count,
                                                       6);
    for (int k = 0; k < 3; ++k) {
        const auto inertia = problem.inertia.forceOn(3L * function + k);
        for (int motion = 0; motion < 6; ++motion)
            if (inertia[motion] != 0)
                columns.col(k) += static_cast<float>(inertia[motion]) * of_motions.col(motion);
    }
}

}  // namespace sherd
