#include "core/loads/foundation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

#include "core/loads/footprint.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double flatness = 0.05;             // depth of a foundation, in wall thicknesses
constexpr double largest_tilt = 2e-3;         // of a body that rests, against its foundation
constexpr double faint = 1e-3;                // stiffness that counts, against the foundation's greatest
constexpr double widest = 4;                  // heights over a foundation within which it is not faint
constexpr std::size_t most_foundations = 16;  // in a heap: those that carry most, which most of it goes to
constexpr double most_points = 200;           // of a foundation, about
constexpr double points_in_all = 400;         // of those of a heap, which have 25 each at least
constexpr double parts_per_way = 8;  // from a load to a part: the bed's stiffness changes over that way

/// Contacts that become one foundation.
struct Group {
    const ContactImpulse* first = nullptr;
    std::vector<Vec3> points;
    Vec3 push = Vec3::Zero();
    double impulse_n_s = 0;
};

/// Leaves the groups that carry most.
void keepHardest(std::vector<Group>& groups) {
    if (groups.size() <= most_foundations) return;
    std::vector<double> impulses;
    for (const Group& group : groups) impulses.push_back(group.impulse_n_s);
    std::nth_element(impulses.begin(), impulses.begin() + most_foundations, impulses.end(), std::greater<>());
    const double enough = impulses[most_foundations];
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [&](const Group& group) { return group.impulse_n_s <= enough; }),
                 groups.end());
}

std::vector<Group> groupsOf(const Blow& blow) {
    std::vector<Group> groups;
    for (const ContactImpulse& contact : blow.contacts) {
        if (!contact.supports()) continue;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return group.first->partner == contact.partner &&
                   group.first->normal.dot(contact.normal) > push_alike;
        });
        Group& group = same == groups.end() ? groups.emplace_back() : *same;
        if (!group.first) group.first = &contact;
        group.points.push_back(contact.point);
        group.push += contact.normal;
        group.impulse_n_s += contact.pushed();
    }
    keepHardest(groups);
    for (Group& group : groups) group.push.normalize();
    return groups;
}

/// A load over a foundation: its place in the plane, its height over it, and its share of the whole.
struct Above {
    Vec2 place;
    double height_m, share;
};

/// Of the bed's stiffness right below a load.
double stiffnessBelow(const std::vector<Above>& loads, const Vec2& place) {
    double stiffness = 0;
    for (const Above& load : loads) {
        const double slope = (place - load.place).norm() / load.height_m, q = 1 + slope * slope;
        stiffness += load.share / (q * q * std::sqrt(q));
    }
    return stiffness;
}

/// Where a load comes from.
struct Source {
    Vec3 point;
    double share;
};

std::vector<Source> sourcesOf(const Blow& blow, const Strike& strike) {
    std::vector<Source> sources;
    for (const StrikePoint& point : strike.points) sources.push_back({point.spot.point, point.share});
    if (sources.empty() && blow.stack.strike.strikes()) sources.push_back({blow.stack.strike.point, 1});
    return sources;
}

std::vector<Above> loadsAbove(const std::vector<Source>& sources, const Footprint& footprint,
                              const Vec3& plane, double least_height) {
    std::vector<Above> loads;
    for (const Source& source : sources) {
        const double height = std::abs((source.point - plane).dot(footprint.push()));
        loads.push_back({footprint.project(source.point), std::max(height, least_height), source.share});
    }
    return loads;
}

/// Between points of a foundation: as close as its width and the pressure below the loads ask for.
double pointSpacing(const Footprint& footprint, const std::vector<Above>& loads, double points) {
    double height = std::numeric_limits<double>::infinity();
    for (const Above& load : loads) height = std::min(height, load.height_m);
    const double below = loads.size() * pi * widest * widest * height * height;
    return std::max(std::min(height / 2, footprint.width() / 4),
                    std::sqrt(std::min(footprint.area(), below) / points));
}

