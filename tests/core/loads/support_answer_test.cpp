#include "core/loads/support_answer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/loads/spring_system.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

constexpr double pi = 3.14159265358979323846;
constexpr double slow_s = 1, fast_s = 1e-6;

/// A box on a floor, struck from above or from the side.
struct Standing {
    explicit Standing(const Vec3& size, const Vec3& struck_at, const Vec3& push)
        : half(size / 2), mesh(shapes::slab(size, 5, 5, 5)) {
        material.name = "brick";
        ContactImpulse strike;
        strike.point = struck_at;
        strike.normal = push;
        strike.impulse = push;
        strike.approach_m_s = 1;
        strike.partner_radius_m = 0.01;
        blow.contacts.push_back(strike);
        stand({{-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}});
        blow.partners = {Mobility::ofPoint(1), Mobility{}};
    }

    /// Bullet's points, at the corners of what touches the floor.
    void stand(const std::vector<Vec2>& points) {
        blow.contacts.resize(1);
        for (const Vec2& p : points) {
            ContactImpulse c;
            c.point = Vec3(p.x(), p.y(), -half.z());
            c.normal = Vec3::UnitZ();
            c.impulse = 1e-3 * Vec3::UnitZ();
            c.partner = 1;
            blow.contacts.push_back(c);
        }
    }

    ContactBody body() const {
        Moments moments;
        moments.volume = 8 * half.prod();
        for (int k = 0; k < 3; ++k) moments.second(k, k) = moments.volume * half[k] * half[k] / 3;
        return {tree, material, Mobility::of(moments, material.density_kg_m3), 2 * half.minCoeff(),
                half.norm()};
    }
    std::vector<Foundation> foundations() const {
        return foundationsOf(body(), blow, strikeOf(body(), blow, settings), settings);
    }
    SupportAnswer answer(double duration_s) const {
        return supportAnswer(body(), foundations(),
                             unitLoads(contactPatches(body(), strikeOf(body(), blow, settings), settings)),
                             duration_s, blow.stack);
    }

    Vec3 half;
    TriangleMesh mesh;
    SurfaceTree tree{mesh};
    Material material = Material::brick();
    ContactSettings settings;
    Blow blow;
};

Vec3 sum(const SupportAnswer& answer) {
    Vec3 total = Vec3::Zero();
    for (const PointForce& f : answer.forces) total += f.force;
    return total;
}

Vec3 centre(const SupportAnswer& answer) {
    Vec3 total = Vec3::Zero();
    for (const PointForce& f : answer.forces) total += f.force.norm() * f.position;
    return total / answer.sum_n;
}

TEST(SupportAnswer, AFloorAnswersASlowStrikeInFullBelowIt) {
    for (const double x : {0.0, 0.02, 0.04}) {
        const Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(x, 0, 0.05), -Vec3::UnitZ());
        const SupportAnswer answer = brick.answer(slow_s);
        EXPECT_NEAR(sum(answer).z(), 1, 1e-3);
        EXPECT_NEAR(centre(answer).x(), x, 2e-3);
        EXPECT_NEAR(answer.held, 1, 1e-3);
    }
}

TEST(SupportAnswer, InertiaTakesUpAShortStrike) {
    const Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(0, 0, 0.05), -Vec3::UnitZ());
    EXPECT_EQ(brick.answer(fast_s).sum_n, 0);
    EXPECT_LT(brick.answer(1e-4).sum_n, 0.7);
}

TEST(SupportAnswer, NothingAnswersAPushAlongTheFloor) {
    const Standing wall(Vec3(1, 0.09, 1), Vec3(0, -0.045, 0), Vec3::UnitY());
    for (const double duration_s : {1e-4, 1e-3, 1e-2}) EXPECT_LT(wall.answer(duration_s).sum_n, 1e-9);
}

