#include "core/clustering/nearest_seeds.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "core/clustering/penalty_distance.h"

namespace sherd {

namespace {

/// How much longer distances are under an overstress. Cracks are paid for by the elastic energy that was
/// there, which goes with the square of the stress: pieces of edge d have crack faces of about 1 / d a
/// volume. Right under a contact the stress is that of the load's patch; it counts as `highest`, or all seeds
/// would go there.
double stretch(double overstress) {
    constexpr double highest = 3;
    const double stress = std::clamp(overstress, 1.0, highest);
    return stress * stress;
}

/// Notes a distance from the seed of `label`, if it is among the two smallest of a particle. `may_win`:
/// whether it may become the smallest. Returns whether anything changed.
bool note(TwoNearest& there, int label, double distance, bool may_win) {
    if (may_win && distance < there.distance) {
        if (there.label != label) {
            there.second_label = there.label;
            there.second_distance = there.distance;
        }
        there.label = label;
        there.distance = distance;
        return true;
    }
    if (there.label == label || !(distance < there.second_distance)) return false;
    there.second_label = label;
    there.second_distance = distance;
    return true;
}

}  // namespace

void SeedDistances::addSeed(int seed, int label, std::vector<TwoNearest>& nearest) const {
    using Entry = std::tuple<double, int, bool>;  // distance, particle, whether the seed is its nearest
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
    const auto reach = [&](int i, double distance, bool through_own) {
        const bool wins = through_own && distance < nearest[i].distance;
        if (note(nearest[i], label, distance, through_own)) front.push({distance, i, wins});
    };
    reach(seed, 0, true);
    while (!front.empty()) {
        const auto [distance, i, won] = front.top();
        front.pop();
        const bool outdated = won ? nearest[i].label != label || distance > nearest[i].distance
                                  : nearest[i].second_label != label || distance > nearest[i].second_distance;
        if (outdated) continue;
        for (const int j : solid_.neighbours[i])
            if (damage_.damaged[j]) reach(j, distanceTo(j, seed, i, distance), won);
    }
}

double SeedDistances::distanceTo(int particle, int seed, int previous, double distance_of_previous) const {
    return guide_.kind == GuideField::Kind::none ? distance_of_previous + pathStep(previous, particle)
                                                 : guidedDistance(seed, particle);
}

double SeedDistances::pathStep(int i, int j) const {
    constexpr double through_wall = 0.2;  // a step across the wall counts as this much of one along it
    const double stress = 0.5 * (damage_.overstress[i] + damage_.overstress[j]);
    Vec3 offset = solid_.particles[i].position - solid_.particles[j].position;
    offset -= (1 - through_wall) * offset.dot(axes_[i]) * axes_[i];
    return offset.norm() * stretch(stress);
}

double SeedDistances::guidedDistance(int seed, int particle) const {
    return penaltyDistance(solid_.particles[seed].position, solid_.particles[particle].position, guide_,
                           blow_) *
           stretch(damage_.overstress[particle]);
}

}  // namespace sherd
