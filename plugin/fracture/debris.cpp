#include "fracture/debris.h"

#include <algorithm>

namespace sherd {

double smallestFragment(const BreakableSolid& solid, const FractureSettings& fracture) {
    constexpr double share = 1.0 / 200;
    return fracture.smallest_fragment_m3 > 0 ? fracture.smallest_fragment_m3 : share * solid.moments().volume;
}

void markDropped(double smallest_m3, std::vector<Fragment>& fragments) {
    const auto volume = [](const Fragment& fragment) { return fragment.solid->moments().volume; };
    const auto largest =
        std::max_element(fragments.begin(), fragments.end(),
                         [&](const auto& a, const auto& b) { return volume(a) < volume(b); });
    for (auto fragment = fragments.begin(); fragment != fragments.end(); ++fragment)
        fragment->dropped = fragment != largest && volume(*fragment) < smallest_m3;
}

}  // namespace sherd
