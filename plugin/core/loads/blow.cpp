#include "core/loads/blow.h"

#include <algorithm>

namespace sherd {

double normalImpulse(const Blow& blow) {
    double sum = 0;
    for (const ContactImpulse& contact : blow.contacts)
        sum += std::max(0.0, contact.impulse.dot(contact.normal));
    return sum;
}

ContactShare contactShare(const ContactImpulse& contact) {
    ContactShare share;
    const double pushed = contact.impulse.dot(contact.normal);
    if (!(contact.approach_m_s > 0) || !(pushed > 0)) return share;
    // A speculative contact stops only part of the motion in its first step, and restitution turns it round:
    // the quotient is the same mass in all cases. The mass of the two free bodies at this point bounds it.
    const double change = contact.approach_m_s - contact.closing_after_m_s;
    share.mass_kg = contact.effective_mass_kg;
    if (change > 0) share.mass_kg = std::min(share.mass_kg, pushed / change);
    share.speed_m_s = contact.approach_m_s;
    share.energy_j = 0.5 * share.mass_kg * share.speed_m_s * share.speed_m_s;
    return share;
}

double blowEnergy(const Blow& blow) {
    double energy = 0;
    for (const ContactImpulse& contact : blow.contacts) energy += contactShare(contact).energy_j;
    return energy;
}

}  // namespace sherd
