#include "bullet/fragments/birth_overlaps.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <unordered_set>

#include "bullet/world/body_travel.h"

namespace sherd {

namespace {

// How deep hulls are in each other Bullet tells anew in each step: what that differs by must not push.
constexpr btScalar fastest_nested_push_m_s = btScalar(0.005);

/// The distance by the two points, which Bullet keeps up to date whatever was written into the contact's
/// distance.
btScalar distanceOf(const btManifoldPoint& point) {
    return (point.getPositionWorldOnA() - point.getPositionWorldOnB()).dot(point.m_normalWorldOnB);
}

bool boundsOverlap(const btCollisionObject& a, const btCollisionObject& b) {
    btVector3 low_a, high_a, low_b, high_b;
    a.getCollisionShape()->getAabb(a.getWorldTransform(), low_a, high_a);
    b.getCollisionShape()->getAabb(b.getWorldTransform(), low_b, high_b);
    return TestAabbAgainstAabb2(low_a, high_a, low_b, high_b);
}

btTransform relativePose(const btCollisionObject& a, const btCollisionObject& b) {
    return a.getWorldTransform().inverse() * b.getWorldTransform();
}

}  // namespace

std::optional<std::pair<BirthOverlaps::Key, BirthOverlaps::Pair>> BirthOverlaps::pairOf(
    btCollisionObject& a, btCollisionObject& b) {
    // Penetration of a static body is not allowed: the fragment would stay inside the floor.
    if (a.isStaticOrKinematicObject() || b.isStaticOrKinematicObject()) return std::nullopt;
    const Key key = std::minmax(giveToken(a), giveToken(b));
    if (key.first == no_token) return std::nullopt;  // an app uses its extension pointer
    const bool in_order = a.getBroadphaseHandle()->m_uniqueId < b.getBroadphaseHandle()->m_uniqueId;
    Pair pair;
    pair.bodies[0] = in_order ? &a : &b;
    pair.bodies[1] = in_order ? &b : &a;
    pair.radius = radiusAboutOrigin(*pair.bodies[1]);
    pair.before = pair.now = relativePose(*pair.bodies[0], *pair.bodies[1]);
    return std::pair(key, pair);
}

void BirthOverlaps::add(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& new_bodies) {
    const std::unordered_set<const void*> is_new(new_bodies.begin(), new_bodies.end());
    const btBroadphasePairArray& bounds = world.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < bounds.size(); ++i) {
        void *a = bounds[i].m_pProxy0->m_clientObject, *b = bounds[i].m_pProxy1->m_clientObject;
        if (!is_new.count(a) && !is_new.count(b)) continue;
        if (auto pair = pairOf(*static_cast<btCollisionObject*>(a), *static_cast<btCollisionObject*>(b)))
            pairs_.insert_or_assign(pair->first, pair->second);
    }
}

void BirthOverlaps::addOverlapping(
    btDiscreteDynamicsWorld& world,
    const std::function<bool(const btCollisionObject&, const btCollisionObject&)>& is_allowed) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        bool overlaps = false;
        for (int p = 0; p < manifold.getNumContacts(); ++p)
            overlaps = overlaps || distanceOf(manifold.getContactPoint(p)) < 0;
        if (!overlaps || !is_allowed(*manifold.getBody0(), *manifold.getBody1())) continue;
        if (auto pair = pairOf(const_cast<btCollisionObject&>(*manifold.getBody0()),
                               const_cast<btCollisionObject&>(*manifold.getBody1()))) {
            pair->second.is_nested = true;
            pairs_.insert(*pair);
        }
    }
}

void BirthOverlaps::copy(const BirthOverlaps& other,
                         const std::function<btCollisionObject*(const btCollisionObject*)>& stand_in) {
    for (const auto& entry : other.pairs_) {
        btCollisionObject *a = stand_in(entry.second.bodies[0]), *b = stand_in(entry.second.bodies[1]);
        if (!a || !b) continue;
        Pair pair = entry.second;
        pair.bodies[0] = a;
        pair.bodies[1] = b;
        pairs_.insert_or_assign(std::minmax(giveToken(*a), giveToken(*b)), pair);
    }
}

bool BirthOverlaps::allows(const btCollisionObject& a, const btCollisionObject& b) const {
    const auto found = pairs_.find(std::minmax(tokenOf(a), tokenOf(b)));
    return found != pairs_.end() && found->second.allowance_m > 0;
}

