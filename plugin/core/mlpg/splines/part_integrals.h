#pragma once

#include <Eigen/Dense>
#include <array>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// Exact integrals of splines over parts of cells. A cell's functions are products of polynomials in xi, eta
/// and zeta, so the integral of a product of two of them is contracted from the part's moments one direction
/// after the other, which takes far fewer operations than quadrature points.
class PartIntegrals {
  public:
    /// `edges` of a cell, m.
    PartIntegrals(int degree, const Vec3& edges);

    /// gram[3 i + j](a, b) = int d_i phi_a d_j phi_b dV, in m, for i <= j; the others are left empty: they
    /// are the transposes of these.
    using Gram = std::array<Eigen::MatrixXd, 9>;
    Gram gradientProducts(const CellPart& part) const;
    const Gram& wholeCell() const { return whole_; }

    /// int phi_a^2 dV over a cell's volume, #functions.
    Eigen::VectorXd squares(const CellPart& part) const;

    /// int phi_a (1, x - c) dV, 4 x #functions, m^3 and m^4; `middle` of the cell from c, m.
    Eigen::Matrix4Xd bodyMoments(const CellPart& part, const Vec3& middle) const;

  private:
    Eigen::VectorXd momentsOf(const CellPart& part) const;
    Gram contracted(const Eigen::VectorXd& moments) const;

    int width_, powers_;  // functions and moments in one direction
    Vec3 edges_;
    Eigen::VectorXd whole_moments_;
    /// Powers of phi_a phi_b, one column for every pair a + width b; [1 of a, 2 of b]: with the slope of a,
    /// of b.
    std::array<Eigen::MatrixXd, 4> pairs_;
    std::array<Eigen::MatrixXd, 2> functions_;  // powers of phi_a and xi phi_a
    Eigen::MatrixXd squares_;                   // powers of phi_a^2
    Gram whole_;
};

}  // namespace sherd
