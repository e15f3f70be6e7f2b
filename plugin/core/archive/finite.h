#pragma once

#include <cmath>

namespace sherd {

/// What is not finite would make sums of all that is beside it not finite either.
template <class Numbers>
bool areFinite(const Numbers& numbers) {
    bool are = true;
    for (const auto number : numbers) are &= std::isfinite(number);
    return are;
}

}  // namespace sherd
