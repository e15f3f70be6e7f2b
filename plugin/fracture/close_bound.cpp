#include <algorithm>
#include <cmath>

#include "core/loads/contact_field.h"
#include "core/loads/foundation.h"
#include "core/loads/support_answer.h"
#include "fracture/blow_stress.h"
#include "fracture/per_newton.h"

namespace sherd {

namespace {

/// The loads of a strike, as unitLoads has them.
PerNewton underStrike(const ContactBody& body, const PeakTable& table, const Strike& strike,
                      const ContactSettings& settings) {
    PerNewton all;
    Wrench wrench = Wrench::Zero();
    for (const StrikePoint& point : strike.points) {
        if (!(point.share > 0)) continue;
        const Vec3 force = point.share * point.push;
        const PerNewton one = underForce(body, table, point.spot.point, point.contact->normal, force, 0,
                                         patchRadius(body, strike, point, settings));
        all.stress_pa += one.stress_pa;
        all.root_compliance += one.root_compliance;
        all.work += one.work;
        wrench += body.mobility.wrench(point.spot.point, force);
    }
    for (const ContactPatch& patch : contactPatches(body, strike, settings))
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
                                    const Strike& strike, const ContactSettings& contact) {
    if (table.levels.empty()) return std::nullopt;
    if (!strike.strikes()) return BlowBound{};
    const ContactBody body = struckBody(solid, blow);
    const PerNewton under_strike = underStrike(body, table, strike, contact);
    PerNewton answer;
    double held = solid.isAnchored() ? 1 : 0;
    if (!solid.isAnchored() && blow.isSupported()) {
        const std::vector<Foundation> foundations = foundationsOf(body, blow, strike, contact);
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
        const double quick = contactPulse(impactOf(strike, 0), 0, shortest).duration_s;
        double stress_free = under_strike.energy_j();
        PerNewton most;
        if (!supports.empty()) {
            if (!boundAnswer(table, supports, solid.mass(), under_strike.root_mobility, 1, most))
                return std::nullopt;
            const double root = under_strike.root_compliance + most.root_compliance;
            stress_free = 0.5 * root * root;
            const double slow = contactPulse(impactOf(strike, 1), stress_free, shortest).duration_s;
            held = largestShare(body, foundations, movingShare(body, quick), slow);
            answer.stress_pa = held * most.stress_pa;
            answer.root_compliance = held * most.root_compliance;
        }
    }
    const bool is_held = isHeld(solid, blow) || broughtAtMost(blow, solid.mass(), true).pinched;
    return boundOf(impactOf(strike, held), under_strike, answer, is_held, slowestPeriod(solid),
                   contact.shortest_contact_s);
}

}  // namespace sherd
