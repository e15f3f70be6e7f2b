#pragma once

#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// The ties of one part's own functions as a matrix T: own coefficients = T unknown coefficients.
class PartTies {
  public:
    /// `functions`: unknown ones that reach the part, ascending.
    PartTies(const SplineSpace& space, int part, const std::vector<int>& functions);

    /// From a matrix between own functions to one between unknown functions, T^T matrix T.
    void apply(Eigen::MatrixXd& matrix) const;

  private:
    struct Term {
        int own, unknown;
        double factor;
    };
    Eigen::MatrixXd columns(const Eigen::MatrixXd& matrix) const;  // matrix T

    size_t function_count_;
    bool identity_ = true;
    std::vector<Term> terms_;
};

}  // namespace sherd
