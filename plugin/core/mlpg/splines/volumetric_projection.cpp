#include "core/mlpg/splines/volumetric_projection.h"

#include <algorithm>
#include <cmath>

#include "core/mlpg/splines/macro_cells.h"
#include "core/mlpg/splines/monomials.h"
#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/raw_functions.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int chunk_count = 16;

/// Polynomials up to a total degree that are orthonormal in `products` (of monomials), one a row. Those that
/// differ from the ones before by rounding only, as across a sliver, are left out.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& products, const std::vector<Eigen::Vector3i>& monomials,
                            int total_degree) {
    constexpr double rounding = 1e-9;
    const long count = products.rows();
    Eigen::MatrixXd modes(count, count);
    long found = 0;
    for (long m = 0; m < count; ++m) {
        if (monomials[m].sum() > total_degree) continue;
        Eigen::VectorXd mode = Eigen::VectorXd::Unit(count, m);
        for (int pass = 0; pass < 2; ++pass)  // twice is enough (Kahan, Parlett)
            for (long k = 0; k < found; ++k) {
                const double along = modes.row(k) * products * mode;
                mode -= along * modes.row(k).transpose();
            }
        const double squared = mode.dot(products * mode);
        if (squared > rounding * products(m, m)) modes.row(found++) = mode / std::sqrt(squared);
    }
    return modes.topRows(found);
}

int placeOf(const std::vector<int>& functions, int function) {
    return static_cast<int>(std::lower_bound(functions.begin(), functions.end(), function) -
                            functions.begin());
}

/// Middle of a part's cell from the centre of its macro cell, in cells.
Vec3 offsetOf(const CellPart& part, const VolumetricProjection::MacroCell& cell) {
    return part.cell.cast<double>() + Vec3::Constant(0.5) - cell.centre;
}

/// Integrals of monomials over a part, see PartIntegrals.
struct Monomials {
    std::vector<Eigen::Vector3i> monomials;
    Eigen::MatrixXd products, divergences;

    Monomials() = default;
    Monomials(const PartIntegrals& integrals, const CellPart& part, std::vector<Eigen::Vector3i> up_to)
        : monomials(std::move(up_to)),
          products(integrals.monomialProducts(part, monomials)),
          divergences(integrals.divergences(part, monomials)) {}
};

/// Everything of a macro cell that follows from its parts.
void measure(const CellParts& solid, const SplineSpace& space, const PartIntegrals& integrals,
             const Monomials& of_whole, const std::vector<double>& share_of_part,
             VolumetricProjection::MacroCell& cell) {
    const std::vector<Eigen::Vector3i>& monomials = of_whole.monomials;
    const auto share = [&](int part) { return share_of_part.empty() ? 1 : share_of_part[part]; };
    double volume = 0;
    Vec3 first = Vec3::Zero();
    for (const int part : cell.parts) {
        const Vec3 centroid = (solid.centroid(solid.parts[part]) - solid.origin).cwiseQuotient(solid.edges);
        volume += share(part) * solid.parts[part].fill;
        first += share(part) * solid.parts[part].fill * centroid;
    }
    cell.centre = first / volume;

    const auto count = static_cast<long>(monomials.size());
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
    Eigen::MatrixXd divergence = Eigen::MatrixXd::Zero(count, 3L * static_cast<long>(cell.functions.size()));
    for (const int p : cell.parts) {
        const CellPart& part = solid.parts[p];
        const Eigen::MatrixXd shifted = share(p) * monomialsShifted(monomials, offsetOf(part, cell));
        const Monomials cut = part.moments.empty() ? Monomials{} : Monomials(integrals, part, monomials);
        const Monomials& own_part = part.moments.empty() ? of_whole : cut;
        products += shifted * own_part.products * shifted.transpose() / share(p);
        const Eigen::MatrixXd own = shifted * own_part.divergences;
        for (int a = 0; a < space.perPart(); ++a)
            divergence.middleCols<3>(3L * placeOf(cell.functions, space.raw_of[p][a])) +=
                own.middleCols<3>(3L * a);
    }
    cell.modes = orthonormal(products, monomials, space.degree - 1);
    cell.rates = cell.modes * divergence;
}

}  // namespace

