#include "core/loads/contact_field.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace sherd {
namespace {

/// What presses on a place of a body, straight along a direction.
ContactField pressed(const TriangleMesh& mesh, const Vec3& at, const Vec3& push, double radius) {
    const SurfaceTree tree(mesh);
    const Material material = Material::stone();
    const ContactBody body{tree, material, {}, 0.1, 0.2};
    const SurfaceSpot spot = nearestSurfacePoint(tree, at, push);
    return contactField(body, {{spot, push, push, radius, partsOfPatch(tree, spot, push, radius)}});
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
    for (const SurfacePlace& place : field.places) EXPECT_NEAR(place.position.z(), 0.05, 1e-12);
    EXPECT_GT(field.places.size(), 50u);
}

TEST(ContactField, OverAnEdgeKeepsTheForceThatIsOnTheBody) {
    const ContactField field = pressed(block, Vec3(0.1, 0, 0.05), -Vec3::UnitZ(), 0.02);
    ASSERT_EQ(field.near.discs().size(), 1u);
    EXPECT_LT((totalOf(field.near.discs()[0]) + 2 * Vec3::UnitZ()).norm(), 0.05) << "half of it hangs over";
    const Vec3 push = Vec3(-1, 0, -1).normalized();
    EXPECT_EQ(pressed(block, Vec3(0.1, 0, 0.04), push, 0.02).near.discs().size(), 2u);
}

TEST(ContactField, IsLeftToTheGridWhereTheSurfaceIsNotFlatOrNotInFront) {
    const TriangleMesh ball = shapes::icosphere(0.05, 4);
    const ContactField on_ball = pressed(ball, Vec3(0, 0, 0.05), -Vec3::UnitZ(), 0.03);
    EXPECT_TRUE(on_ball.near.empty());
    EXPECT_TRUE(on_ball.places.empty());
    EXPECT_GT(on_ball.others.size(), 20u);
    EXPECT_FALSE(pressed(ball, Vec3(0, 0, 0.05), -Vec3::UnitZ(), 0.005).near.empty()) << "nearly flat";
    const TriangleMesh hollow = shapes::uShape(0.02, 0.1, 0.1, 0.3);
    int left = 0, known = 0;
    for (const Vec3& v : hollow.vertices)
        for (const Vec3& push : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX())})
            ++(pressed(hollow, v, push, 0.004).near.empty() ? left : known);
    EXPECT_GT(left, 0) << "inside of the hollow";
    EXPECT_GT(known, 0) << "outside";
}

}  // namespace
}  // namespace sherd
