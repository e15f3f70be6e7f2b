#include "bullet/schedule/foreseen_blow.h"

#include <algorithm>
#include <cmath>

namespace sherd {

namespace {

// What a strike may differ by from the foreseen one, in parts of the particle spacing and of the speed: far
// less than the stress is exact to.
constexpr double same_place = 0.1, same_speed = 0.01, same_direction = 1e-3;
// What presses without striking: in parts of the body's radius, and the cosine of an angle.
constexpr double about_there = 0.35, about_so = 0.9, standing_m_s = 0.05;
constexpr double light = 0.02;  // of the struck body's mass: what supports it has more
// Of the strike: a contact that a blow lifts the body off presses by chance, and takes nothing of the blow.
constexpr double hardly = 1e-3;

using Partners = std::vector<BodyToken>;

bool isAbout(double a, double b) {
    return std::abs(a - b) <= same_speed * std::abs(a);
}

/// The app may have changed what a partner weighs.
bool areAsHeavy(const Mobility& a, const Mobility& b) {
    return isAbout(a.inverse_mass, b.inverse_mass) &&
           (a.inverse_inertia - b.inverse_inertia).norm() <= same_speed * a.inverse_inertia.norm();
}

/// And how the app holds back the turns of the struck body.
bool areTurnsAlike(const Blow& a, const Blow& b) {
    if (!a.free_turns || !b.free_turns) return !a.free_turns && !b.free_turns;
    return (*a.free_turns - *b.free_turns).norm() <= same_speed;
}

/// And where it strikes with.
bool areSameSurfaces(const ContactImpulse& a, const ContactImpulse& b, double spacing) {
    if (!a.partner_surface || !b.partner_surface) return a.partner_surface == b.partner_surface;
    return a.partner_surface->surface == b.partner_surface->surface &&
           (a.partner_surface->point - b.partner_surface->point).norm() <= same_place * spacing &&
           (a.partner_surface->push - b.partner_surface->push).squaredNorm() <= same_direction;
}

bool isSameStrike(const ContactImpulse& a, const ContactImpulse& b, double spacing) {
    const double speed = a.approach_m_s;
    return b.strikes() && a.partner_radius_m == b.partner_radius_m && areSameSurfaces(a, b, spacing) &&
           a.partner_youngs_modulus_pa == b.partner_youngs_modulus_pa &&
           a.partner_poisson_ratio == b.partner_poisson_ratio && a.friction == b.friction &&
           (a.point - b.point).norm() <= same_place * spacing &&
           (a.normal - b.normal).squaredNorm() <= same_direction && isAbout(speed, b.approach_m_s) &&
           (a.slip_m_s - b.slip_m_s).norm() <= same_speed * (speed + a.slip_m_s.norm()) &&
           std::abs(a.touched_s - b.touched_s) * speed <= same_place * spacing;
}

/// Of what stands still Bullet presses other points in each step, and each time the same comes of that.
bool standsStill(const ContactImpulse& contact) {
    return contact.slip_m_s.norm() <= standing_m_s && std::abs(contact.approach_m_s) <= standing_m_s;
}

bool pressesAlike(const ContactImpulse& a, const ContactImpulse& b, double radius) {
    const bool is_there = (a.point - b.point).norm() <= about_there * radius;
    return !b.strikes() && a.normal.dot(b.normal) >= about_so &&
           (is_there || (standsStill(a) && standsStill(b)));
}

double strikeImpulse(const Blow& blow) {
    double sum = 0;
    for (const ContactImpulse& contact : blow.contacts)
        if (contact.strikes()) sum += contact.impulse.norm();
    return sum;
}

/// Whether each contact of `a` is one of `b`, but for those that hardly press and those of light bodies that
/// only rest on this one.
bool hasContactsOf(const Blow& a, const Partners& partners_a, const Blow& b, const Partners& partners_b,
                   const BreakableSolid& solid) {
    const auto isOf = [&](const ContactImpulse& one, const ContactImpulse& other) {
        return partners_a[one.partner] == partners_b[other.partner] &&
               areAsHeavy(a.partner(one.partner), b.partner(other.partner)) &&
               (one.strikes() ? isSameStrike(one, other, solid.spacing())
                              : pressesAlike(one, other, solid.boundingRadius()));
    };
    const double strike_n_s = strikeImpulse(a);
    const auto counts = [&](const ContactImpulse& one) {
        if (one.strikes()) return true;
        const bool is_light = light * solid.mass() * a.partner(one.partner).inverse_mass > 1;
        return one.supports() && !is_light && one.impulse.norm() > hardly * strike_n_s;
    };
    return std::all_of(a.contacts.begin(), a.contacts.end(), [&](const ContactImpulse& one) {
        if (!counts(one)) return true;
        return partners_a[one.partner] != no_token &&
               std::any_of(b.contacts.begin(), b.contacts.end(),
                           [&](const ContactImpulse& other) { return isOf(one, other); });
    });
}

bool areSame(const Stack& a, const Stack& b) {
    const auto areAlike = [](const StackBody& one, const StackBody& other) {
        return areAsHeavy(one.mobility, other.mobility);
    };
    return a.contacts.size() == b.contacts.size() &&
           std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(), areAlike) &&
           isAbout(a.strike.speed_m_s, b.strike.speed_m_s) &&
           isAbout(a.strike.striker_mobility, b.strike.striker_mobility);
}

bool isSameQuestion(const BlowToDecide& a, const BlowToDecide& b) {
    return a.solid == b.solid && a.seed == b.seed && a.earlier == b.earlier &&
           a.fracture->largest_fragment_count == b.fracture->largest_fragment_count &&
           a.fracture->fragment_count == b.fracture->fragment_count;
}

}  // namespace

bool isAsForeseen(const ForeseenBlow& foreseen, const StruckBreakable& struck, const BlowToDecide& blow) {
    const Blow &expected = foreseen.blow.blow, &fallen = blow.blow;
    // A push of the app's own has no bodies for partners.
    if (foreseen.serial != struck.breakable->serial ||
        static_cast<int>(struck.partners.size()) < fallen.partnerCount())
        return false;
    Partners partners;
    for (const btCollisionObject* partner : struck.partners) partners.push_back(tokenOf(*partner));
    // The app may have prepared the body since, at any time of a thread's work.
    const bool is_answered_alike = foreseen.is_solved_in_full == !blow.solid->reducedStress();
    return is_answered_alike && isSameQuestion(foreseen.blow, blow) && areTurnsAlike(expected, fallen) &&
           hasContactsOf(expected, foreseen.partners, fallen, partners, *blow.solid) &&
           hasContactsOf(fallen, partners, expected, foreseen.partners, *blow.solid) &&
           areSame(expected.stack, fallen.stack);
}

}  // namespace sherd