TEST(SupportAnswer, AWallPushedAboveItsMiddleTipsOverItsFarEdge) {
    const Standing wall(Vec3(1, 0.09, 1), Vec3(0, -0.045, 0.4), Vec3::UnitY());
    EXPECT_LT(wall.answer(1e-4).sum_n, 0.02);
    const SupportAnswer answer = wall.answer(slow_s);
    EXPECT_GT(answer.sum_n, 0.1);
    EXPECT_GT(centre(answer).y(), 0.02);
    for (const PointForce& f : answer.forces) EXPECT_GT(f.force.z(), 0) << "springs do not pull";
}

TEST(SupportAnswer, AStrikeBeyondTheEdgeIsAnsweredAtTheEdge) {
    Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(0.09, 0, 0.05), -Vec3::UnitZ());
    brick.stand({{-0.1, -0.05}, {0, -0.05}, {0, 0.05}, {-0.1, 0.05}});  // half of it over a table
    const SupportAnswer answer = brick.answer(slow_s);
    EXPECT_NEAR(centre(answer).x(), 0, 0.035);
    EXPECT_LT(answer.held, 0.95) << "it tips";
}

TEST(SupportAnswer, APartnerGivesWayAsItsMassLetsIt) {
    Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(0, 0, 0.05), -Vec3::UnitZ());
    const double brick_kg = 0.2 * 0.1 * 0.1 * brick.material.density_kg_m3;
    EXPECT_NEAR(brick.answer(1e-3).sum_n, 1, 1e-3);
    for (const double mass : {0.1, 1.0, 10.0, 1e6}) {
        brick.blow.partners[1].inverse_mass = 1 / mass;
        const SupportAnswer answer = brick.answer(1e-3);
        const double share = mass / (mass + brick_kg);  // both move on together
        EXPECT_NEAR(answer.sum_n, share, 0.01 * share) << mass;
        EXPECT_NEAR(answer.held, share, 0.01 * share) << mass;
    }
}

/// Lies on partner 1, and that on a body of 3 kg, number 2, which lies on nothing.
Standing onTwoOthers(double partner_kg) {
    Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(0, 0, 0.05), -Vec3::UnitZ());
    brick.blow.partners[1] = Mobility::ofPoint(partner_kg);
    brick.blow.stack.bodies = {{1, brick.blow.partners[1], 1e-9}, {2, Mobility::ofPoint(3), 2e-9}};
    brick.blow.stack.contacts = {{1, 2, Vec3(0, 0, -0.1), Vec3::UnitZ(), 1e9}};
    return brick;
}

TEST(SupportAnswer, AStackGivesWayAsAll) {
    const double brick_kg = 0.2 * 0.1 * 0.1 * Material::brick().density_kg_m3;
    for (const double partner_kg : {1.0, 5.0}) {
        Standing brick = onTwoOthers(partner_kg);
        const double share = (partner_kg + 3) / (partner_kg + 3 + brick_kg);  // all three move on together
        EXPECT_NEAR(brick.answer(5e-3).sum_n, share, 0.01 * share) << partner_kg;
        brick.blow.stack.contacts.push_back({2, -1, Vec3(0, 0, -0.2), Vec3::UnitZ(), 1e9});  // on a floor
        const SupportAnswer held = brick.answer(5e-3);
        EXPECT_NEAR(held.sum_n, 1, 0.01);
        EXPECT_NEAR(held.held, 1, 0.01);
        EXPECT_NEAR(held.others_energy_j, 0.5 * (1e-9 + 2e-9), 0.05e-9) << "two rods that carry 1 N";
    }
}

