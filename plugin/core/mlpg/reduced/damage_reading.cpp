#include "core/mlpg/reduced/damage_reading.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/damage/equivalent_bound.h"
#include "core/mlpg/reduced/gradient_lanes.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/monomials.h"
#include "core/numerics/parallel_chunks.h"
#include "core/stress/stress_lanes.h"

namespace sherd {

namespace {

constexpr double near_to_failure = 0.5;            // overstress from which it steers cracks
constexpr double far_beyond = 3, much_more = 1.5;  // overstress to which it does, and what matters beyond

PrincipalRange widened(PrincipalRange range, double by_pa) {
    range.smallest -= static_cast<float>(by_pa);
    range.largest += static_cast<float>(by_pa);
    return range;
}

/// Where the bounds of the tension are highest: there the largest stress is found, and few others are read
/// then.
std::vector<int> highest(const std::vector<float>& bounds, std::size_t most) {
    std::vector<int> order(bounds.size());
    std::iota(order.begin(), order.end(), 0);
    const std::size_t count = std::min(most, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<long>(count), order.end(),
                      [&](int a, int b) { return bounds[a] != bounds[b] ? bounds[a] > bounds[b] : a < b; });
    order.resize(count);
    return order;
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
    std::vector<double> at_points(points_.points.size());
    const auto part_count = static_cast<int>(points_.starts.size()) - 1;
    const int chunk_count = strength.hasField() ? 1 : 16;
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, part_count);
        for (int part = chunkBegin(chunk, chunk_count, part_count); part < end; ++part)
            for (int at = points_.starts[part]; at < points_.starts[part + 1]; ++at)
                at_points[at] =
                    strength.at(ReadingPoints::position(problem_->parts(), part, points_.points[at]));
    });
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
/// before. Points wait until there are as many as lanes; `finish` reads the last ones.
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
          overstress_(before.overstress),
          tension_(scale > 0 ? before.largest_stress_pa / scale : 0) {}

    /// Whether an overstress in a part of up to `bound` may be one that matters.
    bool mayFindMore(int part, double bound, double wanted) const {
        if (bound < wanted) return false;
        for (int at = of_.points_.starts[part]; at < of_.points_.starts[part + 1]; ++at)
            if (bound >= leastThatMatters(of_.points_.points[at].particle, wanted)) return true;
        return false;
    }

    /// Reads the points of a part that may be as near to failure as the overstress `wanted`, or under the
    /// largest tension.
    void read(int part, double wanted) {
        takeCoefficients(part);
        const double near = contact_.hasNearField() ? contact_.nearBound(part) : 0;
        const int end = of_.points_.starts[part + 1];
        for (int first = of_.points_.starts[part]; first < end; first += GradientLanes::count) {
            const int count = std::min(GradientLanes::count, end - first);
            GradientLanes::Lane is_on_surface = {};
            for (int l = 0; l < count; ++l) {
                const ReadingPoint& point = of_.points_.points[first + l];
                setPoint(l, point.xi);
                is_on_surface[l] = point.normal.isZero(0) ? 0 : 1;
            }
            readGradients(part, count);
            StressBounds::RangeLanes ranges;
            of_.bounds_.rangesAt(gradients_, is_on_surface, ranges);
            for (int l = 0; l < count; ++l) {
                if (doesNotMatter(ranges.smallest[l] - near, ranges.largest[l] + near, wanted, first + l))
                    continue;
                const ReadingPoint& point = of_.points_.points[first + l];
                const Vec3 x = ReadingPoints::position(of_.problem_->parts(), part, point);
                wait(l, {x, point.normal, first + l, wanted, SymmetricTensor::Zero()});
            }
        }
    }

    /// Reads the stress at the places of the contact, which are none of the points.
    void readPlaces() {
        const std::vector<ContactReading::Place>& places = contact_.places();
        for (std::size_t first = 0; first < places.size();) {
            const int part = places[first].where.part;
            takeCoefficients(part);
            int count = 0;
            for (; count < GradientLanes::count && first + count < places.size(); ++count) {
                if (places[first + count].where.part != part) break;
                setPoint(count, places[first + count].where.xi.cast<float>());
            }
            readGradients(part, count);
            for (int l = 0; l < count; ++l, ++first) {
                const ContactReading::Place& place = places[first];
                wait(l, {place.position, place.normal, place.nearest, near_to_failure, place.unresolved});
            }
        }
    }

    /// Reads what waits.
    void finish() {
        StressLanes stress;
        PlaceLanes::Lane smallest, largest;
        stressOf(of_.problem_->elasticity, waiting_.gradient, stress);
        contact_.addNearStress(waiting_.at, stress);
        for (int i = 0; i < 6; ++i)
            for (int l = 0; l < PlaceLanes::count; ++l) stress.s[i][l] += waiting_.unresolved.s[i][l];
        applyTraction(waiting_.surface, of_.problem_->elasticity, stress);
        boundPrincipal(stress, smallest, largest);
        for (int l = 0; l < waiting_.count; ++l)
            if (!doesNotMatter(smallest[l], largest[l], waiting_.wanted[l], waiting_.point[l]))
                include(stress.at(l), waiting_.point[l]);
        waiting_.count = 0;
    }

    /// The stress that is nearest to failure at a particle, so far.
    struct Found {
        int particle;
        double overstress;
        SymmetricTensor stress;  ///< Pa
    };
    const std::vector<Found>& found() const { return found_; }
    double tension() const { return tension_; }

  private:
    /// Where the stress is read. `normal`: of the surface there, or zero; `point`: whose strength and
    /// particle count there; `unresolved`: see SurfacePlace.
    struct Spot {
        Vec3 x;
        Eigen::Vector3f normal;
        int point;
        double wanted;
        SymmetricTensor unresolved;
    };

    struct Waiting {
        int count = 0;
        PlaceLanes at = {};
        StressLanes unresolved = {};
        PlaceLanes::Lane gradient[3][3] = {};
        SurfaceLanes surface = {};
        int point[PlaceLanes::count];
        double wanted[PlaceLanes::count];
    };

    void takeCoefficients(int part) {
        const std::vector<int>& functions = of_.problem_->space->raw_of[part];
        for (std::size_t f = 0; f < functions.size(); ++f)
            std::copy_n(displacement_.raw.col(functions[f]).data(), 4, coefficients_.of_function[f]);
    }

    void setPoint(int lane, const Eigen::Vector3f& xi) {
        for (int d = 0; d < 3; ++d) gradients_.xi[d][lane] = xi[d];
    }

    /// Displacement gradients with the dilatation that the stiffness sees.
    void readGradients(int part, int count) {
        const int degree = of_.problem_->space->degree;
        findGradients(degree, of_.powers_, coefficients_, per_edge_, gradients_);
        const Eigen::MatrixXf& dilatation = displacement_.dilatation;
        if (dilatation.size() == 0) return;
        for (int l = 0; l < count; ++l) {
            const Eigen::Vector3f xi(gradients_.xi[0][l], gradients_.xi[1][l], gradients_.xi[2][l]);
            Eigen::Matrix3f gradient = Eigen::Matrix3f::Zero();
            for (int d = 0; d < 3; ++d) gradient(d, d) = gradients_.gradient[d][d][l];
            projectTrace(gradient, polynomialAt(dilatationDegree(degree), dilatation.col(part), xi),
                         projected_share_);
            for (int d = 0; d < 3; ++d) gradients_.gradient[d][d][l] = gradient(d, d);
        }
    }

    /// `lane`: of the gradients.
    void wait(int lane, const Spot& spot) {
        const int to = waiting_.count++;
        const bool is_known = !spot.normal.isZero(0) && !contact_.isLoaded(spot.x);
        waiting_.surface.is_known[to] = is_known ? 1 : 0;
        const Vec3 normal = spot.normal.cast<double>();
        const Vec3 traction =
            is_known ? contact_.tractionAt(spot.x, normal.normalized()) : Vec3(Vec3::Zero());
        for (int i = 0; i < 3; ++i) {
            waiting_.at.x[i][to] = spot.x[i];
            waiting_.surface.normal[i][to] = normal[i];
            waiting_.surface.traction_pa[i][to] = traction[i];
            for (int d = 0; d < 3; ++d) waiting_.gradient[i][d][to] = gradients_.gradient[i][d][lane];
        }
        for (int i = 0; i < 6; ++i) waiting_.unresolved.s[i][to] = spot.unresolved[i];
        waiting_.point[to] = spot.point;
        waiting_.wanted[to] = spot.wanted;
        if (waiting_.count == PlaceLanes::count) finish();
    }

    void include(const SymmetricTensor& stress, int point) {
        const PrincipalStresses principal = principalStresses(stress);
        const double equivalent = strength_.criterion.equivalent_stress_pa(principal, strength_.material);
        const int particle = of_.points_.points[point].particle;
        const double own = scale_ / strength_.at_points[point] * equivalent;
        if (own > overstress_[particle]) {
            overstress_[particle] = own;
            found_.push_back({particle, own, scale_ * stress});
        }
        tension_ = std::max(tension_, principal.largest);
    }

    double leastThatMatters(int particle, double wanted) const {
        const double known = overstress_[particle];
        return std::max(wanted, known > far_beyond ? much_more * known : known);
    }

    /// `smallest_pa`, `largest_pa`: no principal stress is beyond these.
    bool doesNotMatter(double smallest_pa, double largest_pa, double wanted, int point) const {
        const double least = leastThatMatters(of_.points_.points[point].particle, wanted);
        return largest_pa <= tension_ &&
               scale_ * bound_(smallest_pa, largest_pa) < least * strength_.at_points[point];
    }

    const DamageReading& of_;
    const Displacement& displacement_;
    float projected_share_;
    const ContactReading& contact_;
    double scale_;
    const Strength& strength_;
    EquivalentBound bound_;
    Eigen::Vector3f per_edge_;  ///< of a cell
    PartCoefficients coefficients_;
    GradientLanes gradients_ = {};
    Waiting waiting_;
    std::vector<double> overstress_;  ///< per particle, the largest that was read
    std::vector<Found> found_;        ///< of a particle each time nearer to failure
    double tension_;                  ///< the largest that was read, Pa, for a scale of 1
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
    // As they lie in memory, which takes longest, and yet shared out, since those under a contact are
    // neighbours.
    constexpr int parts_of_block = 32;
    constexpr int first_parts = 8;
    sum.overstress.resize(problem_->solid->particles.size(), 0.0);
    sum.stress.resize(sum.overstress.size(), SymmetricTensor::Zero());
    Displacement displacement{expand(unknowns), {}};
    if (problem_->projection)
        displacement.dilatation = problem_->projection->dilatation<float>(displacement.raw.topRows<3>());
    const Bounds bounds = boundsOf(displacement, contact, scale, strength);
    const auto reader = [&] { return Reader(*this, displacement, contact, scale, strength, sum); };
    const auto take = [&](const Reader& read) {
        for (const Reader::Found& found : read.found()) {
            if (!(found.overstress > sum.overstress[found.particle])) continue;
            sum.overstress[found.particle] = found.overstress;
            sum.stress[found.particle] = found.stress;
        }
        sum.largest_stress_pa = std::max(sum.largest_stress_pa, scale * read.tension());
    };
    const auto has_failed = [&] {
        return std::any_of(sum.overstress.begin(), sum.overstress.end(), [](double o) { return o > 1; });
    };

    const int part_count = static_cast<int>(bounds.tension.size());
    {
        Reader first = reader();
        first.readPlaces();
        for (const int part : highest(bounds.tension, first_parts)) first.read(part, 1);
        first.finish();
        take(first);
    }
    const auto read = [&](double wanted) {
        std::vector<std::optional<Reader>> readers(chunk_count);
        forEachChunk(chunk_count, [&](int chunk) {
            Reader& own = readers[chunk].emplace(reader());
            for (int begin = parts_of_block * chunk; begin < part_count;
                 begin += parts_of_block * chunk_count)
                for (int part = begin; part < std::min(begin + parts_of_block, part_count); ++part)
                    if (bounds.tension[part] > own.tension() ||
                        own.mayFindMore(part, bounds.overstress[part], wanted))
                        own.read(part, wanted);
            own.finish();
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
