#include "core/mlpg/reduced/damage_reading.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/damage/equivalent_bound.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/monomials.h"
#include "core/numerics/parallel_chunks.h"
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

/// As the parts see it.
struct DamageReading::Displacement {
    Eigen::Matrix4Xf raw;        ///< coefficients of all functions
    Eigen::MatrixXf dilatation;  ///< projected, or empty
};

/// What no point of a part exceeds.
struct DamageReading::Bounds {
    std::vector<float> tension;  ///< Pa, for a scale of 1
    std::vector<double> overstress;
};

/// Reads the stress of one displacement, part by part, and keeps what is nearer to failure than what was read
/// before.
class DamageReading::Reader {
  public:
    Reader(const DamageReading& of, const Displacement& displacement, const ContactReading& contact,
           double scale, const Strength& strength, const Damage& before)
        : of_(of),
          displacement_(displacement),
          projected_share_(static_cast<float>(projectedShare(of.problem_->elasticity))),
          contact_(contact),
          scale_(scale),
          strength_(strength),
          bound_(strength.criterion, strength.material),
          per_edge_(of.problem_->parts().edges.cwiseInverse().cast<float>()),
          overstress(before.overstress),
          worst(before.stress),
          tension(scale > 0 ? before.largest_stress_pa / scale : 0) {}

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
            if (doesNotMatter(widened(of_.bounds_.rangeAt(gradient, is_on_surface), near), wanted, at))
                continue;
            const Vec3 x = ReadingPoints::position(of_.problem_->parts(), part, point);
            include(x, x, gradient, point.normal, at, at, wanted);
        }
    }

    template <int degree>
    void readPlace(std::size_t number) {
        const ContactReading::Place& place = contact_.places()[number];
        const Coefficients<degree> coefficients = coefficientsOf<degree>(place.where.part);
        const Eigen::Matrix3f gradient =
            projectedGradient<degree>(coefficients, place.where.part, place.where.xi.cast<float>());
        include(place.position, place.near_at, gradient, place.normal, place.nearest,
                contact_.numberOfPlace(number), near_to_failure);
    }

    template <int degree>
    Coefficients<degree> coefficientsOf(int part) const {
        Coefficients<degree> coefficients;
        const std::vector<int>& functions = of_.problem_->space->raw_of[part];
        for (std::size_t f = 0; f < coefficients.size(); ++f)
            coefficients[f] = displacement_.raw.col(functions[f]).array();
        return coefficients;
    }

    /// Of the stress at x. `normal`: of the surface there, or zero; `at`: the point whose strength and
    /// particle count there; `number`: in the contact's reading.
    void include(const Vec3& x, const Vec3& near_at, const Eigen::Matrix3f& gradient,
                 const Eigen::Vector3f& normal, int at, int number, double wanted) {
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
            doesNotMatter(principalRange(toMatrix(stress).cast<float>(), 0, 0), wanted, at))
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

    bool doesNotMatter(const PrincipalRange& range, double wanted, int at) const {
        const double least = std::max(wanted, overstress[of_.points_.points[at].particle]);
        return range.largest <= tension &&
               scale_ * bound_(range.smallest, range.largest) < least * strength_.at_points[at];
    }

    /// Displacement gradient with the dilatation that the stiffness sees.
    template <int degree>
    Eigen::Matrix3f projectedGradient(const Coefficients<degree>& coefficients, int part,
                                      const Eigen::Vector3f& at) const {
        Eigen::Matrix3f gradient = gradientAt<degree>(coefficients.data(), at);
        const Eigen::MatrixXf& dilatation = displacement_.dilatation;
        if (dilatation.size() > 0)
            projectTrace(gradient, polynomialAt(dilatationDegree(degree), dilatation.col(part), at),
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
    const Displacement& displacement_;
    float projected_share_;
    const ContactReading& contact_;
    double scale_;
    const Strength& strength_;
    EquivalentBound bound_;
    Eigen::Vector3f per_edge_;  ///< of a cell

  public:
    std::vector<double> overstress;      ///< per particle, the largest that was read
    std::vector<SymmetricTensor> worst;  ///< per particle, the stress that made it, Pa
    double tension;                      ///< the largest that was read, Pa, for a scale of 1
};

/// The least strength at the points of a part.
double DamageReading::weakest(int part, const Strength& strength) const {
    double least = std::numeric_limits<double>::infinity();
    for (int at = points_.starts[part]; at < points_.starts[part + 1]; ++at)
        least = std::min(least, strength.at_points[at]);
    return least;
}

DamageReading::Bounds DamageReading::boundsOf(const Displacement& displacement, const ContactReading& contact,
                                              double scale, const Strength& strength) const {
    const EquivalentBound equivalent_bound(strength.criterion, strength.material);
    const auto ranges = bounds_.ranges(displacement.raw, problem_->space->raw_of, displacement.dilatation);
    Bounds bounds;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const int part = static_cast<int>(i);
        const PrincipalRange range =
            contact.hasNearField() ? widened(ranges[i], contact.nearBound(part)) : ranges[i];
        const bool has_points = points_.starts[i] < points_.starts[i + 1];
        bounds.tension.push_back(has_points ? range.largest : 0);
        bounds.overstress.push_back(has_points ? scale * equivalent_bound(range.smallest, range.largest) /
                                                     weakest(part, strength)
                                               : 0);
    }
    return bounds;
}

