#include "core/loads/contact_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "core/numerics/pi.h"
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
        return {*tree, material, Mobility::of(moments, material.density_kg_m3), 0.1, half.norm()};
    }

    Strike strike() const {
        const Strike strike = strikeOf(body(), blow, ContactSettings{});
        EXPECT_TRUE(strike.strikes());
        return strike;
    }

    TriangleMesh mesh = shapes::slab(Vec3(0.2, 0.1, 0.1), 20, 10, 2);
    std::optional<SurfaceTree> tree{mesh};
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

/// Of each point of a strike, in millimetres, rounded.
std::vector<int> partsOfFaces(const Strike& strike) {
    std::vector<int> found;
    for (const StrikePoint& point : strike.points)
        found.push_back(static_cast<int>(std::lround(1e3 * point.on_face_m)));
    return found;
}

TEST(ContactLoads, CornersOfAFaceThatLandsOnAFlatOneStandForAllOfIt) {
    FallingBrick brick;
    const ContactSettings settings;
    EXPECT_EQ(partsOfFaces(brick.strike()), (std::vector<int>{0, 0, 0, 0})) << "the floor may be rough";
    for (ContactImpulse& contact : brick.blow.contacts)
        contact.partner_is_flat = contact.partner_is_ground = true;
    const Strike strike = brick.strike();
    EXPECT_EQ(partsOfFaces(strike), (std::vector<int>{50, 50, 50, 50})) << "half of the short side";
    double pressed_m2 = 0;
    for (const ContactPatch& patch : contactPatches(brick.body(), strike, settings)) {
        EXPECT_NEAR(patch.radius_m, 0.05, 1e-9);
        for (const PatchPart& part : patch.parts) {
            EXPECT_NEAR(part.centre.z(), -0.05, 1e-9) << "none of the sides";
            pressed_m2 += part.weight_m2;
        }
    }
    EXPECT_NEAR(pressed_m2, 0.4 * pi * 0.05 * 0.05, 0.05 * 0.4 * pi * 0.05 * 0.05) << "a quarter of each";
}

/// A crate that strikes a wall presses with its corners, a brick on a table that gives way with all of its
/// face.
TEST(ContactLoads, OnWhatMovesAFaceHasToEndWithItsCorners) {
    const auto partsWithCornersAt = [](double share) {
        FallingBrick brick;
        for (ContactImpulse& contact : brick.blow.contacts) {
            contact.partner_is_flat = true;
            contact.point.head<2>() *= share;
        }
        return partsOfFaces(brick.strike());
    };
    EXPECT_EQ(partsWithCornersAt(1), (std::vector<int>{50, 50, 50, 50}));
    EXPECT_EQ(partsWithCornersAt(0.95), (std::vector<int>{48, 48, 48, 48})) << "rounded edges";
    EXPECT_EQ(partsWithCornersAt(0.5), (std::vector<int>{0, 0, 0, 0}));
}

/// Else the stress jumps by a factor of three where the other edge comes too late to count.
TEST(ContactLoads, AFaceFadesWithTheShareOfItsOtherEdge) {
    double before = 0.05;
    std::size_t points = 4;
    for (double late_s = 0; points == 4 && late_s < 1e-2; late_s += 1e-6) {
        FallingBrick brick;
        for (ContactImpulse& contact : brick.blow.contacts) {
            contact.partner_is_flat = contact.partner_is_ground = true;
            if (contact.point.x() > 0) contact.touched_s = -late_s;
        }
        const Strike strike = brick.strike();
        points = strike.points.size();
        EXPECT_LE(strike.points.front().on_face_m, before + 1e-12) << late_s;
        EXPECT_GT(strike.points.front().on_face_m, before - 0.01) << late_s;
        before = strike.points.front().on_face_m;
    }
    EXPECT_EQ(points, 2u) << "the other edge comes too late in the end";
    EXPECT_EQ(before, 0);
}

