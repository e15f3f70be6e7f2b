#include <algorithm>
#include <cmath>

#include "core/loads/contact_field.h"
#include "core/loads/foundation.h"
#include "core/loads/support_answer.h"
#include "fracture/blow_stress.h"
#include "fracture/per_newton.h"

namespace sherd {

namespace {

/// The loads of strikes, as unitLoads has them.
PerNewton underStrikes(const ContactBody& body, const PeakTable& table, const std::vector<Strike>& strikes,
                       const ContactSettings& settings) {
    const double smallest = smallestPatch(body, settings);
    const double largest = std::max(smallest, settings.largest_patch * body.radius_m);
    double momentum = 0;
    for (const Strike& strike : strikes) momentum += strike.mass(0) * strike.speed_m_s;
    PerNewton all;
    Wrench wrench = Wrench::Zero();
    for (const Strike& strike : strikes)
        for (const StrikePoint& point : strike.points) {
            const double mass = point.share * strike.mass(0);
            if (!(mass > 0)) continue;
            const double given = point.contact->patch_radius_m;
            const double peak = hertzPeakForce(point.hertz, mass, strike.speed_m_s);
            const double radius = given > 0
                                      ? std::max(given, smallest)
                                      : std::clamp(hertzPatchRadius(point.hertz, peak), smallest, largest);
            const Vec3 force = mass * strike.speed_m_s / momentum * point.push;
            const PerNewton one =
                underForce(body, table, point.spot.point, point.contact->normal, force, 0, radius);
            all.stress_pa += one.stress_pa;
            all.root_compliance += one.root_compliance;
            all.work += one.work;
            wrench += body.mobility.wrench(point.spot.point, force);
        }
    for (const ContactPatch& patch : contactPatches(body, strikes, settings))
        for (const ContactDisc& disc : contactDiscs(body.surface, patch))
            all.near_pa =
                std::max(all.near_pa, (disc.hollow ? most_if_hollow : 1) *
                                          nearFieldPeak(body.material, disc.inward, disc.traction_pa));
    all.root_mobility = std::sqrt(wrench.dot(body.mobility.response(wrench)));
    return all;
}

/// The share of their lasting answer that foundations give at most to a strike no longer than `longest_s`.
double largestShare(const ContactBody& body, const std::vector<Foundation>& foundations, double moving_share,
                    double longest_s) {
    const double speed = std::sqrt(body.material.youngs_modulus_pa / body.material.density_kg_m3);
    double squared = 0;  // of all angular frequencies together
    for (const Foundation& foundation : foundations) {
        const double reached = waveShare(foundation.distance_m / speed, longest_s);
        for (const FoundationPoint& point : foundation.points) {
            const double mobility =
                foundation.push.dot(body.mobility.at(point.position) * foundation.push) / moving_share +
                foundation.push.dot(foundation.partner.at(point.position) * foundation.push);
            squared += reached * point.share * foundation.stiffness_n_m * mobility;
        }
    }
    return squared > 0 ? springShare(std::sqrt(squared), longest_s) : 0;
}

}  // namespace

std::optional<BlowBound> closeBound(const BreakableSolid& solid, const PeakTable& table, const Blow& blow,
                                    const std::vector<Strike>& strikes, const ContactSettings& contact) {
    if (table.levels.empty()) return std::nullopt;
    if (strikes.empty()) return BlowBound{};
    const ContactBody body = struckBody(solid);
    const PerNewton strike = underStrikes(body, table, strikes, contact);
    PerNewton answer;
    double held = solid.isAnchored() ? 1 : 0;
    if (!solid.isAnchored() && blow.isSupported()) {
        const std::vector<Foundation> foundations = foundationsOf(body, blow, strikes, contact);
        std::vector<Support> supports;
        for (const Foundation& foundation : foundations) {
            Support support{foundation.push, {}, {}};
            for (const FoundationPoint& point : foundation.points)
                support.box.extend(point.position.cast<float>());
            support.contacts = {foundation.points.front().position, foundation.points.back().position};
            supports.push_back(std::move(support));
        }
        // Between the shortest and the longest pulse that there may be.
        const double shortest = contact.shortest_contact_s;
        const double quick = contactPulse(impactOf(strikes, 0), 0, shortest).duration_s;
        double stress_free = strike.energy_j();
        PerNewton most;
        if (!supports.empty()) {
            if (!boundAnswer(table, supports, solid.mass(), strike.root_mobility, 1, most))
                return std::nullopt;
            const double root = strike.root_compliance + most.root_compliance;
            stress_free = 0.5 * root * root;
            const double slow = contactPulse(impactOf(strikes, 1), stress_free, shortest).duration_s;
            held = largestShare(body, foundations, movingShare(body, quick), slow);
            answer.stress_pa = held * most.stress_pa;
            answer.root_compliance = held * most.root_compliance;
        }
    }
    return boundOf(impactOf(strikes, held), strike, answer, isHeld(solid, blow), slowestPeriod(solid),
                   contact.shortest_contact_s);
}

}  // namespace sherd