bool BirthOverlaps::isAwake(const Pair& pair) {
    return pair.bodies[0]->isActive() || pair.bodies[1]->isActive();
}

void BirthOverlaps::dropSeparated(const btDiscreteDynamicsWorld& world) {
    // A body may have been deleted since the last step. If its token is in the world, it is alive, and where
    // it was.
    std::vector<BodyToken> tokens;
    const auto& objects = world.getCollisionObjectArray();
    tokens.reserve(static_cast<std::size_t>(objects.size()));
    for (int i = 0; i < objects.size(); ++i) tokens.push_back(tokenOf(*objects[i]));
    std::sort(tokens.begin(), tokens.end());
    const auto is_in_world = [&](BodyToken token) {
        return std::binary_search(tokens.begin(), tokens.end(), token);
    };
    for (auto entry = pairs_.begin(); entry != pairs_.end();) {
        const auto& [key, pair] = *entry;
        const bool stays = is_in_world(key.first) && is_in_world(key.second) &&
                           (!isAwake(pair) || boundsOverlap(*pair.bodies[0], *pair.bodies[1]));
        entry = stays ? std::next(entry) : pairs_.erase(entry);
    }
}

void BirthOverlaps::measure(Pair& pair, const btPersistentManifold& manifold) {
    const btTransform& frame = pair.bodies[0]->getWorldTransform();
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const btScalar depth = -distanceOf(point);
        if (depth <= pair.measured_m) continue;
        const btVector3 here = frame.invXform(point.getPositionWorldOnB());
        const btVector3 way = here - pair.before * pair.now.invXform(here);
        const btVector3 into_first =
            manifold.getBody0() == pair.bodies[0] ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
        pair.measured_m = depth;
        pair.closed_m = std::max(btScalar(0), way.dot(into_first * frame.getBasis()));
    }
}

/// The depth grows by the distance that the bodies move into each other, and shrinks by no more than they
/// move. A larger change of the measured depth is an error of Bullet's estimate, now or before: a contact
/// that is missed for a step, or found later than at birth.
void BirthOverlaps::update(Pair& pair) {
    const btScalar moved = travel(pair.before, pair.now, pair.radius);
    pair.allowance_m += std::max(btScalar(0), pair.measured_m - (pair.depth_m + pair.closed_m));
    pair.depth_m = std::max(pair.measured_m, pair.depth_m - moved);
    pair.allowance_m = std::min(pair.allowance_m, pair.depth_m);
}

void BirthOverlaps::applyAllowances(btDiscreteDynamicsWorld& world) {
    if (pairs_.empty()) return;
    dropSeparated(world);
    bool any_awake = false;
    for (auto& entry : pairs_) {
        Pair& pair = entry.second;
        if (!isAwake(pair)) continue;
        any_awake = true;
        pair.before = pair.now;
        pair.now = relativePose(*pair.bodies[0], *pair.bodies[1]);
        pair.measured_m = pair.closed_m = 0;
    }
    if (!any_awake) return;
    std::vector<std::pair<Pair*, btPersistentManifold*>> touching;
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const bool is_awake = manifold.getBody0()->isActive() || manifold.getBody1()->isActive();
        if (manifold.getNumContacts() == 0 || !is_awake) continue;
        const auto found =
            pairs_.find(std::minmax(tokenOf(*manifold.getBody0()), tokenOf(*manifold.getBody1())));
        if (found != pairs_.end()) touching.emplace_back(&found->second, &manifold);
    }
    for (const auto& [pair, manifold] : touching) measure(*pair, *manifold);
    for (auto& entry : pairs_)
        if (isAwake(entry.second)) update(entry.second);
    const btContactSolverInfo& info = world.getSolverInfo();
    const btScalar deepest_nested = fastest_nested_push_m_s * info.m_timeStep / info.m_erp2;
    for (const auto& [pair, manifold] : touching)
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            btManifoldPoint& point = manifold->getContactPoint(i);
            btScalar distance = distanceOf(point);
            if (distance < 0) distance = std::min(distance + pair->allowance_m, btScalar(0));
            point.setDistance(pair->is_nested ? std::max(distance, -deepest_nested) : distance);
        }
}

}  // namespace sherd
