// What the bound skips would not have broken: random blows, by light and heavy partners and by ones that do
// not give way, on bodies that float and that stand.
#include "fracture/can_break.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "fracture/default_fracture.h"
#include "fracture/random_blows.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

Blow atSpeed(Blow blow, double factor) {
    for (ContactImpulse& contact : blow.contacts) {
        contact.approach_m_s *= factor;
        contact.slip_m_s *= factor;
    }
    return blow;
}

/// The factor of a blow's speed up to which it is skipped.
double largestSkippedFactor(const BreakableSolid& solid, const Blow& blow) {
    double skipped = 1e-6, passes = 1e6;
    for (int i = 0; i < 50; ++i) {
        const double middle = std::sqrt(skipped * passes);
        (canBreak(solid, atSpeed(blow, middle)) ? passes : skipped) = middle;
    }
    return skipped;
}

TEST(CanBreak, NoRandomBlowThatIsSkippedBreaks) {
    int blows = 0, standing = 0, above = 0;
    for (const Shape& shape : tenShapes()) {
        Settings settings = coarselySampled();
        settings.fracture.largest_fragment_count = 3;  // pieces are not what this is about
        const auto made = BreakableSolid::make(shape.mesh, shape.material, settings);
        ASSERT_TRUE(made.ok()) << shape.name << ": " << made.error();
        const BreakableSolid& solid = *made.value();
        RandomBlows random(shape.mesh, 11);
        for (int i = 0; i < 12; ++i) {
            const Blow blow = random.next();
            const double factor = largestSkippedFactor(solid, blow);
            const BlowOutcome below = strike(solid, atSpeed(blow, 0.999 * factor), 1);
            EXPECT_NE(below.outcome, Outcome::broke) << shape.name << ", blow " << i;
            above += strike(solid, atSpeed(blow, 2 * factor), 1).outcome == Outcome::broke;
            standing += blow.isSupported();
            ++blows;
        }
    }
    std::printf("%d of %d break at twice the speed, %d stand\n", above, blows, standing);
    EXPECT_GT(above, 0) << "a bound far below all breaks would show nothing";
    EXPECT_GT(standing, blows / 4);
}

}  // namespace