std::vector<int> VolumetricProjection::functionsOf(const SplineSpace& space, const std::vector<int>& parts) {
    std::vector<int> functions;
    for (const int part : parts)
        functions.insert(functions.end(), space.raw_of[part].begin(), space.raw_of[part].end());
    std::sort(functions.begin(), functions.end());
    functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
    return functions;
}

VolumetricProjection::VolumetricProjection(const CellParts& solid, const SplineSpace& space,
                                           const std::vector<double>& share_of_part)
    : degree_(space.degree) {
    for (std::vector<int>& parts : macroCells(solid, space.degree)) {
        cells_.emplace_back();
        cells_.back().functions = functionsOf(space, parts);
        cells_.back().parts = std::move(parts);
    }
    const PartIntegrals integrals(space.degree, solid.edges);
    const Monomials of_whole(integrals, CellPart{}, monomialsOf(space.degree - 1));
    const int cell_count = static_cast<int>(cells_.size());
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, cell_count);
        for (int c = chunkBegin(chunk, chunk_count, cell_count); c < end; ++c)
            measure(solid, space, integrals, of_whole, share_of_part, cells_[c]);
    });
    findPlaces(solid);
}

/// What follows from the parts of each macro cell.
void VolumetricProjection::findPlaces(const CellParts& solid) {
    const RawFunctions at_corners(solid, 1);  // as splines of degree 1 they know which parts meet
    corner_total_ = at_corners.count();
    offsets_.resize(solid.parts.size());
    corners_.resize(solid.parts.size());
    weights_.clear();
    for (const CellPart& part : solid.parts) weights_.push_back(part.fill);
    for (const MacroCell& cell : cells_)
        for (const int part : cell.parts) {
            offsets_[part] = offsetOf(solid.parts[part], cell);
            std::copy_n(at_corners.of_part[part].begin(), corner_count, corners_[part].begin());
        }
}

template <class Scalar>
auto VolumetricProjection::dilatation(const Matrix<Scalar>& raw) const -> Matrix<Scalar> {
    const int read_degree = dilatationDegree(degree_);
    const auto monomials = monomialsOf(degree_ - 1);
    const auto read_count = static_cast<long>(monomialsOf(read_degree).size());
    const Eigen::Index displacements = raw.rows() / 3;
    Matrix<Scalar> result =
        Matrix<Scalar>::Zero(read_count * displacements, raw.cols() > 0 ? long(offsets_.size()) : 0);
    Matrix<Scalar> amplitudes;
    for (const MacroCell& cell : cells_) {
        amplitudes.setZero(cell.modes.rows(), displacements);
        for (size_t f = 0; f < cell.functions.size(); ++f)
            amplitudes.noalias() +=
                cell.rates.middleCols<3>(3L * static_cast<long>(f)).template cast<Scalar>() *
                raw.col(cell.functions[f]).reshaped(3, displacements);
        for (const int part : cell.parts) {
            const Matrix<Scalar> readings =
                (cell.modes * monomialsShifted(monomials, offsets_[part])).template cast<Scalar>();
            // A constant is the first of the monomials of any degree; higher degrees are read as they are.
            result.col(part).reshaped(read_count, displacements).topRows(readings.cols()) =
                readings.transpose() * amplitudes;
        }
    }
    meetAtCorners(displacements, result);
    return result;
}

