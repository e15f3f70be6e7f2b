#pragma once

#include <optional>
#include <vector>

#include "core/loads/blow.h"
#include "core/loads/strike.h"
#include "core/mlpg/reduced/peak_table.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// Upper bounds of what a blow does to a solid.
struct BlowBound {
    double equivalent_stress_pa = 0;  ///< of the material's criterion, at any particle or surface point
    double strain_energy_j = 0;
};

/// The bounds by a solid's table, without a solve and without a look at its surface. Nothing if the table
/// cannot tell, as of supports that push against each other.
std::optional<BlowBound> quickBound(const BreakableSolid& solid, const PeakTable& table, const Blow& blow,
                                    const ContactSettings& contact);

/// Closer ones, from the strike of the blow and what the body stands on.
std::optional<BlowBound> closeBound(const BreakableSolid& solid, const PeakTable& table, const Blow& blow,
                                    const Strike& strike, const ContactSettings& contact);

}  // namespace sherd
