#include "core/mlpg/reduced/damage_reading.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/damage/equivalent_bound.h"
#include "core/mlpg/reduced/damage_reader.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {

namespace {

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

/// What no point of a part exceeds.
struct DamageReading::Bounds {
    std::vector<float> tension;  ///< Pa, for a scale of 1
    std::vector<double> overstress;
};

/// The least strength at the points of a part.
double DamageReading::weakest(int part, const Strength& strength) const {
    double least = std::numeric_limits<double>::infinity();
    for (int at = points_.starts[part]; at < points_.starts[part + 1]; ++at)
        least = std::min(least, strength.at_points[at]);
    return least;
}

DamageReading::Bounds DamageReading::boundsOf(const PartDisplacement& displacement,
                                              const ContactReading& contact, double scale,
                                              const Strength& strength) const {
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
    PartDisplacement displacement{expand(unknowns), {}};
    if (problem_->projection)
        displacement.dilatation = problem_->projection->dilatation<float>(displacement.raw.topRows<3>());
    const Bounds bounds = boundsOf(displacement, contact, scale, strength);
    const DamageSource source{*problem_, points_, bounds_, powers_};
    const auto reader = [&] { return DamageReader(source, displacement, contact, scale, strength, sum); };
    const auto take = [&](const DamageReader& read) {
        for (const DamageReader::Found& found : read.found()) {
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
        DamageReader first = reader();
        first.readPlaces();
        for (const int part : highest(bounds.tension, first_parts)) first.read(part, 1);
        first.finish();
        take(first);
    }
    const auto read = [&](double wanted) {
        std::vector<std::optional<DamageReader>> readers(chunk_count);
        forEachChunk(chunk_count, [&](int chunk) {
            DamageReader& own = readers[chunk].emplace(reader());
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
