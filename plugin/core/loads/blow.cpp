#include "core/loads/blow.h"

#include <algorithm>

namespace sherd {

namespace {

/// The largest mass that a strike can stop.
double largestMass(double body_mass_kg, const Mobility& partner, bool held) {
    if (partner.fixed()) return body_mass_kg;
    return 1 / ((held ? 0 : 1 / body_mass_kg) + partner.inverse_mass);
}

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
        return contact.partner == partner && contact.strikes() && contact.pushed() > 0;
    });
}

bool Blow::isStruck() const {
    for (int number = 0; number < partnerCount(); ++number)
        if (isStruckBy(number)) return true;
    return false;
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

double blowEnergy(const Blow& blow, double mass_kg, bool held) {
    double energy = blow.isSqueezed() ? blow.stack.largestEnergy() : 0;
    for (int number = 0; number < blow.partnerCount(); ++number) {
        if (!blow.isStruckBy(number)) continue;
        double speed = 0;
        for (const ContactImpulse& contact : blow.contacts)
            if (contact.partner == number) speed = std::max(speed, contact.approach_m_s);
        energy += 0.5 * largestMass(mass_kg, blow.partner(number), held) * speed * speed;
    }
    return energy;
}

}  // namespace sherd
