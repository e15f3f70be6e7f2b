#include "core/clustering/damaged_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sherd {

namespace {

constexpr double across_wall = 0.75;    // of the wall: distance of the outermost particles on its two sides
constexpr double compact_reach = 2.01;  // in spacings of the particles

/// Connected parts with fewer particles are specks. Where particles are further apart than the wall is thick
/// each stands for more of it, and the same part of the wall has fewer.
int smallestPart(double spacing_m, double wall_thickness_m) {
    constexpr double usual = 6;
    const double of_wall = wall_thickness_m / spacing_m;
    return of_wall > 0 && of_wall < 1 ? static_cast<int>(std::lround(usual * of_wall * of_wall))
                                      : static_cast<int>(usual);
}

/// Gives specks of either state that of what surrounds them. A part that touches nothing stays as it is.
std::vector<char> withoutSpecks(const Discretisation& solid, int smallest_part, std::vector<char> state) {
    for (const char speck_state : {char(0), char(1)}) {
        const Parts parts = connectedParts(solid, state);
        std::vector<char> touches(parts.sizes.size());
        for (std::size_t i = 0; i < state.size(); ++i)
            for (int j : solid.neighbours[i])
                touches[parts.of_particle[i]] |= parts.of_particle[j] != parts.of_particle[i];
        for (std::size_t i = 0; i < state.size(); ++i) {
            const int part = parts.of_particle[i];
            if (state[i] == speck_state && parts.sizes[part] < smallest_part && touches[part])
                state[i] = !state[i];
        }
    }
    return state;
}

/// Calls `visit` for every particle that is reached from `first` along the neighbour table by steps along the
/// wall's axis, no further than the wall is thick. Where the axis is not known: by any steps, as far as three
/// quarters of the wall or two particles, whichever is less. `seen_from` (#particles) keeps from which
/// `first` each particle was last reached; start with -1 and call once for each `first`.
template <class Visit>
void forEachThroughWall(const Discretisation& solid, const std::vector<Vec3>& axes, int first, double wall,
                        std::vector<int>& seen_from, const Visit& visit) {
    constexpr double straight = 0.8;  // least cosine between a step and the wall's axis
    const Vec3& axis = axes[first];
    const bool known = !axis.isZero(0);
    const double reach = known ? wall : std::min(across_wall * wall, compact_reach * solid.spacing);
    std::vector<std::pair<int, double>> reached = {{first, 0.0}};  // particle, and how far from the first
    seen_from[first] = first;
    for (std::size_t head = 0; head < reached.size(); ++head) {
        const auto [i, so_far] = reached[head];
        for (const int j : solid.neighbours[i]) {
            const Vec3 offset = solid.particles[j].position - solid.particles[i].position;
            const double distance = so_far + offset.norm();
            if (distance > reach || (known && std::abs(offset.dot(axis)) < straight * offset.norm()))
                continue;
            if (seen_from[j] == first) continue;
            seen_from[j] = first;
            reached.push_back({j, distance});
            visit(j);
        }
    }
}

/// Marks as damaged what lies behind damaged particles through the wall, with the overstress of those: a
/// crack that starts on one side of a wall runs straight through to the other and does not turn to peel it.
Damage throughTheWall(const Discretisation& solid, const std::vector<Vec3>& axes, const Damage& damage,
                      double wall) {
    Damage through = damage;
    std::vector<int> seen_from(damage.damaged.size(), -1);
    for (std::size_t first = 0; first < damage.damaged.size(); ++first) {
        if (!damage.damaged[first]) continue;
        forEachThroughWall(solid, axes, static_cast<int>(first), wall, seen_from, [&](int j) {
            through.damaged[j] = 1;
            if (!(damage.overstress[first] > through.overstress[j])) return;
            through.overstress[j] = damage.overstress[first];
            if (!damage.stress.empty()) through.stress[j] = damage.stress[first];
        });
    }
    return through;
}

}  // namespace

Parts connectedParts(const Discretisation& solid, const std::vector<char>& state) {
    Parts parts;
    parts.of_particle.assign(state.size(), -1);
    std::vector<int> stack;
    for (std::size_t first = 0; first < state.size(); ++first) {
        if (parts.of_particle[first] >= 0) continue;
        const int part = static_cast<int>(parts.sizes.size());
        parts.sizes.push_back(0);
        parts.of_particle[first] = part;
        stack.push_back(static_cast<int>(first));
        while (!stack.empty()) {
            const int i = stack.back();
            stack.pop_back();
            ++parts.sizes[part];
            for (int j : solid.neighbours[i]) {
                if (parts.of_particle[j] >= 0 || state[j] != state[i]) continue;
                parts.of_particle[j] = part;
                stack.push_back(j);
            }
        }
    }
    return parts;
}

Damage damagedRegion(const Discretisation& solid, const std::vector<Vec3>& axes, const Damage& damage,
                     double wall_thickness_m) {
    Damage region = damage;
    const int smallest_part = smallestPart(solid.spacing, wall_thickness_m);
    region.damaged = withoutSpecks(solid, smallest_part, damage.damaged);
    region = throughTheWall(solid, axes, region, wall_thickness_m);
    region.damaged = withoutSpecks(solid, smallest_part, region.damaged);
    return region;
}

int partedOnTheWay(const Discretisation& solid, const std::vector<Vec3>& axes, const Damage& damage,
                   double wall_thickness_m) {
    constexpr double half = 0.5, step = 1.189207115002721;
    constexpr int steps = 16;  // of the load, down to a sixteenth of its peak
    double all = 0, damaged = 0;
    for (std::size_t i = 0; i < damage.damaged.size(); ++i) {
        all += solid.particles[i].volume;
        if (damage.damaged[i]) damaged += solid.particles[i].volume;
    }
    if (!(damaged > half * all)) return 0;
    int most = 0;
    double threshold = 1;
    for (int k = 0; k < steps; ++k) {
        threshold *= step;
        Damage earlier = damage;
        earlier.count = 0;
        for (std::size_t i = 0; i < damage.damaged.size(); ++i)
            earlier.count += earlier.damaged[i] = damage.damaged[i] && damage.overstress[i] > threshold;
        if (earlier.count == 0) break;
        FragmentLabels labels;
        labelWholeParts(solid, damagedRegion(solid, axes, earlier, wall_thickness_m).damaged, labels);
        most = std::max(most, labels.count);
    }
    return most;
}

std::vector<int> labelWholeParts(const Discretisation& solid, const std::vector<char>& damaged,
                                 FragmentLabels& labels) {
    labels.of_particle.assign(damaged.size(), -1);
    const Parts parts = connectedParts(solid, damaged);
    std::vector<int> label_of_part(parts.sizes.size(), -1), rest;
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        if (damaged[i]) {
            rest.push_back(static_cast<int>(i));
            continue;
        }
        int& label = label_of_part[parts.of_particle[i]];
        if (label < 0) label = labels.count++;
        labels.of_particle[i] = label;
    }
    return rest;
}

}  // namespace sherd
