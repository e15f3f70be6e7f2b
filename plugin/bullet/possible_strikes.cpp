#include "bullet/possible_strikes.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <limits>

#include "bullet/body_travel.h"
#include "bullet/contact_motion.h"

namespace sherd {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double untouched = -1;  // instead of an energy

/// Whether its velocities tell how all its points move: it is neither a link nor moved by the app.
bool movesAsRigidBody(const btCollisionObject& object) {
    return btRigidBody::upcast(&object) && !object.isKinematicObject();
}

/// Of the energy that a strike with a certain speed brings, in `blowEnergy`: with all of the striker's mass,
/// as though the body were held, or all of the body's where the striker does not give way.
double massOf(const Breakable& struck, const btCollisionObject& striker) {
    const btRigidBody* body = btRigidBody::upcast(&striker);
    return body && canMove(*body) ? 1 / double(body->getInvMass()) : struck.asset.solid()->mass();
}

}  // namespace

void PossibleStrikes::add(const btPersistentManifold& manifold) {
    if (manifold.getNumContacts() == 0) return;
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const Breakable *of_a = breakables_.of(a), *of_b = breakables_.of(b);
    if (!of_a && !of_b) return;
    const double speed = fastestMeeting(manifold);
    if (of_a) add(*of_a, b, speed);
    if (of_b) add(*of_b, a, speed);
}

void PossibleStrikes::add(const Breakable& struck, const btCollisionObject& striker, double speed_m_s) {
    const auto place = static_cast<std::size_t>(struck.body->getWorldArrayIndex());
    if (place >= energy_j_.size()) energy_j_.resize(place + 1, untouched);
    energy_j_[place] =
        std::max(energy_j_[place], 0.0) + 0.5 * massOf(struck, striker) * speed_m_s * speed_m_s;
}

bool PossibleStrikes::mayBreak(const Breakable& breakable) const {
    const auto place = static_cast<std::size_t>(breakable.body->getWorldArrayIndex());
    const double energy = place < energy_j_.size() ? energy_j_[place] : untouched;
    return !(energy < 0) && !(energy < breakable.least_energy_j);
}

double PossibleStrikes::fastestMeeting(const btPersistentManifold& manifold) const {
    using Speeds = std::array<double, MANIFOLD_CACHE_SIZE>;  // along the normals of its points
    Speeds speeds{};
    const auto count = static_cast<std::size_t>(manifold.getNumContacts());
    double fall = 0;
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()}) {
        if (!btRigidBody::upcast(object) && object->isStaticObject()) continue;
        if (!movesAsRigidBody(*object)) return infinite;
        const btRigidBody& body = *btRigidBody::upcast(object);
        const BodyState* known = before_.find(object);
        const BodyState state = known ? *known : stateOf(body);
        const double reach = radiusAboutOrigin(body), side = object == manifold.getBody0() ? -1 : 1;
        for (std::size_t i = 0; i < count; ++i) {
            const btVector3& normal = manifold.getContactPoint(static_cast<int>(i)).m_normalWorldOnB;
            speeds[i] += side * state.linear.dot(normal) + reach * state.angular.cross(normal).length();
        }
        // They may have met within the step, slower or faster by what gravity gives meanwhile.
        if (falls(body, state.linear, time_step_s_)) fall += 1.5 * time_step_s_ * body.getGravity().length();
    }
    return std::max(0.0, *std::max_element(speeds.begin(), speeds.begin() + static_cast<long>(count)) + fall);
}

}  // namespace sherd
