#pragma once

#include <sherd/material.h>

#include <array>
#include <vector>

#include "core/damage/equivalent_bound.h"
#include "core/mlpg/reduced/peak_table.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// Reads the largest equivalent stress of a solid under unit loads on patches: everywhere near the patch, and
/// away from it where the stress is largest.
class PeakReading {
  public:
    using Peaks = std::array<float, PeakTable::directions>;  ///< Pa, by direction of the patch

    /// Refers to all of them.
    PeakReading(const SplineProblem& problem, const std::vector<GridPoint>& samples,
                const Material& material);

    /// Coefficients of all functions under all loads: a column a function, 3 numbers a load.
    Eigen::MatrixXf expand(const Eigen::MatrixXd& displacements) const;
    /// Per patch the parts with the largest stress in their middle.
    std::vector<std::vector<int>> mostStressedParts(const Eigen::MatrixXf& raw) const;
    /// What is read: patches of one radius.
    struct Read {
        const Eigen::MatrixXf& raw;  ///< as `expand` returns it
        const std::vector<PeakTable::Patch>& patches;
        const std::vector<std::vector<int>>&
            far;  ///< per patch: parts that are read though they are not near
        double radius_m;
    };
    std::vector<Peaks> read(const Read& read) const;

  private:
    using Directions = std::array<Vec3, PeakTable::directions>;

    Vec3 placeOf(int sample) const;
    std::vector<std::vector<int>> readersOf(const Read& read, int first, int last) const;
    Eigen::MatrixXf dilatationOf(const Eigen::MatrixXf& raw) const;
    void readChunk(const Read& read, const Eigen::MatrixXf& dilatation, int first, int last,
                   std::vector<Peaks>& peaks) const;
    void include(int sample, const Eigen::Matrix<float, 9, 3>& gradients, const PeakTable::Patch& patch,
                 double radius_m, const Directions& directions, Peaks& peaks) const;
    void raise(const SymmetricTensor& stress, float& peak) const;

    const SplineProblem& problem_;
    const std::vector<GridPoint>& samples_;
    const Material& material_;
    const FailureCriterion& criterion_;
    EquivalentBound bound_;
    std::vector<std::vector<int>> of_part_;  ///< samples
    std::vector<Vec3> middles_;              ///< per part, of its samples
};

}  // namespace sherd
