#include "fracture/can_break.h"

#include <algorithm>

#include "core/loads/contact_loads.h"
#include "fracture/blow_bound.h"
#include "fracture/blow_stress.h"
#include "fracture/crack_energy.h"

namespace sherd {

namespace {

/// The close bound is seldom below this part of the quick one: where even that would not do, it is left out.
constexpr double hope = 0.1;

/// Bounds against what it takes to break a solid.
class Needed {
  public:
    Needed(const BreakableSolid& solid, const PeakTable& table, const FractureSettings& fracture)
        : crack_j_(smallestCrackEnergy(solid, fracture)) {
        if (table.levels.empty()) return;
        if (const auto sampling = solid.discretisation())
            strength_pa_ = solid.weakestStrength(*sampling.value());
    }
    /// Whether a blow with `share` of a bound may break the solid.
    bool mayBe(const std::optional<BlowBound>& bound, double share = 1) const {
        return !bound || !(share * bound->equivalent_stress_pa <= strength_pa_ ||
                           share * bound->strain_energy_j < crack_j_);
    }

  private:
    double crack_j_, strength_pa_ = 0;
};

}  // namespace

double leastEnergy(const BreakableSolid& solid, const FractureSettings& fracture) {
    return std::max(smallestCrackEnergy(solid, fracture), solid.smallestFailureEnergy());
}

// From the bound that costs least to the one that costs most: the energy that the blow brings at most, which
// the solid cannot store more of; what the table of a prepared solid says of the contacts; then those of the
// strikes as the surface has them.
bool canBreak(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture) {
    const double needed = leastEnergy(solid, fracture);
    if (!(blowEnergy(blow, solid.mass(), isHeld(solid, blow)) > needed)) return false;

    if (blow.isSqueezed()) return true;  // the table knows of no loads on all sides
    const ReducedStress* reduced = fracture.use_reduced_model ? solid.reducedStress() : nullptr;
    const PeakTable none;
    const PeakTable& table = reduced ? reduced->peaks : none;
    const Needed to_break(solid, table, fracture);
    const auto quick = quickBound(solid, table, blow, fracture.contact);
    if (!to_break.mayBe(quick)) return false;

    const auto strikes = strikesOf(struckBody(solid), blow, fracture.contact);
    if (!(broughtEnergy(solid, blow, strikes) > needed)) return false;
    const bool is_hopeless = to_break.mayBe(quick, hope);
    return is_hopeless || to_break.mayBe(closeBound(solid, table, blow, strikes, fracture.contact));
}

}  // namespace sherd
