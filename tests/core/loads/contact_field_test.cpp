#include "core/loads/contact_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/numerics/mesh_measures.h"
#include "support/shapes.h"

namespace sherd {
namespace {

/// What presses on a place of a body, straight along a direction.
ContactField pressed(const TriangleMesh& mesh, const Vec3& at, const Vec3& push, double radius) {
    const SurfaceTree tree(mesh);
    const Material material = Material::stone();
    const ContactBody body{tree, material, {}, 0.1, 0.2};
    const SurfaceSpot spot = nearestSurfacePoint(tree, at, push);
    return contactField(body, {{spot, push, push, radius, partsOfPatch(tree, spot, push, radius, 0.18)}},
                        0.5 * radius);
}

/// Two contacts on one face of a block, the second of which presses `share` times as hard.
ContactField pressedTwice(const TriangleMesh& mesh, double share) {
    const SurfaceTree tree(mesh);
    const Material material = Material::stone();
    const ContactBody body{tree, material, {}, 0.1, 0.2};
    const Vec3 push = -Vec3::UnitZ();
    constexpr double radius = 0.01;
    std::vector<ContactPatch> patches;
    for (const double side : {1, -1}) {
        const SurfaceSpot spot = nearestSurfacePoint(tree, Vec3(0.05 * side, 0.01, 0.05), push);
        const double force = side > 0 ? 1 : share;
        patches.push_back({spot, push, force * push, radius, partsOfPatch(tree, spot, push, radius, 0.18)});
    }
    return contactField(body, patches, 0.5 * radius);
}

Vec3 totalOf(const ContactDisc& disc) {
    return 0.4 * 3.14159265358979 * disc.radius * disc.radius * disc.traction_pa;
}

const TriangleMesh block = shapes::slab(Vec3(0.2, 0.2, 0.1), 4, 4, 2);

TEST(ContactField, OnAFaceIsOneDiscWithAllOfTheForce) {
    const ContactField field = pressed(block, Vec3(0.03, 0, 0.05), -Vec3::UnitZ(), 0.02);
    ASSERT_EQ(field.near.discs().size(), 1u);
    const ContactDisc& disc = field.near.discs()[0];
    EXPECT_LT((disc.centre - Vec3(0.03, 0, 0.05)).norm(), 1e-9);
    EXPECT_LT((disc.inward + Vec3::UnitZ()).norm(), 1e-9);
    EXPECT_NEAR(disc.radius, 0.02, 1e-12);
    EXPECT_LT((totalOf(disc) + Vec3::UnitZ()).norm(), 0.01);
    EXPECT_TRUE(field.others.empty());
    for (const SurfacePlace& place : field.places)
        EXPECT_NEAR(place.position.z(), &place == &field.places.back() ? -0.05 : 0.05, 1e-12)
            << "or opposite";
    EXPECT_GT(field.places.size(), 50u);
}

TEST(ContactField, OverAnEdgeKeepsTheForceThatIsOnTheBody) {
    const ContactField field = pressed(block, Vec3(0.1, 0, 0.05), -Vec3::UnitZ(), 0.02);
    ASSERT_EQ(field.near.discs().size(), 1u);
    EXPECT_LT((totalOf(field.near.discs()[0]) + 2 * Vec3::UnitZ()).norm(), 0.05) << "half of it hangs over";
    const Vec3 push = Vec3(-1, 0, -1).normalized();
    EXPECT_EQ(pressed(block, Vec3(0.1, 0, 0.04), push, 0.02).near.discs().size(), 2u);
}

TEST(ContactField, IsLeftToTheGridWhereTheSurfaceBendsAway) {
    const TriangleMesh ball = shapes::icosphere(0.05, 4);
    const ContactField on_ball = pressed(ball, Vec3(0, 0, 0.05), -Vec3::UnitZ(), 0.07);
    EXPECT_TRUE(on_ball.near.empty());
    EXPECT_TRUE(on_ball.places.empty());
    EXPECT_GT(on_ball.others.size(), 20u);
    EXPECT_FALSE(pressed(ball, Vec3(0, 0, 0.05), -Vec3::UnitZ(), 0.03).near.empty());
}

TEST(ContactField, IsKnownOnWallsThatAreRoundInsideAndOutside) {
    const TriangleMesh tube = shapes::tube(0.05, 0.04, 0.3, 48);
    for (const double angle : {0.0, 0.065, 0.1}) {  // on facets and on the edges between them
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        const ContactField outside = pressed(tube, 0.05 * out, -out, 0.004);
        ASSERT_EQ(outside.near.discs().size(), 1u) << angle;
        const ContactField inside = pressed(tube, 0.04 * out, out, 0.004);
        ASSERT_EQ(inside.near.discs().size(), 1u) << angle;
        EXPECT_TRUE(inside.near.discs()[0].hollow);
        EXPECT_NEAR(inside.places.back().position.norm(), 0.05, 0.001) << "opposite";
    }
}

TEST(ContactField, KeepsTheForceOfAPushThatGrazesARoundWall) {
    const TriangleMesh tube = shapes::tube(0.05, 0.04, 0.3, 96);
    const Vec3 push = Vec3(-0.05, 1, 0).normalized();
    const ContactField field = pressed(tube, Vec3(0.05, 0, 0.15), push, 0.004);
    ASSERT_EQ(field.near.discs().size(), 1u);
    EXPECT_NEAR(totalOf(field.near.discs()[0]).norm(), 1, 0.01);
}

// At an edge it is a tie which triangle is the spot's.
TEST(ContactField, APatchDoesNotDependOnTheOrderOfTriangles) {
    TriangleMesh tube = shapes::tube(0.05, 0.04, 0.3, 64);
    std::mt19937 random(1);
    const auto weight = [&](const Vec3& push) {
        const SurfaceTree tree(tube);
        const Vec3 rim(0.05, 0, boundingBox(tube.vertices).max().z());
        double sum = 0;
        for (const PatchPart& part :
             partsOfPatch(tree, nearestSurfacePoint(tree, rim, push), push, 0.003, 0.18))
            sum += part.weight_m2;
        return sum;
    };
    for (const double tilt : {0.02, 0.1, 0.5, 1.0}) {
        const Vec3 push = Vec3(-tilt, 1, -0.1 * tilt).normalized();
        const double as_is = weight(push);
        for (int i = 0; i < 6; ++i) {
            std::shuffle(tube.triangles.begin(), tube.triangles.end(), random);
            EXPECT_NEAR(weight(push) / as_is, 1, 1e-6) << tilt;
        }
    }
}

TEST(ContactField, IsLeftToTheGridWhereNextToNothingPresses) {
    EXPECT_EQ(pressedTwice(block, 0.021).near.discs().size(), 2u);
    const ContactField faint = pressedTwice(block, 0.019);
    EXPECT_EQ(faint.near.discs().size(), 1u);
    Vec3 others = Vec3::Zero();
    for (const PointForce& force : faint.others) others += force.force;
    EXPECT_LT((others + 0.019 * Vec3::UnitZ()).norm(), 1e-9);
}

TEST(ContactField, IsLeftToTheGridAtCorners) {
    EXPECT_TRUE(pressed(block, Vec3(0.1, 0.1, 0.05), Vec3(-1, -1, -1).normalized(), 0.02).near.empty());
}

// Half a disc on either flank, each with its middle deep under the other one.
TEST(ContactField, IsLeftToTheGridAcrossAGroove) {
    const TriangleMesh channel = shapes::uShape(0.02, 0.1, 0.1, 0.3);
    const Vec3 low = boundingBox(channel.vertices).min();
    double floor = 0;
    for (const Vec3& v : channel.vertices)
        if (v.z() > 0 && v.z() < 0.1 - 1e-6) floor = std::max(floor, v.z());
    const Vec3 corner(low.x() + 0.02, 0, floor), push = Vec3(-1, 0, -1).normalized();
    EXPECT_TRUE(pressed(channel, corner + Vec3(0.001, 0, 0), push, 0.004).near.empty());
}

// Of the disc next to nothing is on the floor of the slot.
TEST(ContactField, IsLeftToTheGridInASlot) {
    const TriangleMesh slotted =
        shapes::rectilinear({-0.05, -0.0005, 0.0005, 0.05}, {-0.05, 0.05}, {0, 0.05, 0.1},
                            [](int i, int, int k) { return i != 1 || k == 0; });
    EXPECT_TRUE(pressed(slotted, Vec3(0, 0, 0.05), -Vec3::UnitZ(), 0.004).near.empty());
    EXPECT_TRUE(pressed(slotted, Vec3(-0.0005, 0, 0.055), -Vec3::UnitX(), 0.004).near.empty())
        << "the other wall is close before it";
}

TEST(ContactField, BesideAWallIsInAHollow) {
    const TriangleMesh channel = shapes::uShape(0.02, 0.1, 0.1, 0.3);
    double floor = 0;  // of the channel, half way between the legs
    for (const Vec3& v : channel.vertices)
        if (v.z() > 0 && v.z() < 0.1 - 1e-6) floor = std::max(floor, v.z());
    const Vec3 low = boundingBox(channel.vertices).min();
    for (const double from_leg : {0.005, 0.05}) {
        const ContactField field =
            pressed(channel, Vec3(low.x() + 0.02 + from_leg, 0, floor), -Vec3::UnitZ(), 0.004);
        ASSERT_EQ(field.near.discs().size(), 1u);
        EXPECT_EQ(field.near.discs()[0].hollow, from_leg < 0.01);
    }
}

}  // namespace
}  // namespace sherd