/// A quarter of a disc about each end of the lower edge, in which half of what lies within r is nearer to the
/// floor than 0.4 r tan(tilt): the radius r / 1.4 where that is what the body gives way, F / (2 E* r / 4).
TEST(ContactLoads, AFaceThatIsTiltedIsPressedAsFarAsItGivesWay) {
    double before = 0.06;
    for (const double tilt : {2e-4, 5e-4, 1e-3, 2e-3, 4e-3, 8e-3, 1.6e-2}) {
        FallingBrick brick;
        for (ContactImpulse& contact : brick.blow.contacts) {
            contact.partner_is_flat = contact.partner_is_ground = true;
            contact.normal = contact.impulse = Vec3(std::sin(tilt), 0, std::cos(tilt));
            if (contact.point.x() > 0) contact.touched_s = -0.2 * std::tan(tilt) / 2;
        }
        const Strike strike = brick.strike();
        const StrikePoint& point = strike.points.front();
        EXPECT_LT(point.on_face_m, before * 1.001) << tilt;
        if (strike.points.size() == 2) {
            const double force = hertzPeakForce(point.hertz, point.share * strike.mass(0), 2);
            const double radius =
                std::sqrt(5 * force / (point.hertz.contact_modulus_pa * std::tan(tilt))) / 1.4;
            EXPECT_NEAR(point.on_face_m, std::min(0.05, radius), 0.12 * radius) << tilt;
        }
        before = point.on_face_m;
    }
    EXPECT_LT(before, 0.03);
}

/// On the edge of a table, or on a ledge.
TEST(ContactLoads, AFaceThatIsTiltedIsPressedNoFurtherThanTheGroundReaches) {
    for (const double reach : {0., 0.01, 1.}) {
        FallingBrick brick;
        brick.blow.contacts.resize(2);
        for (ContactImpulse& contact : brick.blow.contacts) {
            contact.partner_is_flat = contact.partner_is_ground = true;
            contact.partner_reach_m = reach;
            contact.normal = contact.impulse = Vec3(std::sin(1e-3), 0, std::cos(1e-3));
        }
        EXPECT_NEAR(brick.strike().points.front().on_face_m, std::min(reach, 0.05), 1e-9);
    }
}

TEST(ContactLoads, AFacePressesOnlyWhereItTouches) {
    FallingBrick brick;
    for (Vec3& vertex : brick.mesh.vertices)  // a hollow of 2 cm with a rim of a tenth
        if (vertex.z() < -0.049 && std::abs(vertex.x()) < 0.09 && std::abs(vertex.y()) < 0.04)
            vertex.z() = -0.03;
    brick.tree.emplace(brick.mesh);
    for (ContactImpulse& contact : brick.blow.contacts)
        contact.partner_is_flat = contact.partner_is_ground = true;
    for (const ContactPatch& patch : contactPatches(brick.body(), brick.strike(), ContactSettings{}))
        for (const PatchPart& part : patch.parts) EXPECT_LT(part.centre.z(), -0.0498);
}

TEST(ContactLoads, AnEdgeThatLandsIsNoFace) {
    FallingBrick brick;
    brick.blow.contacts.resize(2);
    for (ContactImpulse& contact : brick.blow.contacts)
        contact.partner_is_flat = contact.partner_is_ground = true;
    EXPECT_EQ(partsOfFaces(brick.strike()), (std::vector<int>{0, 0}));
}

TEST(ContactLoads, FeetStandForNothingBetweenThem) {
    FallingBrick brick;
    const auto foot = [](double x) {
        return shapes::box(Vec3(x - 0.02, -0.05, -0.05), Vec3(x + 0.02, 0.05, 0.05));
    };
    brick.mesh = shapes::joined(foot(-0.08), foot(0.08));
    brick.tree.emplace(brick.mesh);
    brick.blow.contacts.clear();
    for (const double x : {-0.1, -0.06, 0.06, 0.1})
        for (const double y : {-0.05, 0.05}) brick.touch(Vec3(x, y, -0.05), 0);
    for (ContactImpulse& contact : brick.blow.contacts)
        contact.partner_is_flat = contact.partner_is_ground = true;
    for (const int part : partsOfFaces(brick.strike())) EXPECT_NEAR(part, 20, 1) << "half of a foot";
}

}  // namespace
