#include "core/mlpg/reduced/damage_reading.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/damage/equivalent_bound.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/monomials.h"
#include "core/stress/surface_traction.h"

namespace sherd {

namespace {

constexpr double near_to_failure = 0.5;  // overstress from which it steers cracks

PrincipalRange widened(PrincipalRange range, double by_pa) {
    range.smallest -= static_cast<float>(by_pa);
    range.largest += static_cast<float>(by_pa);
    return range;
}

}  // namespace

DamageReading::DamageReading(std::shared_ptr<const SplineProblem> problem,
                             const std::vector<GridPoint>& samples)
    : DamageReading(problem, ReadingPoints(*problem->solid, samples),
                    StressBounds(problem->parts(), problem->space->degree, problem->elasticity, samples)) {}

DamageReading::DamageReading(std::shared_ptr<const SplineProblem> problem, ReadingPoints points,
                             StressBounds bounds)
    : problem_(std::move(problem)),
      points_(std::move(points)),
      faces_(points_),
      powers_(splinePowers(problem_->space->degree).cast<float>()),
      bounds_(std::move(bounds)) {}

std::vector<double> DamageReading::strengths(const MaterialStrength& strength) const {
    std::vector<double> at_points;
    at_points.reserve(points_.points.size());
    for (std::size_t part = 0; part + 1 < points_.starts.size(); ++part)
        for (int at = points_.starts[part]; at < points_.starts[part + 1]; ++at)
            at_points.push_back(strength.at(
                ReadingPoints::position(problem_->parts(), static_cast<int>(part), points_.points[at])));
    return at_points;
}

Eigen::Matrix4Xf DamageReading::expand(const Eigen::VectorXf& unknowns) const {
    const SplineSpace& space = *problem_->space;
    Eigen::Matrix4Xf raw = Eigen::Matrix4Xf::Zero(4, space.raw_count);
    for (int r = 0; r < space.raw_count; ++r)
        for (const SplineTies::Term& term : space.termsOf(r))
            raw.col(r).head<3>() += static_cast<float>(term.factor) * unknowns.segment<3>(3L * term.function);
    return raw;
}

/// Reads the stress of one displacement, part by part.
class DamageReading::Reader {
  public:
    Reader(const DamageReading& of, const Eigen::Matrix4Xf& raw, const Eigen::MatrixXf& dilatation,
           const ContactReading& contact, double scale, const Strength& strength)
        : of_(of),
          raw_(raw),
          dilatation_(dilatation),
          projected_share_(static_cast<float>(projectedShare(of.problem_->elasticity))),
          contact_(contact),
          scale_(scale),
          strength_(strength),
          bound_(strength.criterion, strength.material),
          per_edge_(of.problem_->parts().edges.cwiseInverse().cast<float>()),
          overstress(of.problem_->solid->particles.size(), 0.0),
          worst(overstress.size(), SymmetricTensor::Zero()) {}

    /// Reads the points of a part that may be as near to failure as the overstress `wanted`, or under the
    /// largest tension.
    void read(int part, double wanted) {
        switch (of_.problem_->space->degree) {
            case 1:
                return read<1>(part, wanted);
            case 2:
                return read<2>(part, wanted);
            default:
                static_assert(largest_spline_degree == 3);
                return read<3>(part, wanted);
        }
    }

    /// Reads the stress at a place of the contact, which is none of the points.
    void readPlace(std::size_t place) {
        switch (of_.problem_->space->degree) {
            case 1:
                return readPlace<1>(place);
            case 2:
                return readPlace<2>(place);
            default:
                return readPlace<3>(place);
        }
    }

  private:
    using Quad = Eigen::Array4f;  // a vector and a zero
    template <int degree>
    using Coefficients = std::array<Quad, (degree + 1) * (degree + 1) * (degree + 1)>;

    template <int degree>
    void read(int part, double wanted) {
        const Coefficients<degree> coefficients = coefficientsOf<degree>(part);
        const double near = contact_.hasNearField() ? contact_.nearBound(part) : 0;
        for (int at = of_.points_.starts[part]; at < of_.points_.starts[part + 1]; ++at) {
            const ReadingPoint& point = of_.points_.points[at];
            const bool is_on_surface = !point.normal.isZero(0);
            const Eigen::Matrix3f gradient = projectedGradient<degree>(coefficients, part, point.xi);
            const double failing = wanted * strength_.at_points[at];
            if (doesNotMatter(widened(of_.bounds_.rangeAt(gradient, is_on_surface), near), failing)) continue;
            const Vec3 x = ReadingPoints::position(of_.problem_->parts(), part, point);
            include(x, x, gradient, point.normal, at, at, failing);
        }
    }

