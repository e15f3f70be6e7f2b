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

}  // namespace sherd::benchmarks
