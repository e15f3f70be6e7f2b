#pragma once

#include "core/mlpg/splines/spline_ties.h"

namespace sherd {

/// Moving least squares (paper, Eq. 6-10) with B-splines of degree p as weights on a complete lattice of
/// particles. The weights then add up to 1 and reproduce x already, so the moment matrix of Eq. 9 has the
/// first row (1, 0, 0, 0) about x and the shape functions are the B-splines themselves: tensor products of
/// degree p whose supports are bricks of (p + 1)^3 cells. They contain all polynomials of degree p.
/// Completeness near the surface takes particles up to p / 2 cells outside it.
struct SplineSpace {
    int degree = 0;
    int component_count = 0;
    std::vector<int> component_of_part;  ///< #parts: connected component of the solid

    int raw_count = 0;                     ///< functions before any are tied
    std::vector<std::vector<int>> raw_of;  ///< per part: its (p + 1)^3 raw functions, x fastest

    int function_count = 0;                      ///< that carry unknowns
    std::vector<Vec3> greville_points;           ///< per function, m: a linear field's value there is its
                                                 ///< coefficient
    std::vector<Eigen::Vector3i> highest_cells;  ///< per function: of its support
    std::vector<int> component;                  ///< per function: connected component of the solid

    SplineSpace() = default;
    SplineSpace(const CellParts& solid, int degree);
    /// Writes the space of a solid, or reads it (see archive.h beside this file).
    template <class Archive>
    void archiveFields(Archive& archive, const CellParts& solid);

    int perPart() const { return (degree + 1) * (degree + 1) * (degree + 1); }

    /// A raw coefficient in terms of the unknown ones.
    struct Terms {
        const SplineTies::Term *first, *last;
        const SplineTies::Term* begin() const { return first; }
        const SplineTies::Term* end() const { return last; }
    };
    Terms termsOf(int raw) const {
        const SplineTies::Term* terms = ties_.terms.data();
        return {terms + ties_.starts[raw], terms + ties_.starts[raw + 1]};
    }

    /// Raw coefficients (3 x raw_count) of unknowns (3 * function_count).
    Eigen::Matrix3Xd expand(const Eigen::VectorXd& unknowns) const;
    /// The transpose: what acts on raw functions, as forces at the unknowns.
    Eigen::VectorXd gather(const Eigen::Matrix3Xd& raw) const;

  private:
    SplineSpace(const CellParts& solid, RawFunctions raw);
    void findGrevillePoints(const CellParts& solid);

    SplineTies ties_;
};

}  // namespace sherd