    template <int degree>
    void readPlace(std::size_t number) {
        const ContactReading::Place& place = contact_.places()[number];
        const Coefficients<degree> coefficients = coefficientsOf<degree>(place.where.part);
        const Eigen::Matrix3f gradient =
            projectedGradient<degree>(coefficients, place.where.part, place.where.xi.cast<float>());
        include(place.position, place.near_at, gradient, place.normal, place.nearest,
                contact_.numberOfPlace(number), near_to_failure * strength_.at_points[place.nearest]);
    }

    template <int degree>
    Coefficients<degree> coefficientsOf(int part) const {
        Coefficients<degree> coefficients;
        const std::vector<int>& functions = of_.problem_->space->raw_of[part];
        for (std::size_t f = 0; f < coefficients.size(); ++f)
            coefficients[f] = raw_.col(functions[f]).array();
        return coefficients;
    }

    /// Of the stress at x. `normal`: of the surface there, or zero; `at`: the point whose strength and
    /// particle count there; `number`: in the contact's reading.
    void include(const Vec3& x, const Vec3& near_at, const Eigen::Matrix3f& gradient,
                 const Eigen::Vector3f& normal, int at, int number, double failing_pa) {
        const Elasticity& elasticity = of_.problem_->elasticity;
        Mat3 whole = elasticity.stress(gradient.cast<double>());
        if (contact_.hasNearField()) whole += contact_.nearStress(number, near_at);
        SymmetricTensor stress = toSymmetricTensor(whole);
        if (!normal.isZero(0)) {
            const Vec3 outward = normal.cast<double>().normalized();
            if (!contact_.isLoaded(x))
                stress = withTraction(stress, outward, contact_.tractionAt(x, outward), elasticity);
        }
        // The bound of what was freed, or joined with the near field, is much closer; finding its eigenvalues
        // costs more than all before.
        if ((contact_.hasNearField() || !normal.isZero(0)) &&
            doesNotMatter(principalRange(toMatrix(stress).cast<float>(), 0, 0), failing_pa))
            return;
        const PrincipalStresses principal = principalStresses(stress);
        const double equivalent = strength_.criterion.equivalent_stress_pa(principal, strength_.material);
        const int particle = of_.points_.points[at].particle;
        const double own = scale_ / strength_.at_points[at] * equivalent;
        if (own > overstress[particle]) {
            overstress[particle] = own;
            worst[particle] = scale_ * stress;
        }
        tension = std::max(tension, principal.largest);
    }

    bool doesNotMatter(const PrincipalRange& range, double failing_pa) const {
        return range.largest <= tension && scale_ * bound_(range.smallest, range.largest) < failing_pa;
    }

    /// Displacement gradient with the dilatation that the stiffness sees.
    template <int degree>
    Eigen::Matrix3f projectedGradient(const Coefficients<degree>& coefficients, int part,
                                      const Eigen::Vector3f& at) const {
        Eigen::Matrix3f gradient = gradientAt<degree>(coefficients.data(), at);
        if (dilatation_.size() > 0)
            projectTrace(gradient, polynomialAt(dilatationDegree(degree), dilatation_.col(part), at),
                         projected_share_);
        return gradient;
    }

    /// Displacement gradient, summed one direction after the other.
    template <int degree>
    Eigen::Matrix3f gradientAt(const Quad* coefficients, const Eigen::Vector3f& at) const {
        constexpr int w = degree + 1;
        float values[3][w], slopes[3][w];
        for (int d = 0; d < 3; ++d)
            for (int a = 0; a < w; ++a) {
                float value = 0, slope = 0;
                for (int k = w - 1; k >= 0; --k) {
                    slope = slope * at[d] + value;
                    value = value * at[d] + of_.powers_(k, a);
                }
                values[d][a] = value;
                slopes[d][a] = slope;
            }
        Quad by_x = Quad::Zero(), by_y = Quad::Zero(), by_z = Quad::Zero();
        for (int c = 0; c < w; ++c) {
            Quad plane = Quad::Zero(), plane_x = Quad::Zero(), plane_y = Quad::Zero();
            for (int b = 0; b < w; ++b) {
                Quad line = Quad::Zero(), line_x = Quad::Zero();
                for (int a = 0; a < w; ++a) {
                    const Quad& own = coefficients[(c * w + b) * w + a];
                    line += values[0][a] * own;
                    line_x += slopes[0][a] * own;
                }
                plane += values[1][b] * line;
                plane_x += values[1][b] * line_x;
                plane_y += slopes[1][b] * line;
            }
            by_x += values[2][c] * plane_x;
            by_y += values[2][c] * plane_y;
            by_z += slopes[2][c] * plane;
        }
        Eigen::Matrix3f gradient;
        gradient.col(0) = by_x.head<3>() * per_edge_[0];
        gradient.col(1) = by_y.head<3>() * per_edge_[1];
        gradient.col(2) = by_z.head<3>() * per_edge_[2];
        return gradient;
    }

