#pragma once

#include <vector>

#include "core/loads/contact_loads.h"
#include "core/mlpg/reduced/peak_table.h"
#include "fracture/blow_bound.h"

namespace sherd {

/// What loads of 1 N in normal forces do, at most.
struct PerNewton {
    double stress_pa = 0;        ///< as far as the grid of the table resolves it
    double near_pa = 0;          ///< in the near field of any contact; 0: none is known
    double root_compliance = 0;  ///< of the body, (m/N)^(1/2): the root of twice the strain energy
    double root_mobility = 0;    ///< of the free rigid body, kg^(-1/2)
    /// Of the first modes, about; zero if it is not known.
    Eigen::Matrix<float, PeakTable::modes, 1> work = decltype(work)::Zero();

    double energy_j() const { return 0.5 * root_compliance * root_compliance; }
};

/// A force on a place, and one in any direction of the size `lateral` on top.
PerNewton underForce(const ContactBody& body, const PeakTable& table, const Vec3& place, const Vec3& normal,
                     const Vec3& force, double lateral, double radius_m);

/// The largest equivalent stress in the near field of a contact with this traction in its middle.
double nearFieldPeak(const Material& material, const Vec3& inward, const Vec3& traction_pa);

/// The least radius that a load is spread over, m.
double smallestPatch(const ContactBody& body, const ContactSettings& settings);

/// A part of the surface that pushes back.
struct Support {
    Vec3 push = Vec3::Zero();
    std::vector<Vec3> contacts;
    Eigen::AlignedBox3f box;  ///< of all that it may be
};

/// What supports do that answer a strike of 1 N with `share` of what they would if it lasted. Springs under a
/// rigid body take no more of its motion than there is: of their resultant p, p . M^-1 p is no more than that
/// of the strike. If all push with the part c or more along one direction, the sum of all is at most
/// (m strike . M^-1 strike)^(1/2) / c. False if c is too small to tell.
bool boundAnswer(const PeakTable& table, const std::vector<Support>& supports, double mass_kg,
                 double root_mobility, double share, PerNewton& answer);

/// The slowest period of a solid's vibrations, s; 0: nothing is known of them.
double slowestPeriod(const BreakableSolid& solid);

/// What follows for a blow. `is_held`: the body may not give way. `period_s`: the slowest of its vibrations.
BlowBound boundOf(const Impact& impact, const PerNewton& strike, const PerNewton& answer, bool is_held,
                  double period_s, double shortest_s);

}  // namespace sherd