TEST(SupportAnswer, ABodyBetweenAStruckOneAndTheFloorIsSqueezed) {
    Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(0, 0, 0.05), -Vec3::UnitZ());
    brick.blow.partners.push_back(Mobility::ofPoint(5));
    for (ContactImpulse& contact : brick.blow.contacts) contact.approach_m_s = 0;
    brick.blow.contacts[0].partner = 2;  // lies on the brick, and is struck
    brick.blow.stack.bodies = {{2, brick.blow.partners[2], 0}};
    brick.blow.stack.strike = {2, Vec3(0, 0, 0.1), -Vec3::UnitZ(), 1, 1, {0.01, 1e10}};
    ASSERT_TRUE(brick.blow.isSqueezed());
    const auto answerTo = [&](double duration_s) {
        return supportAnswer(brick.body(), brick.foundations(), {}, duration_s, brick.blow.stack);
    };
    const SupportAnswer slow = answerTo(5e-3);
    EXPECT_NEAR(slow.sum_n, 2, 0.02) << "from above and from below";
    EXPECT_NEAR(sum(slow).z(), 0, 0.01);
    EXPECT_LT(answerTo(1e-5).sum_n, 0.1) << "inertia of the body above takes it up";
}

/// Lies on twelve bodies of 50 g to 2 kg, each of which leans on the next one and some on a floor.
Standing onAHeap(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Standing slab(Vec3(0.4, 0.3, 0.04), Vec3(0.05, 0.02, 0.02), -Vec3::UnitZ());
    slab.blow.contacts.resize(1);
    slab.blow.partners.resize(1);
    constexpr int bodies = 12;
    for (int i = 1; i <= bodies; ++i) {
        const Mobility mobility = Mobility::ofPoint(0.05 + 1.95 * share(random));
        slab.blow.partners.push_back(mobility);
        slab.blow.stack.bodies.push_back({i, mobility, 0});
        const Vec2 place(0.3 * (share(random) - 0.5), 0.2 * (share(random) - 0.5));
        for (const Vec2& corner : {Vec2(-0.02, -0.02), Vec2(0.02, -0.02), Vec2(0, 0.03)}) {
            ContactImpulse contact;
            contact.point = Vec3(place.x() + corner.x(), place.y() + corner.y(), -0.02);
            contact.normal = Vec3::UnitZ();
            contact.impulse = 1e-3 * Vec3::UnitZ();
            contact.partner = i;
            slab.blow.contacts.push_back(contact);
        }
        const Vec3 beside(place.x(), place.y(), -0.04);
        const Vec3 tilted = Vec3(share(random) - 0.5, share(random) - 0.5, 1).normalized();
        slab.blow.stack.contacts.push_back({i, i % bodies + 1, beside, tilted, 1e8 * share(random)});
        if (i % 3 == 0) slab.blow.stack.contacts.push_back({i, -1, beside, Vec3::UnitZ(), 1e8});
    }
    return slab;
}

TEST(SupportAnswer, InAHeapDoesNotDependOnTheSpringsThatAreTriedFirst) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Standing slab = onAHeap(seed);
        const ContactBody body = slab.body();
        const auto loads =
            unitLoads(contactPatches(body, strikeOf(body, slab.blow, slab.settings), slab.settings));
        for (const double duration_s : {3e-4, 1e-3, 1e-2, 0.1}) {
            const SpringSystem system =
                springSystemOf(body, slab.foundations(), loads, duration_s, slab.blow.stack);
            const Pressed all = pressedSprings(system, duration_s);
            std::mt19937 random(seed);
            for (int start = 0; start < 3; ++start) {
                std::vector<char> guess(system.springs.size());
                for (char& pressed : guess) pressed = static_cast<char>(random() % 2);
                const Pressed found = pressedSprings(system, duration_s, guess);
                EXPECT_NEAR(found.held, all.held, 1e-3);
                double apart_n = 0;
                for (std::size_t i = 0; i < guess.size(); ++i)
                    if (system.springs[i].is_own) apart_n += std::abs(found.forces_n[i] - all.forces_n[i]);
                EXPECT_LT(apart_n, 0.01) << seed << ", " << duration_s << " s";
            }
        }
    }
}

TEST(SupportAnswer, AThinPlateIsPressedRightBelow) {
    const Standing plate(Vec3(1, 1, 0.02), Vec3(0.2, 0.1, 0.01), -Vec3::UnitZ());
    const SupportAnswer answer = plate.answer(5e-4);
    EXPECT_GT(answer.sum_n, 0.9);
    double near = 0;
    for (const PointForce& f : answer.forces)
        if ((f.position - Vec3(0.2, 0.1, -0.01)).norm() < 0.04) near += f.force.z();
    EXPECT_GT(near / answer.sum_n, 0.8);
}

