// The bounds of a prepared solid's table are above what the full solve finds, and the gate skips by them.
#include "fracture/blow_bound.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/loads/contact_loads.h"
#include "fracture/blow_damage.h"
#include "fracture/can_break.h"
#include "fracture/decided.h"
#include "fracture/default_fracture.h"
#include "fracture/pipeline.h"
#include "fracture/random_blows.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

struct BlowBounds : testing::Test {
    static const Shape& bowl() {
        static const Shape shape = tenShapes()[8];
        return shape;
    }
    static const BreakableSolid& solid() {
        static const auto made = [] {
            const auto solid = BreakableSolid::make(bowl().mesh, bowl().material, {}).value();
            EXPECT_TRUE(solid->prepare({}).ok());
            EXPECT_TRUE(solid->reducedStress());
            return solid;
        }();
        return *made;
    }
};

TEST_F(BlowBounds, AreAboveWhatTheFullSolveFinds) {
    const Discretisation& sampling = *solid().discretisation().value();
    Material even = solid().material();
    even.tensile_strength_pa = 1;
    even.strength_scatter = 0;
    const BodyStrength strength(even, solid().strength().scatterLength(), {});
    FractureSettings fracture = solid().settings().fracture;
    fracture.use_reduced_model = false;
    const PeakTable& table = solid().reducedStress()->peaks;
    RandomBlows blows(bowl().mesh, 3);
    constexpr int blow_count = 20;
    int quick = 0, close = 0, supported = 0;
    double least = 1e9;
    for (int i = 0; i < blow_count; ++i) {
        const Blow blow = blows.next();
        StageTimes ms;
        const BlowDamage truth = blowDamage({solid(), sampling, fracture, 1}, blow, strength, ms);
        const double stress =
            *std::max_element(truth.damage.overstress.begin(), truth.damage.overstress.end());
        const Strike strike = strikeOf(struckBody(solid(), blow), blow, fracture.contact);
        const auto first = quickBound(solid(), table, blow, fracture.contact);
        const auto second = closeBound(solid(), table, blow, strike, fracture.contact);
        for (const auto& bound : {first, second}) {
            if (!bound) continue;
            least = std::min(least, bound->equivalent_stress_pa / stress);
            EXPECT_GT(bound->strain_energy_j, truth.forces.strain_energy_j) << i;
        }
        quick += first.has_value();
        close += second.has_value();
        supported += second && blow.isSupported();
    }
    EXPECT_GT(least, 1);
    EXPECT_GT(quick, blow_count / 2);
    EXPECT_GT(close, blow_count / 2);
    EXPECT_GT(supported, 3);
}

Blow tap(double speed) {
    Blow blow;
    ContactImpulse contact;
    const TriangleMesh& mesh = BlowBounds::bowl().mesh;
    const auto& [a, b, c] = mesh.triangles[40];
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    contact.point = (p + q + r) / 3;
    contact.normal = -(q - p).cross(r - p).normalized();
    contact.impulse = 0.01 * contact.normal;
    contact.approach_m_s = speed;
    contact.partner_radius_m = 0.01;
    blow.contacts = {contact};
    blow.partners = {Mobility::ofPoint(0.05)};
    return blow;
}

// The bound of the energy alone lets it through.
TEST_F(BlowBounds, TheGateSkipsATapByItsStress) {
    FractureSettings without = solid().settings().fracture;
    without.use_reduced_model = false;
    double speed = 100;
    while (canBreak(solid(), tap(speed), solid().settings().fracture)) speed *= 0.9;
    EXPECT_TRUE(canBreak(solid(), tap(speed), without)) << speed;
    const BlowOutcome tapped = decided(solid(), tap(speed), solid().settings().fracture);
    EXPECT_EQ(tapped.outcome, Outcome::held);
    EXPECT_EQ(tapped.level, Level::gate);
    const BlowOutcome solved = decided(solid(), tap(speed), without);
    EXPECT_EQ(solved.outcome, Outcome::held);
    EXPECT_EQ(solved.level, Level::full);
}