/// Adds to each part what is trilinear between the corners of its cell and takes it there to the mean of the
/// parts that meet.
template <class Scalar>
void VolumetricProjection::meetAtCorners(Eigen::Index displacements, Matrix<Scalar>& dilatation) const {
    const int read_degree = dilatationDegree(degree_);
    const auto monomials = monomialsOf(read_degree);
    const auto count = static_cast<long>(monomials.size());
    Matrix<Scalar> at_corners(corner_count, count), hats = Matrix<Scalar>::Zero(count, corner_count);
    for (int n = 0; n < corner_count; ++n) {
        const Vec3 corner = Vec3(n & 1, n >> 1 & 1, n >> 2 & 1) - Vec3::Constant(0.5);
        for (long m = 0; m < count; ++m) {
            const Eigen::Vector3i& of = monomials[m];
            double value = 1, hat = of.maxCoeff() > 1 ? 0 : 1;
            for (int d = 0; d < 3; ++d)
                for (int k = 0; k < of[d]; ++k) value *= corner[d];
            for (int d = 0; d < 3; ++d) hat *= of[d] == 0 ? 0.5 : 2 * corner[d];
            at_corners(n, m) = static_cast<Scalar>(value);
            hats(m, n) = static_cast<Scalar>(hat);
        }
    }
    Matrix<Scalar> sums = Matrix<Scalar>::Zero(displacements, corner_total_);
    std::vector<double> weights(corner_total_, 0.0);
    for (size_t part = 0; part < corners_.size(); ++part) {
        const Matrix<Scalar> own =
            at_corners * dilatation.col(static_cast<long>(part)).reshaped(count, displacements);
        for (int n = 0; n < corner_count; ++n) {
            sums.col(corners_[part][n]) += static_cast<Scalar>(weights_[part]) * own.row(n).transpose();
            weights[corners_[part][n]] += weights_[part];
        }
    }
    for (size_t part = 0; part < corners_.size(); ++part) {
        auto factors = dilatation.col(static_cast<long>(part)).reshaped(count, displacements);
        Matrix<Scalar> off = -at_corners * factors;
        for (int n = 0; n < corner_count; ++n)
            off.row(n) +=
                sums.col(corners_[part][n]).transpose() / static_cast<Scalar>(weights[corners_[part][n]]);
        factors += hats * off;
    }
}

template auto VolumetricProjection::dilatation(const Matrix<float>& raw) const -> Matrix<float>;
template auto VolumetricProjection::dilatation(const Matrix<double>& raw) const -> Matrix<double>;

Eigen::Matrix3Xd VolumetricProjection::forces(double modulus_pa, const Eigen::Matrix3Xd& raw) const {
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, raw.cols());
    Eigen::VectorXd amplitudes;
    for (const MacroCell& cell : cells_) {
        amplitudes.setZero(cell.modes.rows());
        const auto count = static_cast<long>(cell.functions.size());
        for (long f = 0; f < count; ++f)
            amplitudes += cell.rates.middleCols<3>(3 * f) * raw.col(cell.functions[f]);
        amplitudes *= modulus_pa;
        for (long f = 0; f < count; ++f)
            forces.col(cell.functions[f]) += cell.rates.middleCols<3>(3 * f).transpose() * amplitudes;
    }
    return forces;
}

bool isNearlyIncompressible(const Elasticity& elasticity) {
    constexpr double from_poisson_ratio = 0.451;  // 0.45 is a common value: no rounding may decide
    return elasticity.lambda_pa > 2 * from_poisson_ratio * (elasticity.lambda_pa + elasticity.mu_pa);
}

double projectedShare(const Elasticity& elasticity) {
    return elasticity.lambda_pa / (elasticity.lambda_pa + 2 * elasticity.mu_pa / 3);
}

Elasticity withoutLambda(Elasticity elasticity) {
    elasticity.lambda_pa = 0;
    return elasticity;
}

std::shared_ptr<const VolumetricProjection> projectionFor(const Elasticity& elasticity,
                                                          const CellParts& solid, const SplineSpace& space,
                                                          const std::vector<double>& share_of_part) {
    if (!isNearlyIncompressible(elasticity)) return nullptr;
    return std::make_shared<const VolumetricProjection>(solid, space, share_of_part);
}

SplineField splineField(std::shared_ptr<const CellParts> parts, std::shared_ptr<const SplineSpace> space,
                        Eigen::Matrix3Xd raw, const Elasticity& elasticity,
                        const VolumetricProjection* projection) {
    SplineField field{std::move(parts), std::move(space), std::move(raw), {}, projectedShare(elasticity)};
    if (projection) field.dilatation = projection->dilatation<double>(field.raw);
    return field;
}

}  // namespace sherd
