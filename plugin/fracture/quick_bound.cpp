#include <algorithm>
#include <cmath>

#include "core/loads/contact_field.h"
#include "core/loads/foundation.h"
#include "core/numerics/pi.h"
#include "fracture/blow_stress.h"
#include "fracture/per_newton.h"

namespace sherd {

namespace {

constexpr std::size_t most_contacts = 64;  // more take longer than they are worth

/// Bounds from the contacts alone.
class Quick {
  public:
    Quick(const BreakableSolid& solid, const PeakTable& table, const Blow& blow,
          const ContactSettings& settings)
        : body_(struckBody(solid, blow)),
          table_(table),
          blow_(blow),
          settings_(settings),
          mass_kg_(solid.mass()),
          period_s_(slowestPeriod(solid)),
          held_(isHeld(solid, blow)),
          has_supports_(!solid.isAnchored() && blow.isSupported()) {}

    std::optional<BlowBound> find() {
        if (blow_.contacts.size() > most_contacts) return std::nullopt;
        const std::vector<const ContactImpulse*> contacts = blow_.strikes();
        if (contacts.empty()) return BlowBound{};
        const BroughtBound brought = broughtAtMost(blow_, mass_kg_, held_);
        if (!brought.is_sure) return std::nullopt;
        impact_.mass_kg = brought.mass_kg;
        impact_.speed_m_s = std::sqrt(2 * brought.energy_j / brought.mass_kg);
        if (contacts.size() == 1)
            addAlone(*contacts[0]);
        else
            for (const ContactImpulse* contact : contacts)
                include(*contact, withoutFriction(*contact), std::max(0.0, contact->friction));
        impact_.hertz_force_n = hertzForce(contacts, impact_.mass_kg, impact_.speed_m_s);
        PerNewton answer;
        if (has_supports_ && !boundAnswer(table_, supports(), mass_kg_, strike_.root_mobility, 1, answer))
            return std::nullopt;
        return boundOf(impact_, strike_, answer, held_ || brought.pinched, period_s_,
                       settings_.shortest_contact_s);
    }

  private:
    /// What is pushed at one place only is known.
    void addAlone(const ContactImpulse& contact) {
        Strike strike;
        strike.points = {{&contact, {contact.point, -1}, {}, 1, contact.normal}};
        shareOut(body_.mobility, blow_, strike);
        impact_.mass_kg = strike.mass(held_ ? 1 : 0);
        impact_.speed_m_s = contact.approach_m_s;
        include(contact, strike.points[0].push, 0);
    }

    /// Includes a contact as if it had all of the force: all bounds are convex, so that it does not matter
    /// how the force is shared out.
    void include(const ContactImpulse& contact, const Vec3& push, double lateral) {
        const double smallest = smallestPatch(body_, settings_);
        const PerNewton more = underForce(body_, table_, contact.point, contact.normal, push, lateral,
                                          std::max(contact.patch_radius_m, smallest));
        strike_.stress_pa = std::max(strike_.stress_pa, more.stress_pa);
        // A patch that hangs over an edge is smaller, and friction larger on a face that tilts.
        const double radius = std::max(contact.patch_radius_m, smallest);
        const double per_area = 1 / (least_share * 0.4 * pi * radius * radius);
        const Vec3 along = (push - push.dot(contact.normal) * contact.normal).norm() > 0
                               ? Vec3((push - push.dot(contact.normal) * contact.normal).normalized())
                               : Vec3(contact.normal.unitOrthogonal());
        strike_.near_pa = std::max(strike_.near_pa, nearFieldPeak(body_.material, contact.normal,
                                                                  per_area * (push + lateral * along)));
        strike_.root_compliance = std::max(strike_.root_compliance, more.root_compliance);
        strike_.root_mobility = std::max(strike_.root_mobility, more.root_mobility);
        strike_.work = included_++ == 0 ? more.work : decltype(more.work)(decltype(more.work)::Zero());
    }

    /// The force along the normal where friction is known, else along the impulse.
    static Vec3 withoutFriction(const ContactImpulse& contact) {
        const double pushed = contact.pushed();
        return contact.friction < 0 && pushed > 0 ? Vec3(contact.impulse / pushed) : contact.normal;
    }

    /// Of Hertz contacts that share a blow, at most. The force goes with the power 0.6 of a contact's share,
    /// or 0.5 if its patch is given (hertzRadiusOfPatch): the sum is largest if all share evenly. Curvature
    /// of the body's own makes the radius smaller, and the force with it.
    double hertzForce(const std::vector<const ContactImpulse*>& contacts, double mass, double speed) const {
        const double smallest = smallestPatch(body_, settings_);
        const double largest = std::max(body_.radius_m, smallest);
        double force = 0, power = 0.4;
        for (const ContactImpulse* contact : contacts) {
            const double radius = contact->partner_radius_m;
            HertzContact hertz{radius > 0 ? std::clamp(radius, smallest, largest) : largest,
                               contactModulus(body_, *contact, settings_)};
            if (contact->patch_radius_m > 0) {
                hertz.radius_m =
                    hertzRadiusOfPatch(hertz.contact_modulus_pa, std::max(contact->patch_radius_m, smallest),
                                       0.5 * mass * speed * speed);
                power = 0.5;
            }
            force = std::max(force, hertzPeakForce(hertz, mass, speed));
        }
        return force * std::pow(static_cast<double>(contacts.size()), power);
    }

    /// Contacts that push alike are one, as in foundations, but of all partners.
    std::vector<Support> supports() const {
        std::vector<Support> found;
        std::vector<Vec3> firsts;
        for (const ContactImpulse& contact : blow_.contacts) {
            if (!contact.supports()) continue;
            std::size_t own = 0;
            while (own < found.size() && firsts[own].dot(contact.normal) <= push_alike) ++own;
            if (own == found.size()) {
                found.emplace_back();
                firsts.push_back(contact.normal);
            }
            found[own].push += contact.normal;
            found[own].contacts.push_back(contact.point);
            found[own].box.extend(contact.point.cast<float>());
        }
        for (Support& support : found) support.push.normalize();
        return found;
    }

    const ContactBody body_;
    const PeakTable& table_;
    const Blow& blow_;
    const ContactSettings& settings_;
    double mass_kg_, period_s_;
    bool held_, has_supports_;
    Impact impact_;
    PerNewton strike_;
    int included_ = 0;
};

}  // namespace

std::optional<BlowBound> quickBound(const BreakableSolid& solid, const PeakTable& table, const Blow& blow,
                                    const ContactSettings& contact) {
    if (table.levels.empty()) return std::nullopt;
    return Quick(solid, table, blow, contact).find();
}

}  // namespace sherd
