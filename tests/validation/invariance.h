#pragma once

#include "validation/closed_form.h"

namespace sherd::validation::invariance {

inline const Vec3 size(0.6, 0.4, 0.2);

/// Largest difference between stresses of which `b` is to be `factor` times `a`, over the largest of `a`.
inline double largestDifference(const std::vector<SymmetricTensor>& a, const std::vector<SymmetricTensor>& b,
                                double factor) {
    EXPECT_EQ(a.size(), b.size());
    double difference = 0, largest = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        difference = std::max(difference, (a[i] - b[i] / factor).norm());
        largest = std::max(largest, a[i].norm());
    }
    return difference / largest;
}

}  // namespace sherd::validation::invariance
