#include "core/loads/stack.h"

#include <algorithm>

namespace sherd {

const StackBody* Stack::body(int number) const {
    const auto found = std::find_if(bodies.begin(), bodies.end(),
                                    [&](const StackBody& one) { return one.number == number; });
    return found == bodies.end() ? nullptr : &*found;
}

double Stack::largestEnergy() const {
    const StackBody* struck = strike.strikes() ? body(strike.number) : nullptr;
    if (!struck) return 0;
    const double felt = strike.striker_mobility > 0 ? strike.striker_mobility : struck->mobility.inverse_mass;
    return 0.5 / felt * strike.speed_m_s * strike.speed_m_s;
}

}  // namespace sherd
