#pragma once

#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// Moving least squares (paper, Eq. 6-10) with B-splines of degree p as weights on a complete lattice of
/// particles. The weights then add up to 1 and reproduce x already, so the moment matrix of Eq. 9 has the
/// first row (1, 0, 0, 0) about x and the shape functions are the B-splines themselves: tensor products of
/// degree p whose supports are bricks of (p + 1)^3 cells. They contain all polynomials of degree p.
///
/// - Completeness near the surface takes particles up to p / 2 cells outside it.
/// - Functions live on parts of cells, not on space: a lattice point carries one function for every connected
/// part
///   of the solid in its support, so nothing couples across a gap.
/// - A function that only slivers of the solid see would make the equations singular. Its coefficient is tied
/// to
///   those around the nearest well-filled part, by the extrapolation that is exact for polynomials of degree
///   p (extended B-splines; Hoellig, Reif, Wipper 2001).
struct SplineSpace {
    int degree = 2;
    int function_count = 0;     ///< that carry unknowns
    std::vector<Vec3> centres;  ///< per function: where a linear field is read for its coefficient, m
    std::vector<Eigen::Vector3i>
        points;                          ///< per function: its lattice point, the highest cell of its support
    std::vector<int> component;          ///< per function: connected part of the solid
    std::vector<int> component_of_part;  ///< #parts
    int component_count = 0;

    /// A coefficient as a combination of unknown ones.
    struct Term {
        int function;
        double factor;
    };
    int raw_count = 0;             ///< functions before any are tied
    std::vector<int> term_starts;  ///< raw_count + 1
    std::vector<Term> terms;
    std::vector<std::vector<int>> raw_of;  ///< per part: its (p + 1)^3 raw functions, x fastest

    SplineSpace(const CellParts& solid, int degree);

    int perPart() const { return (degree + 1) * (degree + 1) * (degree + 1); }

    /// Raw coefficients (3 x raw_count) of unknowns (3 * function_count).
    Eigen::Matrix3Xd expand(const Eigen::VectorXd& unknowns) const;
    /// The transpose: what acts on raw functions, as forces at the unknowns.
    Eigen::VectorXd gather(const Eigen::Matrix3Xd& raw) const;
};

/// Values and derivatives (by cell coordinates) of a part's functions at a point of its cell, `xi` from the
/// middle of the cell in edges. Polynomials: beyond the cell they go on.
void splineValues(int degree, const Vec3& xi, std::vector<double>& values);
void splineGradients(int degree, const Vec3& xi, std::vector<Vec3>& gradients);

/// The p + 1 pieces of B-splines on a cell in one direction as polynomials: (k, a) is the factor of xi^k in
/// piece a.
Eigen::MatrixXd splinePowers(int degree);

}  // namespace sherd
