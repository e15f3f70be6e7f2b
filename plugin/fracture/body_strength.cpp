#include "fracture/body_strength.h"

#include <algorithm>

namespace sherd {

double BodyStrength::weakest(const DamageReading& reading) const {
    if (is_painted_) return strength_.least();
    return weakest_.get([&] {
        const std::vector<double>& all = atPoints(reading);
        return all.empty() ? strength_.least() : *std::min_element(all.begin(), all.end());
    });
}

}  // namespace sherd
