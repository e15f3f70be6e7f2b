#include "core/loads/blow.h"

#include <algorithm>
#include <cmath>

namespace sherd {

namespace {

/// How one partner meets the body, or all together that do not give way.
class Meeting {
  public:
    void add(const ContactImpulse& contact) {
        if (!(fastest_ > 0)) first_ = contact.normal;
        least_cosine_ = std::min(least_cosine_, first_.dot(contact.normal));
        const double closing = contact.approach_m_s;
        fastest_ = std::max(fastest_, closing);
        fastest_with_slip_ = std::max(fastest_with_slip_, std::hypot(closing, contact.slip_m_s.norm()));
    }
    bool strikes() const { return fastest_ > 0; }
    /// Whether all push about alike.
    bool isEven() const { return evenness() > 0.5; }
    /// With a mass that cannot be larger if the points share the blow in any way. Forces that push apart feel
    /// little of a body, and stop more than its mass, the slower, and its spin: nothing is sure of these but
    /// the speed of a body that does not turn. `more_m_s`: by which the partner may be faster than it closes.
    BroughtBound of(double mass_kg, double more_m_s = 0) const {
        const double speed = (isEven() ? fastest_ : fastest_with_slip_) + more_m_s;
        const double mass = isEven() ? mass_kg / evenness() : mass_kg;
        return {mass, 0.5 * mass * speed * speed, isEven()};
    }
    double fastest() const { return fastest_; }

  private:
    /// Of the square of a sum of normals with shares that add up to 1, at least.
    double evenness() const { return least_cosine_ > 0 ? 2 * least_cosine_ * least_cosine_ - 1 : 0; }

    Vec3 first_ = Vec3::Zero();
    double fastest_ = 0, fastest_with_slip_ = 0, least_cosine_ = 1;
};

}  // namespace

Mobility Blow::partner(int number) const {
    const auto place = static_cast<std::size_t>(number);
    return place < partners.size() ? partners[place] : Mobility{};
}

int Blow::partnerCount() const {
    int count = 0;
    for (const ContactImpulse& contact : contacts) count = std::max(count, contact.partner + 1);
    return count;
}

bool Blow::isStruckBy(int partner) const {
    return std::any_of(contacts.begin(), contacts.end(), [&](const ContactImpulse& contact) {
        return contact.partner == partner && contact.strikes() && contact.hasMet();
    });
}

std::vector<const ContactImpulse*> Blow::strikes() const {
    std::vector<char> is_struck_by(static_cast<std::size_t>(partnerCount()));
    for (const ContactImpulse& contact : contacts)
        if (contact.strikes() && contact.hasMet()) is_struck_by[contact.partner] = 1;
    std::vector<const ContactImpulse*> striking;
    for (const ContactImpulse& contact : contacts)
        if (contact.strikes() && is_struck_by[contact.partner]) striking.push_back(&contact);
    return striking;
}

bool Blow::isStruck() const {
    return std::any_of(contacts.begin(), contacts.end(),
                       [](const ContactImpulse& contact) { return contact.strikes() && contact.hasMet(); });
}

bool Blow::isSupported() const {
    return std::any_of(contacts.begin(), contacts.end(),
                       [](const ContactImpulse& contact) { return contact.supports(); });
}

double normalImpulse(const Blow& blow) {
    double sum = 0;
    for (const ContactImpulse& contact : blow.contacts) sum += std::max(0.0, contact.pushed());
    return sum;
}

double stoppedMass(const Mobility& partner, double mass_kg) {
    return 1 / (1 / mass_kg + partner.inverse_mass);
}

BroughtBound broughtAtMost(const Blow& blow, double mass_kg, bool held) {
    std::vector<Meeting> meetings(static_cast<std::size_t>(blow.partnerCount()));
    Meeting of_fixed;
    for (const ContactImpulse* contact : blow.strikes())
        (blow.partner(contact->partner).fixed() ? of_fixed : meetings[contact->partner]).add(*contact);
    const auto strikes = [](const Meeting& meeting) { return meeting.strikes(); };
    const auto count = std::count_if(meetings.begin(), meetings.end(), strikes) + of_fixed.strikes();
    BroughtBound sum;
    sum.pinched = count > 1;
    const auto add = [&](const BroughtBound& more) {
        sum.mass_kg += more.mass_kg;
        sum.energy_j += more.energy_j;
        sum.is_sure = sum.is_sure && more.is_sure;
    };
    if (of_fixed.strikes()) add(of_fixed.of(mass_kg));
    for (std::size_t number = 0; number < meetings.size(); ++number) {
        const Meeting& meeting = meetings[number];
        if (!meeting.strikes()) continue;
        const Mobility& partner = blow.partners[number];
        const bool keeps_all = held || sum.pinched || !meeting.isEven();
        // The body may run from it, into what does not give way.
        add(meeting.of(keeps_all ? partner.mass() : stoppedMass(partner, mass_kg), of_fixed.fastest()));
    }
    return sum;
}

double blowEnergy(const Blow& blow, double mass_kg, bool held) {
    return blow.isSqueezed() ? blow.stack.largestEnergy() : broughtAtMost(blow, mass_kg, held).energy_j;
}

}  // namespace sherd
