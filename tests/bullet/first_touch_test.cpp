// Where a ball met the surface of a body that hulls stand for in collisions.

#include "core/loads/first_touch.h"

#include <cmath>

#include "bullet/support.h"
#include "bullet/world/conversions.h"
#include "core/loads/load_patch.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

const SurfaceTree& slab() {
    static const TriangleMesh mesh = shapes::box(Vec3(-0.3, -0.3, -0.02), Vec3(0.3, 0.3, 0));
    static const SurfaceTree tree(mesh);
    return tree;
}

constexpr double radius = 0.03;

constexpr double step_s = 1.0 / 60;

FirstTouch seen(const Vec3& push, double ago_s) {
    return {Vec3::Zero(), push.normalized(), ago_s};
}

TEST(FirstTouch, IsThatOfTheBallWhereItWas) {
    for (const double angle : {0.0, 30.0, 60.0})
        for (const double ago_s : {0.001, 0.004, 0.007})
            for (const double wrong_s : {-0.0005, 0.0, 0.003}) {
                const double slope = angle * pi / 180;
                const Vec3 velocity = 5 * Vec3(std::sin(slope), 0, -std::cos(slope)),
                           then(0.05, 0.02, radius);
                const MovingBall ball{then + ago_s * velocity, velocity, radius};
                const auto touch = trueTouch(slab(), ball, seen(Vec3(1, 0, -1), ago_s - wrong_s), step_s);
                ASSERT_TRUE(touch) << angle << " " << ago_s << " " << wrong_s;
                EXPECT_LT((touch->point - Vec3(0.05, 0.02, 0)).norm(), 0.03 * radius);
                EXPECT_LT((touch->push + Vec3::UnitZ()).norm(), 1e-6);
                EXPECT_NEAR(touch->ago_s, ago_s, 0.03 * radius / 5);
            }
}

TEST(FirstTouch, ASlightlyWrongNormalIsSetRightOnItsFace) {
    const MovingBall ball{Vec3(0.05, 0.02, radius - 0.01), Vec3(0, 0, -5), radius};
    const auto touch = trueTouch(slab(), ball, seen(Vec3(0.2, 0, -1), 0.002), step_s);
    ASSERT_TRUE(touch);
    EXPECT_LT((touch->push + Vec3::UnitZ()).norm(), 1e-6);
    EXPECT_NEAR(touch->ago_s, 0.002, 1e-9);
    EXPECT_FALSE(trueTouch(slab(), ball, seen(-Vec3::UnitZ(), 0.002), step_s)) << "nothing is wrong";
}

TEST(FirstTouch, IsNotToldOfWhatWasFarOffOrGrazed) {
    const Vec3 deep(0.05, 0.02, radius - 0.02), aside = Vec3(1, 0, -1);
    const MovingBall falling{deep, Vec3(0, 0, -5), radius};
    EXPECT_TRUE(trueTouch(slab(), falling, seen(aside, 0.004), step_s));
    EXPECT_TRUE(trueTouch(slab(), falling, seen(aside, -0.01), step_s)) << "hulls may lie behind the surface";
    EXPECT_FALSE(trueTouch(slab(), falling, seen(aside, -0.03), step_s)) << "far behind";
    EXPECT_FALSE(trueTouch(slab(), falling, seen(aside, 0.02), step_s))
        << "it met a lid over a hollow before";
    EXPECT_FALSE(trueTouch(slab(), falling, seen(aside, 0.004), 0.003)) << "it was there in the step before";
    EXPECT_FALSE(trueTouch(slab(), {deep, Vec3(5, 0, -0.1), radius}, seen(aside, 0.004), step_s));
    EXPECT_FALSE(trueTouch(slab(), {deep, Vec3::Zero(), radius}, seen(aside, 0.004), step_s));
}

/// Both edges of a gap are touched at the same time.
TEST(FirstTouch, ContactsAtOnePlaceDoNotTakeThoseAtAnother) {
    const TriangleMesh groove = shapes::uShape(0.1, 0.04, 0.2, 0.2);
    const Eigen::AlignedBox3d box = boundingBox(groove);
    const SurfaceTree tree(groove);
    // A ball of 0.03 m lies on the two edges of a gap of 0.04 m.
    const Vec3 middle = box.center();
    for (const double side : {-1.0, 1.0}) {
        const Vec3 edge(middle.x() + side * 0.02, middle.y(), box.max().z());
        const Vec3 then(middle.x(), middle.y(), box.max().z() + std::sqrt(0.03 * 0.03 - 0.02 * 0.02));
        const MovingBall ball{then - Vec3(0, 0, 0.01), Vec3(0, 0, -5), 0.03};
        ASSERT_LT((nearestSurfacePoint(tree, edge, -Vec3::UnitZ()).point - edge).norm(), 1e-9)
            << "of the shape that this test is about";
        EXPECT_FALSE(trueTouch(tree, ball, seen(edge - then, 0.002), step_s)) << side;
    }
}

/// A box with a cavity is several hulls. Deep in one of them, beside a seam, a ball comes out at its side.
TEST(FirstTouch, ABallOnTheSeamOfHullsStrikesTheFaceItFlewAt) {
    Settings settings;
    settings.sampling.spacing_m = 0.03;
    const TriangleMesh hollow =
        shapes::joined(shapes::box(Vec3(-0.2, -0.15, -0.1), Vec3(0.2, 0.15, 0.1)),
                       shapes::inverted(shapes::box(Vec3(-0.19, -0.13, -0.08), Vec3(0.17, 0.12, 0.07))));
    const auto asset = BreakableAsset::fromMesh(hollow, Material::ceramic(), settings);
    ASSERT_TRUE(asset) << asset.error();
    const double slope = 15 * pi / 180;
    const Vec3 velocity = 6 * Vec3(std::sin(slope), 0, -std::cos(slope));
    int struck = 0;
    for (int place = 0; place < 60; ++place) {
        const Vec3 there(0.2 * std::fmod(0.618 * place, 1) - 0.1, 0.12 * std::fmod(0.755 * place, 1) - 0.06,
                         0.1);
        const double phase = std::fmod(0.57 * place, 1);
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.setBudget(Budget::none()));
        ASSERT_TRUE(fracture.add(asset.value(), BodyOptions{}));
        const Vec3 from = there + Vec3(0, 0, radius) - (2 + phase) / 60 * velocity;
        scene.addBall(1, radius, toBullet(from), toBullet(velocity));
        for (int step = 0; step < 5; ++step) {
            scene.step(1, 1.0 / 60);
            const std::vector<BlowEvent> events = fracture.takeEvents();
            if (events.empty()) continue;
            EXPECT_GT(-events.front().normal.z(), std::cos(3 * pi / 180)) << place;
            EXPECT_LT((events.front().position - there).norm(), 0.003) << place;
            ++struck;
            break;
        }
    }
    EXPECT_GT(struck, 50) << "in a step at 60 a second some go through";
}

}  // namespace