    const DamageReading& of_;
    const Eigen::Matrix4Xf& raw_;
    const Eigen::MatrixXf& dilatation_;  ///< projected, or empty
    float projected_share_;
    const ContactReading& contact_;
    double scale_;
    const Strength& strength_;
    EquivalentBound bound_;
    Eigen::Vector3f per_edge_;  ///< of a cell

  public:
    std::vector<double> overstress;      ///< per particle, the largest that was read
    std::vector<SymmetricTensor> worst;  ///< per particle, the stress that made it, Pa
    double tension = 0;                  ///< the largest that was read
};

/// The least strength at the points of a part.
double DamageReading::weakest(int part, const Strength& strength) const {
    double least = std::numeric_limits<double>::infinity();
    for (int at = points_.starts[part]; at < points_.starts[part + 1]; ++at)
        least = std::min(least, strength.at_points[at]);
    return least;
}

Damage DamageReading::damage(const Eigen::VectorXf& unknowns, const ContactField& contact, double scale,
                             const Strength& strength) const {
    return damage(unknowns, contactReading(contact), scale, strength);
}

Damage DamageReading::damage(const Eigen::VectorXf& unknowns, const ContactReading& contact, double scale,
                             const Strength& strength) const {
    const Eigen::Matrix4Xf raw = expand(unknowns);
    Eigen::MatrixXf dilatation;
    if (problem_->projection) dilatation = problem_->projection->dilatation<float>(raw.topRows<3>());
    Reader reader(*this, raw, dilatation, contact, scale, strength);
    for (std::size_t place = 0; place < contact.places().size(); ++place) reader.readPlace(place);
    const EquivalentBound equivalent_bound(strength.criterion, strength.material);
    std::vector<PrincipalRange> ranges = bounds_.ranges(raw, problem_->space->raw_of, dilatation);
    if (contact.hasNearField())
        for (std::size_t part = 0; part < ranges.size(); ++part)
            ranges[part] = widened(ranges[part], contact.nearBound(static_cast<int>(part)));
    const int part_count = static_cast<int>(ranges.size());

    std::vector<double> overstress_bound(ranges.size());
    std::vector<std::pair<float, int>> by_tension;
    for (int part = 0; part < part_count; ++part) {
        const PrincipalRange& range = ranges[part];
        overstress_bound[part] =
            scale * equivalent_bound(range.smallest, range.largest) / weakest(part, strength);
        if (points_.starts[part] < points_.starts[part + 1]) by_tension.push_back({range.largest, part});
    }
    // From the highest bound down, so that few parts are read before the largest stress is known.
    std::make_heap(by_tension.begin(), by_tension.end());
    while (!by_tension.empty() && by_tension.front().first > reader.tension) {
        std::pop_heap(by_tension.begin(), by_tension.end());
        reader.read(by_tension.back().second, 1);
        by_tension.pop_back();
    }
    for (const auto& [tension, part] : by_tension)
        if (overstress_bound[part] >= 1) reader.read(part, 1);

    Damage damage;
    const auto failed = [](double overstress) { return overstress > 1; };
    if (std::any_of(reader.overstress.begin(), reader.overstress.end(), failed))
        for (int part = 0; part < part_count; ++part)  // what is near to failure steers the cracks
            if (overstress_bound[part] >= near_to_failure) reader.read(part, near_to_failure);
    damage.overstress = std::move(reader.overstress);
    for (const double overstress : damage.overstress) damage.damaged.push_back(failed(overstress));
    damage.count = static_cast<int>(std::count(damage.damaged.begin(), damage.damaged.end(), 1));
    damage.stress = std::move(reader.worst);
    damage.largest_stress_pa = scale * reader.tension;
    return damage;
}

}  // namespace sherd
