#include "bullet/breakable.h"

#include <algorithm>

namespace sherd {

Identity Identity::of(const btRigidBody& body) {
    const btBroadphaseProxy* proxy = body.getBroadphaseHandle();
    return {proxy ? proxy->m_uniqueId : -1, body.getCollisionShape(), body.getInvMass()};
}

namespace {

/// Whether the object at the address of an app's body is a new one. A body that was removed and added again,
/// or that was given another shape or mass while in the world, is still the same.
bool isAnother(const btCollisionObject& object, const Breakable& breakable) {
    if (breakable.ownedHere()) return false;
    const btRigidBody* body = btRigidBody::upcast(&object);
    if (!body) return true;
    const Identity now = Identity::of(*body), &then = breakable.identity;
    return now.proxy != then.proxy && (now.shape != then.shape || now.inverse_mass != then.inverse_mass);
}

}  // namespace

Breakable& BreakableRegistry::add(std::unique_ptr<Breakable> breakable) {
    breakable->identity = Identity::of(*breakable->body);
    by_object_[breakable->body] = breakable.get();
    all_.push_back(std::move(breakable));
    return *all_.back();
}

Breakable* BreakableRegistry::find(const btCollisionObject* object) const {
    const auto found = by_object_.find(object);
    return found == by_object_.end() || isAnother(*object, *found->second) ? nullptr : found->second;
}

std::unique_ptr<Breakable> BreakableRegistry::take(const btCollisionObject* object) {
    const auto entry = std::find_if(all_.begin(), all_.end(),
                                    [&](const auto& breakable) { return breakable->body == object; });
    if (entry == all_.end()) return nullptr;
    std::unique_ptr<Breakable> taken = std::move(*entry);
    all_.erase(entry);
    by_object_.erase(object);
    return taken;
}

void BreakableRegistry::syncWithWorld(const btAlignedObjectArray<btCollisionObject*>& in_world) {
    for (const auto& breakable : all_) breakable->in_world = false;
    for (int i = 0; i < in_world.size(); ++i)
        if (Breakable* breakable = find(in_world[i])) breakable->in_world = true;
    const auto gone = [](const auto& breakable) { return !breakable->in_world && !breakable->ownedHere(); };
    for (const auto& breakable : all_)
        if (gone(breakable)) by_object_.erase(breakable->body);
    all_.erase(std::remove_if(all_.begin(), all_.end(), gone), all_.end());
}

}  // namespace sherd
