#include "core/numerics/triangle_rule.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sherd {
namespace {

// Closed form: the integral of u^a v^b over the triangle is a! b! / (a + b + 2)!.
TEST(TriangleRule, IsExactUpToItsDegree) {
    for (const int degree : {4, 6, 8, 10, 12, 14}) {
        const TriangleRule rule = triangleRule(degree);
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b) {
                double sum = 0;
                for (std::size_t k = 0; k < rule.weights.size(); ++k)
                    sum += rule.weights[k] * std::pow(rule.u[k], a) * std::pow(rule.v[k], b);
                const double exact = std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
                EXPECT_NEAR(sum, exact, 2e-15) << degree << ": " << a << ", " << b;
            }
    }
    EXPECT_EQ(triangleRule(8).weights.size(), 16u);
}

}  // namespace
}  // namespace sherd