// 30 blows at the largest speed that is skipped, each held by the full solve.
TEST_F(BlowBounds, NoBlowThatIsSkippedBreaks) {
    FractureSettings fully = solid().settings().fracture;
    fully.use_reduced_model = false;
    RandomBlows blows(bowl().mesh, 9);
    int by_stress = 0;
    for (int i = 0; i < 30; ++i) {
        Blow blow = blows.next();
        for (ContactImpulse& contact : blow.contacts) contact.approach_m_s *= 100;
        while (canBreak(solid(), blow, solid().settings().fracture))
            for (ContactImpulse& contact : blow.contacts) {
                contact.approach_m_s *= 0.9;
                contact.slip_m_s *= 0.9;
            }
        by_stress += canBreak(solid(), blow, fully);
        EXPECT_NE(strike(solid(), blow, fully, 1).outcome, Outcome::broke) << i;
    }
    EXPECT_GT(by_stress, 5);
}

TEST_F(BlowBounds, SupportsThatPushAgainstEachOtherHaveNone) {
    Blow blow = tap(1);
    ContactImpulse support = blow.contacts[0];
    support.approach_m_s = 0;
    support.partner = 1;
    blow.contacts.push_back(support);
    const auto& contact = solid().settings().fracture.contact;
    EXPECT_TRUE(quickBound(solid(), solid().reducedStress()->peaks, blow, contact));
    support.normal = (0.3 * support.normal.unitOrthogonal() - support.normal).normalized();
    support.impulse = support.normal;
    blow.contacts.push_back(support);
    EXPECT_FALSE(quickBound(solid(), solid().reducedStress()->peaks, blow, contact));
}

TEST_F(BlowBounds, TheWeakestStrengthIsThatOfThePointsThatAreRead) {
    const DamageReading& reading = solid().reducedStress()->reading;
    const auto& strengths = solid().strength().atPoints(reading);
    const double weakest = solid().strength().weakest(reading);
    EXPECT_EQ(weakest, *std::min_element(strengths.begin(), strengths.end()));
    EXPECT_GE(weakest, solid().strength().at().least());
}

// Beside a clamp the table would say too little.
TEST(AnchoredBlowBounds, AreThoseOfTheEnergyAlone) {
    const Shape wall = tenShapes()[1];
    const auto free = BreakableSolid::make(wall.mesh, wall.material, Settings::forQuality(Quality::preview));
    const double low = std::min_element(wall.mesh.vertices.begin(), wall.mesh.vertices.end(),
                                        [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); })
                           ->z();
    const double far = 10;
    const auto solid = free.value()->anchored({BoxRegion{{-far, -far, low}, {far, far, low}}});
    ASSERT_TRUE(solid->prepare({}).ok());
    ASSERT_TRUE(solid->reducedStress());
    EXPECT_TRUE(solid->reducedStress()->peaks.levels.empty());
    FractureSettings fully = solid->settings().fracture;
    fully.use_reduced_model = false;
    RandomBlows blows(wall.mesh, 4);
    for (double speed = 10; speed > 0.01; speed *= 0.8) {
        Blow blow = blows.next();
        for (ContactImpulse& contact : blow.contacts) contact.approach_m_s *= speed;
        EXPECT_EQ(canBreak(*solid, blow, solid->settings().fracture), canBreak(*solid, blow, fully));
    }
}

// The app's field may wait or throw: what asks whether a blow is worth a solve must not call it.
TEST_F(BlowBounds, TheGateNeverCallsAStrengthField) {
    Settings settings = Settings::forQuality(Quality::preview);
    int calls = 0;
    settings.strength.field = [&](const Vec3&) {
        ++calls;
        return 0.5;
    };
    settings.strength.field_minimum = 0.5;
    const auto solid = BreakableSolid::make(bowl().mesh, bowl().material, settings).value();
    ASSERT_TRUE(solid->prepare({}).ok());
    ASSERT_TRUE(solid->reducedStress());
    const DamageReading& reading = solid->reducedStress()->reading;
    double speed = 100;
    while (canBreak(*solid, tap(speed), solid->settings().fracture)) speed *= 0.9;
    EXPECT_EQ(calls, 0);
    const double allowed = solid->strength().weakest(reading);
    EXPECT_EQ(calls, 0);
    EXPECT_GT(allowed, 0);
    const auto& strengths = solid->strength().atPoints(reading);
    EXPECT_EQ(calls, static_cast<int>(reading.points().points.size()));
    EXPECT_LE(allowed, *std::min_element(strengths.begin(), strengths.end()));
}

}  // namespace
