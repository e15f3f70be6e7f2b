#pragma once

#include <cstdint>
#include <vector>

#include "core/mlpg/reduced/unit_responses.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/numerics/unset_vector.h"

namespace sherd {

/// What a solid can do under loads on its surface: proper orthogonal modes V of the responses to unit loads
/// on patches all over it. V^T K V = I, and V has no rigid motion. K V is not stored: a mode is the response
/// to a combination of the unit loads, so that K V is the same combination of these, which act on a few
/// unknowns each, and of the inertia forces that balance them.
struct ProperModes {
    static constexpr int lanes = 16;  ///< sums are made in so many parts, whatever the processor

    int count = 0;  ///< a multiple of `lanes`
    /// #unknowns x width(), row by row: the modes in 16 bits, then what these leave of the first fineCount().
    UnsetVector<std::int16_t> entries;
    std::vector<float> scales;  ///< per column of `entries`: m per unit

    struct UnitLoad {
        int patch;
        float value;  ///< of the function, summed over the patch's points
    };
    std::vector<int> unit_starts;      ///< per function and one more, into `unit_loads`
    std::vector<UnitLoad> unit_loads;  ///< that act on the function
    /// 3 #patches x count, row by row: of the unit loads in x, y and z.
    UnsetVector<std::int16_t> combinations;
    std::vector<float> combination_scales;  ///< per mode: N per unit of `combinations`
    std::vector<float> accelerations;       ///< 6 #components x count, row by row: those that balance them

    int width() const { return static_cast<int>(scales.size()); }
    /// Of the softest modes, those that are kept in twice as many bits: a multiple of `lanes`. A slender
    /// solid moves far and strains little, so that rounding would strain it more than the mode does.
    int fineCount() const { return width() - count; }

    /// From what unit loads do. `diagonal` of the stiffness (#unknowns) tells what rounding strains; without
    /// it (size 0) no mode is kept finer. An error if there are no modes.
    static Result<ProperModes> make(const SplineProblem& problem, const UnitResponses& unit,
                                    int largest_count, const std::vector<double>& diagonal = {});

    /// u = V c, #unknowns.
    Eigen::VectorXf displacement(const Eigen::VectorXf& coefficients) const;
    /// sum += V^T f of a force on one unknown.
    void addWork(int unknown, float force, Eigen::VectorXf& sum) const;
    /// The rows of K V for the three unknowns of a function, one after the other: 3 count numbers.
    void forcesOn(const SplineProblem& problem, int function, float* forces) const;
};

}  // namespace sherd
