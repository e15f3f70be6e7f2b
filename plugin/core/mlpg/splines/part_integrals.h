#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

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

    /// int phi_a phi_b dV, m^3.
    Eigen::MatrixXd products(const CellPart& part) const;
    /// int phi_a^2 dV over a cell's volume, #functions.
    Eigen::VectorXd squares(const CellPart& part) const;

    /// int xi^alpha d_i phi_a dV in m^2, #monomials x (3 #functions) with i fastest: what the monomials of
    /// the cell, from its middle in edges, find in the divergence. Of a degree below that of the splines.
    Eigen::MatrixXd divergences(const CellPart& part, const std::vector<Eigen::Vector3i>& monomials) const;
    /// int xi^alpha xi^beta dV, m^3, between the same monomials.
    Eigen::MatrixXd monomialProducts(const CellPart& part,
                                     const std::vector<Eigen::Vector3i>& monomials) const;

    /// int phi_a (1, x - c) dV, 4 x #functions, m^3 and m^4; `middle` of the cell from c, m.
    Eigen::Matrix4Xd bodyMoments(const CellPart& part, const Vec3& middle) const;

  private:
    Eigen::VectorXd momentsOf(const CellPart& part) const;
    Gram contracted(const Eigen::VectorXd& moments) const;
    /// Products of the functions in one direction.
    struct Pairs {
        Eigen::MatrixXd powers;    ///< a column for each pair; where (a, b) and (b, a) are the same, for both
        std::vector<int> numbers;  ///< columns of the pairs a + width b
    };
    Eigen::MatrixXd betweenFunctions(const double* pairs, const std::array<const Pairs*, 3>& of,
                                     double scale) const;

    int width_, powers_;  // functions and moments in one direction
    Vec3 edges_;
    Eigen::VectorXd whole_moments_;
    std::array<Pairs, 4> pairs_;              // of phi_a phi_b; [1 of a, 2 of b]: with the slope of a, of b
    std::vector<Eigen::MatrixXd> functions_;  // powers of xi^k phi_a, k up to 1 or below the degree
    std::vector<Eigen::MatrixXd> slopes_;     // and of xi^k phi_a'
    Eigen::MatrixXd squares_;                 // powers of phi_a^2
    Gram whole_;
};

}  // namespace sherd
