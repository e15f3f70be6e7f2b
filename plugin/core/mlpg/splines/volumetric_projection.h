#pragma once

#include <array>
#include <memory>

#include "core/mlpg/splines/spline_field.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// Volumetric strain of splines of degree p, projected onto polynomials of total degree p - 1 on macro cells
/// of p^3 cells, in L2: on each macro cell it is the sum over its modes of
///     c_k m_k(x),  c_k = int m_k div u dV,  int m_k m_l dV = 1 if k = l, else 0.
/// Where the volume hardly changes (Poisson's ratio near 0.5), div u = 0 at every point is more than the
/// splines can follow, and they lock. A macro cell has as many unknowns as an element Q_p, and as many
/// pressures as the pair Q_p / P_(p-1), which is stable.
/// Strain whose volumetric part is replaced is called B-bar (Hughes 1980; on splines Elguedj et al. 2008;
/// projected locally Antolin et al. 2020). Fields whose div u is such a polynomial are left as they are.
class VolumetricProjection {
  public:
    /// `share_of_part`: weights of the parts (#parts, or empty: 1).
    VolumetricProjection(const CellParts& solid, const SplineSpace& space,
                         const std::vector<double>& share_of_part);
    VolumetricProjection() = default;
    /// Writes a projection, or reads it into one that was made without anything (see archive.h beside this
    /// file).
    template <class Archive>
    void archiveFields(Archive& archive, const CellParts& solid, const SplineSpace& space);

    /// One macro cell.
    struct MacroCell {
        std::vector<int> parts;      ///< ascending
        std::vector<int> functions;  ///< raw ones that reach it, ascending
        Vec3 centre;                 ///< in cells of the grid
        Eigen::MatrixXd modes;       ///< m_k in monomials of cells from `centre`, #modes x #monomials
        Eigen::MatrixXd rates;       ///< c_k per raw coefficient, #modes x (3 #functions)
    };
    const std::vector<MacroCell>& cells() const { return cells_; }

    /// The projected volumetric strain as stress is read with it, of one or more displacements: factors of
    /// the monomials of xi (see dilatationDegree), (#monomials #displacements) x #parts. Between macro cells
    /// it jumps; corners of cells take the mean of all that meet there, which is more exact than any of them.
    /// `raw`: (3 #displacements) x raw_count.
    template <class Scalar>
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    template <class Scalar>
    Matrix<Scalar> dilatation(const Matrix<Scalar>& raw) const;

    /// modulus times int c(u) c(v) over the modes c of both, as forces at the raw functions v, for the
    /// displacement `raw`; both 3 x raw_count.
    Eigen::Matrix3Xd forces(double modulus_pa, const Eigen::Matrix3Xd& raw) const;

  private:
    static constexpr int corner_count = 8;

    static std::vector<int> functionsOf(const SplineSpace& space, const std::vector<int>& parts);
    void findPlaces(const CellParts& solid);
    template <class Scalar>
    void meetAtCorners(Eigen::Index displacements, Matrix<Scalar>& dilatation) const;

    int degree_ = 0;
    std::vector<MacroCell> cells_;
    std::vector<Vec3> offsets_;                           ///< per part: its middle from the centre, in cells
    std::vector<std::array<int, corner_count>> corners_;  ///< per part: of its cell, x fastest
    std::vector<double> weights_;                         ///< per part, in the mean at a corner
    int corner_total_ = 0;
};

/// Whether a material changes its volume so little that displacements held to it point by point lock.
bool isNearlyIncompressible(const Elasticity& elasticity);

/// lambda over the bulk modulus: what a change of lambda tr(eps) I is of the same change of the mean stress
/// and strain together.
double projectedShare(const Elasticity& elasticity);

/// Without lambda: what is left of it where lambda acts on the projected volumetric strain.
Elasticity withoutLambda(Elasticity elasticity);

/// Null where the material changes its volume enough to do without.
std::shared_ptr<const VolumetricProjection> projectionFor(const Elasticity& elasticity,
                                                          const CellParts& solid, const SplineSpace& space,
                                                          const std::vector<double>& share_of_part = {});

/// The field of raw coefficients, with its projected volumetric strain if there is a projection.
SplineField splineField(std::shared_ptr<const CellParts> parts, std::shared_ptr<const SplineSpace> space,
                        Eigen::Matrix3Xd raw, const Elasticity& elasticity,
                        const VolumetricProjection* projection);

}  // namespace sherd
