#include "fracture/debris.h"

#include <algorithm>

namespace sherd {

void markDropped(double smallest_m3, std::vector<Fragment>& fragments) {
    const auto volume = [](const Fragment& fragment) { return fragment.solid->moments().volume; };
    const auto largest =
        std::max_element(fragments.begin(), fragments.end(),
                         [&](const auto& a, const auto& b) { return volume(a) < volume(b); });
    for (auto fragment = fragments.begin(); fragment != fragments.end(); ++fragment)
        fragment->dropped = fragment != largest && volume(*fragment) < smallest_m3;
}

}  // namespace sherd
