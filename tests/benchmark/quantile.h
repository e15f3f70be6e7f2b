#pragma once

#include <algorithm>
#include <vector>

namespace sherd::benchmarks {

/// The value below which a `share` of all lie; 0 if there are none.
inline double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    return values[std::min(values.size() - 1, at)];
}

inline double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

/// Between the two values about a quartile, of at least four: against it nothing is decided by rounding.
inline double betweenAtQuarter(std::vector<double> values, std::size_t quarters) {
    std::sort(values.begin(), values.end());
    const std::size_t above = quarters * values.size() / 4;
    return 0.5 * (values[above - 1] + values[above]);
}

}  // namespace sherd::benchmarks
