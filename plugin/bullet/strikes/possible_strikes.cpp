#include "bullet/strikes/possible_strikes.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bullet/island/contact_motion.h"
#include "bullet/world/body_travel.h"

namespace sherd {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr btScalar alike = btScalar(0.95);  // cosine of the angle between normals of one side
constexpr double uneven = 1.25;  // times the energy that normals of one side let a blow have (broughtAtMost)

/// Whether its velocities tell how all its points move: it is neither a link nor moved by the app.
bool movesAsRigidBody(const btCollisionObject& object) {
    return btRigidBody::upcast(&object) && !object.isKinematicObject();
}

}  // namespace

void PossibleStrikes::add(const btPersistentManifold& manifold) {
    if (manifold.getNumContacts() == 0) return;
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const Breakable *of_a = breakables_.of(a), *of_b = breakables_.of(b);
    if (!of_a && !of_b) return;
    const Meeting meeting = fastestMeeting(manifold);
    if (of_a) add(*of_a, b, meeting);
    if (of_b) add(*of_b, a, meeting);
}

void PossibleStrikes::add(const Breakable& struck, const btCollisionObject& striker, const Meeting& meeting) {
    const auto place = static_cast<std::size_t>(struck.body->getWorldArrayIndex());
    if (place >= strikers_.size()) strikers_.resize(place + 1);
    Strikers& all = strikers_[place];
    all.touches = true;
    if (!givesWay(striker)) {
        if (all.sliding_stop_m_s == 0) all.stop_normal = meeting.normal;
        all.stops_on_sides =
            all.stops_on_sides || meeting.on_sides || std::abs(all.stop_normal.dot(meeting.normal)) < alike;
        all.stop_m_s = std::max(all.stop_m_s, meeting.along);
        all.sliding_stop_m_s = std::max(all.sliding_stop_m_s, meeting.whole);
        return;
    }
    const double mass = 1 / double(btRigidBody::upcast(&striker)->getInvMass());
    const double speed = meeting.on_sides && meeting.along > 0 ? meeting.whole : meeting.along;
    all.mass_kg += mass;
    all.momentum_n_s += mass * speed;
    all.energy_j += 0.5 * mass * speed * speed;
}

// As `broughtAtMost` has it: with all of the strikers' masses, as though the body were held, each faster by
// what the body may run away with from it, and all of the body's where something does not give way.
bool PossibleStrikes::mayBreak(const Breakable& breakable) const {
    const auto place = static_cast<std::size_t>(breakable.body->getWorldArrayIndex());
    if (place >= strikers_.size() || !strikers_[place].touches) return false;
    const Strikers& all = strikers_[place];
    const double mass = all.mass_kg + breakable.asset.solid()->mass();
    const double stop = all.stops_on_sides && all.stop_m_s > 0 ? all.sliding_stop_m_s : all.stop_m_s;
    const double energy = all.energy_j + stop * (all.momentum_n_s + 0.5 * mass * stop);
    return !(uneven * energy < breakable.least_energy_j);
}

PossibleStrikes::Meeting PossibleStrikes::fastestMeeting(const btPersistentManifold& manifold) const {
    using Speeds = std::array<double, MANIFOLD_CACHE_SIZE>;  // along the normals of its points
    Speeds speeds{};
    const auto count = static_cast<std::size_t>(manifold.getNumContacts());
    double fall = 0, spin = 0;
    btVector3 passing(0, 0, 0);
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()}) {
        if (!btRigidBody::upcast(object) && object->isStaticObject()) continue;
        if (!movesAsRigidBody(*object))
            return {infinite, infinite, manifold.getContactPoint(0).m_normalWorldOnB};
        const btRigidBody& body = *btRigidBody::upcast(object);
        const BodyState* known = before_.find(object);
        const BodyState state = known ? *known : stateOf(body);
        const double reach = radiusAboutOrigin(body), side = object == manifold.getBody0() ? -1 : 1;
        for (std::size_t i = 0; i < count; ++i) {
            const btVector3& normal = manifold.getContactPoint(static_cast<int>(i)).m_normalWorldOnB;
            speeds[i] += side * state.linear.dot(normal) + reach * state.angular.cross(normal).length();
        }
        passing += btScalar(side) * state.linear;
        spin += reach * state.angular.length();
        // They may have met within the step, slower or faster by what gravity gives meanwhile.
        if (falls(body, state.linear, time_step_s_)) fall += 1.5 * time_step_s_ * body.getGravity().length();
    }
    const double along = *std::max_element(speeds.begin(), speeds.begin() + static_cast<long>(count));
    Meeting meeting{std::max(0.0, along + fall), passing.length() + spin + fall,
                    manifold.getContactPoint(0).m_normalWorldOnB};
    for (std::size_t i = 1; i < count; ++i) {
        const btVector3& normal = manifold.getContactPoint(static_cast<int>(i)).m_normalWorldOnB;
        meeting.on_sides = meeting.on_sides || normal.dot(meeting.normal) < alike;
    }
    return meeting;
}

}  // namespace sherd
