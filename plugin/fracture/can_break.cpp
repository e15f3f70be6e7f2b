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
    Needed(const BreakableSolid& solid, const ReducedStress* reduced, const FractureSettings& fracture)
        : strength_(solid.strength()), reduced_(reduced), crack_j_(smallestCrackEnergy(solid, fracture)) {}
    /// Whether a blow with `share` of a bound may break the solid.
    bool mayBe(const std::optional<BlowBound>& bound, double share = 1) const {
        return !bound ||
               !(share * bound->strain_energy_j < crack_j_ || isBorne(share * bound->equivalent_stress_pa));
    }

  private:
    /// Most stresses are far below the weakest place, and it need not be looked for.
    bool isBorne(double stress_pa) const {
        return stress_pa <= strength_.at().least() || stress_pa <= strength_.weakest(reduced_->reading);
    }

    const BodyStrength& strength_;
    const ReducedStress* reduced_;  // there are no bounds without it
    double crack_j_;
};

}  // namespace

double leastEnergy(const BreakableSolid& solid, const FractureSettings& fracture) {
    return std::max(smallestCrackEnergy(solid, fracture), solid.smallestFailureEnergy());
}

// From the bound that costs least to the one that costs most: the energy that the blow brings at most, which
// the solid cannot store more of; what the table of a prepared solid says of the contacts; then that of the
// strike as the surface has them.
bool canBreak(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture) {
    const double needed = leastEnergy(solid, fracture);
    if (blow.isSqueezed())  // the table knows of no loads on all sides
        return blow.stack.largestEnergy() > needed;
    const BroughtBound brought = broughtAtMost(blow, solid.mass(), isHeld(solid, blow));
    if (brought.is_sure && !(brought.energy_j > needed)) return false;
    const ReducedStress* reduced = fracture.use_reduced_model ? solid.reducedStress() : nullptr;
    const PeakTable none;
    const PeakTable& table = reduced ? reduced->peaks : none;
    const Needed to_break(solid, reduced, fracture);
    const auto quick = quickBound(solid, table, blow, fracture.contact);
    if (!to_break.mayBe(quick)) return false;

    const Strike strike = strikeOf(struckBody(solid, blow), blow, fracture.contact);
    if (!(broughtEnergy(solid, blow, strike) > needed)) return false;
    const bool is_hopeless = to_break.mayBe(quick, hope);
    return is_hopeless || to_break.mayBe(closeBound(solid, table, blow, strike, fracture.contact));
}

}  // namespace sherd
