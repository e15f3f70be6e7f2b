#include "core/loads/contact_loads.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace {

using namespace sherd;

/// A brick of 0.2 x 0.1 x 0.1 m that falls flat on a floor, with a contact at each corner.
struct FallingBrick {
    FallingBrick() {
        for (const double x : {-0.1, 0.1})
            for (const double y : {-0.05, 0.05}) touch(Vec3(x, y, -0.05), 0);
    }

    void touch(const Vec3& point, double touched_s) {
        ContactImpulse contact;
        contact.point = point;
        contact.normal = contact.impulse = Vec3::UnitZ();
        contact.approach_m_s = 2;
        contact.friction = 0;
        contact.touched_s = touched_s;
        blow.contacts.push_back(contact);
    }

    ContactBody body() const {
        const Vec3 half(0.1, 0.05, 0.05);
        Moments moments;
        moments.volume = 8 * half.prod();
        for (int k = 0; k < 3; ++k) moments.second(k, k) = moments.volume * half[k] * half[k] / 3;
        return {tree, material, Mobility::of(moments, material.density_kg_m3), 0.1, half.norm()};
    }

    Strike strike() const {
        const Strike strike = strikeOf(body(), blow, ContactSettings{});
        EXPECT_TRUE(strike.strikes());
        return strike;
    }

    TriangleMesh mesh = shapes::slab(Vec3(0.2, 0.1, 0.1), 4, 2, 2);
    SurfaceTree tree{mesh};
    Material material = Material::brick();
    Blow blow;
};

// Boxes side by side give the same point twice or more.
TEST(ContactLoads, PointsThatShareAPatchAreOne) {
    FallingBrick brick;
    for (int i = 0; i < 3; ++i) brick.touch(Vec3(0.1, 0.05 - 1e-3 * i, -0.05), 0);
    const Strike strike = brick.strike();
    ASSERT_EQ(strike.points.size(), 4u);
    for (const StrikePoint& point : strike.points) EXPECT_NEAR(point.share, 0.25, 1e-9);
    EXPECT_NEAR(strike.mass(0), 2e-3 * 1800, 1e-9);
}

// A step of 1/60 s that ends with a corner deep in the floor brings other corners down that a step of 1/960 s
// does not.
TEST(ContactLoads, WhatIsMetAfterThePeakDoesNotCount) {
    FallingBrick brick;
    brick.touch(Vec3(0, 0, -0.05), 5e-3);
    const Strike strike = brick.strike();
    ASSERT_EQ(strike.points.size(), 1u);
    EXPECT_EQ(strike.points[0].contact, &brick.blow.contacts.back());
}

}  // namespace
