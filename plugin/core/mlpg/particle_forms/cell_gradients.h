#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "core/mlpg/particle_forms/shape_functions.h"

namespace sherd {

/// How many evaluation points ended in each state of `Evaluation`.
using EvaluationCounts = std::array<int, 4>;

/// Smoothed gradients of the shape functions (stabilised conforming integration): for cell c
///     g_ca = 1/V_c * sum over its faces and surface points of phi_a(x_q) A_q,
/// the mean of grad phi_a over the cell, from values alone. Since the A_q close the cell, linear fields are
/// differentiated exactly, and since both cells of a face use the same phi_a(x_q), the Galerkin form passes
/// the patch test.
struct CellGradients {
    int functions_per_particle = 0;
    std::vector<int> starts;     ///< #cells + 1, into `particles`
    std::vector<int> particles;  ///< whose functions differ from zero on the cell
    std::vector<double>
        gradients;  ///< per entry of `particles`: functions_per_particle x 3, function by function, 1/m
    EvaluationCounts evaluations{};

    /// Gradients on a cell, 3 x (functions_per_particle * #its particles).
    Eigen::Map<const Eigen::Matrix3Xd> ofCell(int cell) const {
        const long begin = static_cast<long>(starts[cell]) * functions_per_particle;
        const long end = static_cast<long>(starts[cell + 1]) * functions_per_particle;
        return {gradients.data() + 3 * begin, 3, end - begin};
    }
};

CellGradients smoothedGradients(const Discretisation& solid, const SupportGraph& supports,
                                const TrialSpace& space);

}  // namespace sherd
