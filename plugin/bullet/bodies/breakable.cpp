#include "bullet/bodies/breakable.h"

#include <algorithm>
#include <limits>

#include "bullet/bodies/joint_anchors.h"
#include "fracture/can_break.h"
#include "fracture/debris.h"

namespace sherd {

namespace {

/// Whether the object at the address of an app's body is a new one. Ours are alive as long as they are
/// listed.
bool isAnother(const btCollisionObject& object, const Breakable& breakable) {
    return !breakable.ownedHere() && tokenOf(object) != breakable.token;
}

}  // namespace

bool Breakable::breaksAt(double time_s) const {
    return time_s >= unbreakable_until_s &&
           asset.solid()->moments().volume >= fracture->smallest_fragment_m3 &&
           (fracture->largest_generation == 0 || generation < fracture->largest_generation);
}

void Breakable::noteLeastEnergy() {
    const bool has_to_say = !warned && !asset.warnings().empty();
    const bool says_all = fracture->check_with_full_solve || has_to_say;
    least_energy_j = says_all ? 0 : leastEnergy(*asset.solid(), *fracture);
}

std::shared_ptr<const FractureSettings> fractureSettingsFor(const BreakableAsset& asset,
                                                            FractureSettings fracture) {
    fracture.smallest_fragment_m3 = smallestFragment(*asset.solid(), fracture);
    return std::make_shared<const FractureSettings>(std::move(fracture));
}

Breakable::~Breakable() {
    keepForJoints(std::move(owned.body), token);
}

Breakable& BreakableRegistry::add(std::unique_ptr<Breakable> breakable) {
    const auto former = by_object_.find(breakable->body);
    if (former != by_object_.end()) take(former->second->token);  // dead: two bodies never share an address
    breakable->token = giveToken(*breakable->body);
    by_object_[breakable->body] = breakable.get();
    places_.clear();
    all_.push_back(std::move(breakable));
    return *all_.back();
}

Breakable* BreakableRegistry::find(const btCollisionObject* object) const {
    const auto found = by_object_.find(object);
    return found == by_object_.end() || isAnother(*object, *found->second) ? nullptr : found->second;
}

Breakable* BreakableRegistry::of(const btCollisionObject& alive) const {
    const auto place = static_cast<std::size_t>(alive.getWorldArrayIndex());  // huge: in no world
    if (place >= places_.size() || places_[place].object != &alive) return find(&alive);
    Breakable* known = places_[place].breakable;
    return known && !isAnother(alive, *known) ? known : nullptr;
}

std::unique_ptr<Breakable> BreakableRegistry::take(BodyToken token) {
    const auto entry = std::find_if(all_.begin(), all_.end(),
                                    [&](const auto& breakable) { return breakable->token == token; });
    if (entry == all_.end()) return nullptr;
    std::unique_ptr<Breakable> taken = std::move(*entry);
    all_.erase(entry);
    places_.clear();
    by_object_.erase(taken->body);
    return taken;
}

Breakable* BreakableRegistry::listed(const btCollisionObject* object, int place) const {
    const auto index = static_cast<std::size_t>(place);
    if (index < places_.size() && places_[index].object == object) return places_[index].breakable;
    const auto found = by_object_.find(object);
    return found == by_object_.end() ? nullptr : found->second;
}

void BreakableRegistry::syncWithWorld(const btAlignedObjectArray<btCollisionObject*>& in_world) {
    for (const auto& breakable : all_) breakable->in_world = false;
    any_in_world_ = any_fragment_in_world_ = false;
    places_.resize(in_world.size());
    for (int i = 0; i < in_world.size(); ++i) {
        const Place& place = places_[i] = {in_world[i], listed(in_world[i], i)};
        if (!place.breakable || isAnother(*place.object, *place.breakable)) continue;
        place.breakable->in_world = any_in_world_ = true;
        any_fragment_in_world_ = any_fragment_in_world_ || place.breakable->isFragment();
    }
}

double BreakableRegistry::leastEnergyInWorld() const {
    double least_j = std::numeric_limits<double>::infinity();
    for (const auto& breakable : all_)
        if (breakable->in_world) least_j = std::min(least_j, breakable->least_energy_j);
    return least_j;
}

void BreakableRegistry::dropReplaced(const btAlignedObjectArray<btCollisionObject*>& in_world) {
    for (int i = 0; i < in_world.size(); ++i) {
        const Breakable* found = listed(in_world[i], i);
        if (found && isAnother(*in_world[i], *found)) take(found->token);
    }
}

}  // namespace sherd