Damage DamageReading::damage(const Eigen::VectorXf& unknowns, const ContactField& contact, double scale,
                             const Strength& strength) const {
    Damage damage;
    addDamage(unknowns, contactReading(contact), scale, strength, damage);
    return damage;
}

void DamageReading::addDamage(const Eigen::VectorXf& unknowns, const ContactReading& contact, double scale,
                              const Strength& strength, Damage& sum) const {
    constexpr int chunk_count = 8;  // however many threads there are, so that all read the same points
    constexpr int first_parts = 8;
    sum.overstress.resize(problem_->solid->particles.size(), 0.0);
    sum.stress.resize(sum.overstress.size(), SymmetricTensor::Zero());
    Displacement displacement{expand(unknowns), {}};
    if (problem_->projection)
        displacement.dilatation = problem_->projection->dilatation<float>(displacement.raw.topRows<3>());
    const Bounds bounds = boundsOf(displacement, contact, scale, strength);
    const auto reader = [&] { return Reader(*this, displacement, contact, scale, strength, sum); };
    const auto take = [&](const Reader& read) {
        for (std::size_t i = 0; i < sum.overstress.size(); ++i) {
            if (!(read.overstress[i] > sum.overstress[i])) continue;
            sum.overstress[i] = read.overstress[i];
            sum.stress[i] = read.worst[i];
        }
        sum.largest_stress_pa = std::max(sum.largest_stress_pa, scale * read.tension);
    };
    const auto has_failed = [&] {
        return std::any_of(sum.overstress.begin(), sum.overstress.end(), [](double o) { return o > 1; });
    };

    // From the highest bound down, so that few parts are read before the largest stress is known.
    std::vector<int> order(bounds.tension.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return bounds.tension[a] > bounds.tension[b]; });
    const int part_count = static_cast<int>(order.size());
    {
        Reader first = reader();
        for (std::size_t place = 0; place < contact.places().size(); ++place) first.readPlace(place);
        for (int i = 0; i < std::min(first_parts, part_count); ++i) first.read(order[i], 1);
        take(first);
    }
    const auto read = [&](double wanted) {
        std::vector<std::optional<Reader>> readers(chunk_count);
        forEachChunk(chunk_count, [&](int chunk) {
            Reader& own = readers[chunk].emplace(reader());
            for (int i = chunk; i < part_count; i += chunk_count)
                if (bounds.tension[order[i]] > own.tension || bounds.overstress[order[i]] >= wanted)
                    own.read(order[i], wanted);
        });
        for (const auto& own : readers) take(*own);
    };
    const bool fails_at_once = has_failed();
    if (!fails_at_once) read(1);
    if (fails_at_once || has_failed()) read(near_to_failure);  // what is near to failure steers the cracks

    sum.damaged.clear();
    for (const double overstress : sum.overstress) sum.damaged.push_back(overstress > 1);
    sum.count = static_cast<int>(std::count(sum.damaged.begin(), sum.damaged.end(), 1));
}

}  // namespace sherd
