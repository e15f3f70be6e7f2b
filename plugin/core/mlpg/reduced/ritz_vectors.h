#pragma once

#include <Eigen/Dense>
#include <functional>

#include "core/vibration/struck_modes.h"

namespace sherd {

/// A body beyond its known vibrations, K and M being what they leave of its stiffness and mass. Vectors are
/// of its unknowns.
struct BeyondModes {
    Eigen::VectorXd response;  ///< static displacement under the loads, K^-1 f
    double energy_share = 0;   ///< of the whole body's static energy under the loads
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> momentum_of;  ///< M u
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> response_to;  ///< K^-1 p; empty if there is none
};

/// Adds to the known vibrations of a struck body two modes of its loads that stand for all faster ones
/// (load-dependent Ritz vectors; Wilson, Yuan, Dickens, Earthquake Engineering and Structural Dynamics 10
/// (1982) 813). With the static response r to loads F(t), what a short contact changes of r F, u = r F + w,
/// is driven by the inertia of r,
///     M w'' + K w = - M r F'',
/// which is as smooth as r is large: so w is found in the space of K^-1 M r and K^-1 M K^-1 M r, and the
/// steep stress below the load stays with r. The modes of that space match four moments of the spectrum that
/// the loads have beyond the known modes.
///
/// The known modes are taken to be the body's own: then neither K nor M joins them to what is left. On thick
/// bodies the fastest of them are not, which shows in vectors that are slower than these; and where next to
/// nothing is left, it is rounding. None are added there: what is left follows the force at once.
void addRitzVectors(const BeyondModes& body, StruckModes& struck);

}  // namespace sherd
