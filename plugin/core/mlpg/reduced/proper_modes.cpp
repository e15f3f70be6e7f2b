#include "core/mlpg/reduced/proper_modes.h"

#include <algorithm>
#include <cmath>

#include "core/linear_algebra/dense_kernels.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr double largest_entry = 32767;
constexpr double least_energy = 1e-9;  // of the softest mode: below it, modes are rounding

using SparseColumns = std::vector<UnitResponses::Load>;  // per patch: function, value

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

float scaleOf(const Eigen::VectorXd& column) {
    return static_cast<float>(column.cwiseAbs().maxCoeff() / largest_entry);
}

std::int16_t rounded(double value, float scale) {
    return static_cast<std::int16_t>(
        std::clamp(std::round(value / (scale > 0 ? scale : 1)), -largest_entry, largest_entry));
}

/// What 16 bits leave of a column.
Eigen::VectorXd remainderOf(const Eigen::VectorXd& column) {
    const float scale = scaleOf(column);
    return column.unaryExpr([&](double value) { return value - double(scale) * rounded(value, scale); });
}

/// In 16 bits, row by row, each column by a scale of its own.
void pack(const Eigen::MatrixXd& matrix, UnsetVector<std::int16_t>& entries, std::vector<float>& scales) {
    for (Eigen::Index m = 0; m < matrix.cols(); ++m) scales.push_back(scaleOf(matrix.col(m)));
    entries.reserve(static_cast<std::size_t>(matrix.size()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index m = 0; m < matrix.cols(); ++m) entries.push_back(rounded(matrix(i, m), scales[m]));
}

/// How many of the first modes strain more than they may when they are rounded, in whole lanes. Rounding
/// differs from unknown to unknown, so that the diagonal of the stiffness says what it strains.
int fineModes(const Eigen::MatrixXd& modes, const std::vector<double>& diagonal) {
    constexpr double largest_energy = 1e-4;  // each mode has 1/2
    constexpr int lanes = ProperModes::lanes;
    if (diagonal.empty()) return 0;
    const Eigen::Map<const Eigen::VectorXd> stiffness(diagonal.data(), modes.rows());
    Eigen::Index fine = modes.cols();
    while (fine > 0 && !(0.5 * remainderOf(modes.col(fine - 1)).cwiseAbs2().dot(stiffness) > largest_energy))
        --fine;
    return static_cast<int>((fine + lanes - 1) / lanes * lanes);
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

/// sum += entries times scales times a force.
SHERD_WIDE_VECTORS
void addScaled(const std::int16_t* entries, const float* scales, float force, int count, float* sum) {
    for (int m = 0; m < count; ++m) sum[m] += static_cast<float>(entries[m]) * scales[m] * force;
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

Result<ProperModes> ProperModes::make(const SplineProblem& problem, const UnitResponses& unit,
                                      int largest_count, const std::vector<double>& diagonal) {
    const SparseColumns& columns = unit.loads;
    const Eigen::MatrixXd &responses = unit.displacements, &accelerations = unit.accelerations;
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
    Eigen::MatrixXd displacements = product(responses, combinations);
    const int fine = fineModes(displacements, diagonal);
    displacements.conservativeResize(Eigen::NoChange, count + fine);
    for (int m = 0; m < fine; ++m) displacements.col(count + m) = remainderOf(displacements.col(m));
    pack(displacements, modes.entries, modes.scales);
    pack(combinations, modes.combinations, modes.combination_scales);
    modes.accelerations = rowByRow(accelerations * combinations);
    sortByFunction(columns, problem.space->function_count, modes);
    return modes;
}

Eigen::VectorXf ProperModes::displacement(const Eigen::VectorXf& coefficients) const {
    Eigen::VectorXf scaled(width());
    scaled << coefficients, coefficients.head(fineCount());
    scaled = scaled.cwiseProduct(Eigen::Map<const Eigen::VectorXf>(scales.data(), width())).eval();
    const auto unknowns = static_cast<long>(entries.size()) / width();
    Eigen::VectorXf u(unknowns);
    multiplyRows(entries.data(), scaled.data(), width(), 0, unknowns, u.data());
    return u;
}

void ProperModes::addWork(int unknown, float force, Eigen::VectorXf& sum) const {
    const std::int16_t* row = entries.data() + static_cast<long>(unknown) * width();
    addScaled(row, scales.data(), force, count, sum.data());
    addScaled(row + count, scales.data() + count, force, fineCount(), sum.data());
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