/// Short below the loads and longer away from them, where the bed is faint and even.
double longestPart(const Footprint& footprint, const std::vector<Above>& loads, double shortest,
                   const Vec2& place, double reach) {
    double way = std::numeric_limits<double>::infinity();
    for (const Above& load : loads) way = std::min(way, (place - load.place).norm());
    return std::max(shortest, std::min((way - reach) / parts_per_way, footprint.width() / 4));
}

/// Puts parts that lie in the same square of a grid together, each with its share of the stiffness.
std::vector<FoundationPoint> merged(const std::vector<FootprintPart>& parts, const std::vector<double>& areas,
                                    const Footprint& footprint, double size) {
    std::map<std::array<long, 2>, FoundationPoint> squares;
    double sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Vec2 place = footprint.project(parts[i].centre) / size;
        FoundationPoint& square = squares[{std::lround(place.x()), std::lround(place.y())}];
        square.position += areas[i] * parts[i].centre;
        square.share += areas[i];
        sum += areas[i];
    }
    std::vector<FoundationPoint> points;
    for (const auto& [place, square] : squares)
        if (square.share > 0) points.push_back({square.position / square.share, square.share / sum});
    return points;
}

/// What every part counts for: its area, times the bed's stiffness there over the greatest, m^2.
std::vector<double> countedAreas(const std::vector<FootprintPart>& parts, const std::vector<Above>& loads,
                                 const Footprint& footprint) {
    std::vector<double> areas;
    for (const FootprintPart& part : parts)
        areas.push_back(stiffnessBelow(loads, footprint.project(part.centre)));
    const double greatest = parts.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
    for (std::size_t i = 0; i < parts.size(); ++i)
        areas[i] = areas[i] > faint * greatest ? parts[i].area_m2 * areas[i] / greatest : 0;
    return areas;
}

double nearestDistance(const std::vector<FoundationPoint>& points, const std::vector<Source>& sources) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const FoundationPoint& point : points)
        for (const Source& source : sources)
            nearest = std::min(nearest, (point.position - source.point).norm());
    return nearest;
}

Foundation foundationOf(const ContactBody& body, const Group& group, const Mobility& partner,
                        const std::vector<Source>& sources, double points, const ContactSettings& settings) {
    const double margin = settings.smallest_patch * body.wall_thickness_m;
    const Footprint footprint(group.points, group.push, margin);
    const std::vector<Above> loads = loadsAbove(sources, footprint, group.points.front(), margin);
    const double size = pointSpacing(footprint, loads, points);
    const double depth = flatness * body.wall_thickness_m + largest_tilt * footprint.length();
    const auto longest = [&](const Vec2& place, double reach) {
        return longestPart(footprint, loads, size, place, reach);
    };
    const std::vector<FootprintPart> parts = partsOver(body.surface, footprint, longest, depth);
    const std::vector<double> areas = countedAreas(parts, loads, footprint);
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);

    Foundation foundation;
    foundation.push = group.push;
    foundation.points = merged(parts, areas, footprint, size);
    foundation.stiffness_n_m = 2 * contactModulus(body, *group.first, settings) * std::sqrt(area / pi);
    foundation.distance_m = nearestDistance(foundation.points, sources);
    foundation.partner_number = group.first->partner;
    foundation.partner = partner;
    return foundation;
}

}  // namespace

std::vector<Foundation> foundationsOf(const ContactBody& body, const Blow& blow, const Strike& strike,
                                      const ContactSettings& settings) {
    std::vector<Foundation> foundations;
    const std::vector<Source> sources = sourcesOf(blow, strike);
    if (sources.empty()) return foundations;
    const std::vector<Group> groups = groupsOf(blow);
    const double points = std::min(most_points, points_in_all / std::max<std::size_t>(1, groups.size()));
    for (const Group& group : groups) {
        Foundation foundation =
            foundationOf(body, group, blow.partner(group.first->partner), sources, points, settings);
        if (!foundation.points.empty()) foundations.push_back(std::move(foundation));
    }
    return foundations;
}

}  // namespace sherd