// x'' + omega^2 x = F sin(pi t / T) / m up to T / 2, against k x over F.
TEST(SupportAnswer, SpringShareIsThatOfAHalfSinePulseUntilItIsStatic) {
    const double duration = 1;
    for (const double omega : {0.3, 1.0, 2.0, pi, 4.0, 4.8}) {
        double x = 0, v = 0;
        const int steps = 100000;
        const double dt = duration / 2 / steps;
        for (int i = 0; i < steps; ++i) {
            const double t = (i + 0.5) * dt;
            x += 0.5 * dt * v;
            v += dt * (std::sin(pi * t / duration) - omega * omega * x);
            x += 0.5 * dt * v;
        }
        EXPECT_NEAR(springShare(omega, duration), omega * omega * x, 1e-5) << omega;
    }
    for (const double omega : {5.0, 10.0, 1e3, 1e9}) EXPECT_EQ(springShare(omega, duration), 1);
    EXPECT_EQ(springShare(0, duration), 0);
}

TEST(SupportAnswer, AWaveHasToComeThroughFirst) {
    EXPECT_EQ(waveShare(0, 1e-3), 1);
    EXPECT_EQ(waveShare(0.3e-3, 1e-3), 1);
    EXPECT_NEAR(waveShare(0.4e-3, 1e-3), 2 * std::cos(0.4 * pi), 1e-12);
    EXPECT_EQ(waveShare(0.5e-3, 1e-3), 0);
}

TEST(Foundation, IsWhatTheContactsEnclose) {
    const Standing brick(Vec3(0.2, 0.1, 0.3), Vec3(0, 0, 0.15), -Vec3::UnitZ());
    ASSERT_EQ(brick.foundations().size(), 1u);
    const Foundation whole = brick.foundations()[0];
    // 2 E* a of a disc of nearly the same area: the bed is a little softer away from the load.
    const double modulus = contactModulus(12e9, 0.16, brick.settings.partner_youngs_modulus_pa,
                                          brick.settings.partner_poisson_ratio);
    EXPECT_NEAR(whole.stiffness_n_m, 2 * modulus * std::sqrt(0.02 / pi), 0.1 * whole.stiffness_n_m);
    EXPECT_NEAR(whole.distance_m, 0.3, 0.01);
    Standing half = brick;
    half.stand({{-0.1, -0.05}, {0, -0.05}, {0, 0.05}, {-0.1, 0.05}});
    const double reach = half.settings.smallest_patch * 0.1;
    const std::vector<Foundation> of_half = half.foundations();
    ASSERT_EQ(of_half.size(), 1u);
    for (const FoundationPoint& p : of_half[0].points) {
        EXPECT_LT(p.position.x(), reach + 1e-9);
        EXPECT_NEAR(p.position.z(), -0.15, 1e-9);
    }
    half.stand({});
    EXPECT_TRUE(half.foundations().empty());
}

TEST(Foundation, PartnersAndDirectionsStandForThemselves) {
    Standing brick(Vec3(0.2, 0.1, 0.1), Vec3(0, 0, 0.05), -Vec3::UnitZ());
    ContactImpulse side;
    side.point = Vec3(0.1, 0, 0);
    side.normal = -Vec3::UnitX();
    side.impulse = -Vec3::UnitX();
    side.partner = 1;
    brick.blow.contacts.push_back(side);
    EXPECT_EQ(brick.foundations().size(), 2u);
    brick.blow.contacts.back().impulse.setZero();
    EXPECT_EQ(brick.foundations().size(), 1u) << "does not press";
    brick.blow.contacts[1].partner = 2;
    EXPECT_EQ(brick.foundations().size(), 2u);
}

}  // namespace
