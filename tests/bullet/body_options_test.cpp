// What a body may be given when it is added, what is refused, and where it is drawn between steps.

#include <limits>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

TEST(BodyOptions, AllOfThemReachTheBody) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    int tag = 0;
    btDefaultMotionState motion_state;
    BodyOptions options(btTransform(btQuaternion(btVector3(1, 1, 0), 0.5f), btVector3(1, 2, 3)));
    options.velocity = btVector3(1, 2, 3);
    options.angular_velocity = btVector3(4, 5, 6);
    options.collision_group = 2;
    options.collision_mask = 5;
    options.user_pointer = &tag;
    options.user_index = 7;
    options.motion_state = &motion_state;
    options.name = "vase";
    const btRigidBody* body = fracture.add(plate(crumbly()), options).value();
    EXPECT_LT(fracture.assetTransform(body).getOrigin().distance(btVector3(1, 2, 3)), 1e-5);
    EXPECT_EQ(body->getLinearVelocity(), btVector3(1, 2, 3));
    EXPECT_EQ(body->getAngularVelocity(), btVector3(4, 5, 6));
    EXPECT_EQ(body->getBroadphaseHandle()->m_collisionFilterGroup, 2);
    EXPECT_EQ(body->getBroadphaseHandle()->m_collisionFilterMask, 5);
    EXPECT_EQ(body->getUserPointer(), &tag);
    EXPECT_EQ(body->getUserIndex(), 7);
    EXPECT_EQ(body->getMotionState(), &motion_state);
    EXPECT_EQ(motion_state.m_graphicsWorldTrans.getOrigin(), body->getWorldTransform().getOrigin());
    EXPECT_EQ(fracture.name(body), "vase");
    EXPECT_EQ(fracture.name(scene.addFloor()), "");
}

TEST(BodyOptions, WithoutAnyABodyIsWhatBulletMakes) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const btRigidBody* body = fracture.add(plate(crumbly())).value();
    const btBroadphaseProxy* bullets = scene.addBall(1, 0.1, btVector3(0, 0, 5))->getBroadphaseHandle();
    EXPECT_EQ(body->getBroadphaseHandle()->m_collisionFilterGroup, bullets->m_collisionFilterGroup);
    EXPECT_EQ(body->getBroadphaseHandle()->m_collisionFilterMask, bullets->m_collisionFilterMask);
    EXPECT_EQ(body->getLinearVelocity(), btVector3(0, 0, 0));
    EXPECT_EQ(body->getUserPointer(), nullptr);
    EXPECT_EQ(body->getUserIndex(), -1);
}

TEST(BodyOptions, RefusalsSayWhatIsWrong) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = plate(crumbly());
    const auto refusal = [&](void (*spoil)(BodyOptions&)) {
        BodyOptions options;
        spoil(options);
        return fracture.add(asset, options).error();
    };
    constexpr btScalar nan = std::numeric_limits<btScalar>::quiet_NaN();
    const std::string rigid =
        "the start is not a rotation and a translation (its matrix scales, mirrors or is not finite); scale "
        "the mesh instead";
    EXPECT_EQ(refusal([](BodyOptions& o) { o.start.getBasis() = o.start.getBasis() * btScalar(2); }), rigid);
    EXPECT_EQ(refusal([](BodyOptions& o) { o.start.getBasis()[2] *= -1; }), rigid);
    EXPECT_EQ(refusal([](BodyOptions& o) { o.start.getBasis()[0][0] = nan; }), rigid);
    EXPECT_EQ(refusal([](BodyOptions& o) { o.start.getOrigin()[1] = nan; }),
              "the start is not finite; give its place in m");
    EXPECT_EQ(refusal([](BodyOptions& o) { o.velocity[0] = nan; }),
              "the velocity is not finite; give it in m/s");
    EXPECT_EQ(refusal([](BodyOptions& o) { o.angular_velocity[0] = nan; }),
              "the angular velocity is not finite; give it in rad/s");
    EXPECT_EQ(refusal([](BodyOptions& o) { o.velocity[2] = btScalar(1e20); }),
              "the velocity is faster than light; give it in m/s");
    EXPECT_NE(refusal([](BodyOptions& o) { o.start.getOrigin()[0] = btScalar(1e30); }).find("10,000 km"),
              std::string::npos);
    EXPECT_EQ(refusal([](BodyOptions& o) {
                  o.fracture = FractureSettings();
                  o.fracture->largest_fragment_count = 1;
              }),
              "FractureSettings: largest_fragment_count is 1 but must be at least 2.");
    EXPECT_EQ(scene.world->getNumCollisionObjects(), 0);
}

std::vector<double> masses(const BlowEvent& event) {
    std::vector<double> result;
    for (const btRigidBody* piece : event.fragments) result.push_back(1 / piece->getInvMass());
    return result;
}

const Push hard_push{btVector3(0.05f, 0, 0.03f), btVector3(0, 0, -50)};

/// The only event of a push.
BlowEvent struck(FractureWorld& fracture, btRigidBody* body, Push push = hard_push) {
    push.point += body->getCenterOfMassPosition();
    const Status done = fracture.applyBlow(body, push);
    EXPECT_TRUE(done.ok()) << done.error();
    std::vector<BlowEvent> events = fracture.takeEvents();
    return events.empty() ? noBreak() : events.front();
}

TEST(BodyOptions, BodiesOfOneAssetBreakEachByItsOwnSettings) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = plate(crumbly());
    BodyOptions few(at(0, 0, 0)), boxed(at(2, 0, 0)), as_the_asset(at(4, 0, 0));
    few.fracture = boxed.fracture = asset.settings().fracture;
    few.fracture->fragment_count = 2;
    few.fracture->rest_after_break_s = few.fracture->same_blow_s = 0;
    few.fracture->smallest_fragment_m3 = 1e-6;
    boxed.fracture->collision_shape = CollisionShape::boxes;

    const BlowEvent two = struck(fracture, fracture.add(asset, few).value());
    EXPECT_EQ(two.fragments.size(), 2u);
    const BlowEvent boxes = struck(fracture, fracture.add(asset, boxed).value());
    const BlowEvent hull = struck(fracture, fracture.add(asset, as_the_asset).value());
    EXPECT_GT(hull.fragments.size(), 3u);
    EXPECT_GT(boxes.fragments.size(),
              3u);  // other ones: cracks between cells do not run like those through them
    EXPECT_TRUE(hull.fragments.front()->getCollisionShape()->isConvex());
    EXPECT_TRUE(boxes.fragments.front()->getCollisionShape()->isCompound());

    // And so do their fragments: those of the others are debris by their settings.
    EXPECT_EQ(struck(fracture, two.fragments.front()).fragments.size(), 2u);
    EXPECT_EQ(struck(fracture, hull.fragments.front()).outcome, Outcome::held);
}

TEST(BodyOptions, ASeedOfItsOwnMakesABodyBreakAlikeAnywhere) {
    const BreakableAsset asset = plate(crumbly());
    const auto pieces = [&](std::optional<std::uint64_t> seed, bool others_before) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        if (others_before) fracture.add(asset, at(0, 0, 9)).value();
        BodyOptions options;
        options.seed = seed;
        options.fracture = asset.settings().fracture;
        options.fracture->rest_after_break_s = options.fracture->same_blow_s = 0;
        options.fracture->smallest_fragment_m3 = 1e-6;
        const BlowEvent first = struck(fracture, fracture.add(asset, options).value());
        std::vector<double> result = masses(first);
        EXPECT_GE(result.size(), 2u) << first.message;
        const std::vector<double> again = masses(struck(fracture, first.fragments.front()));
        EXPECT_GE(again.size(), 2u);
        result.insert(result.end(), again.begin(), again.end());
        return result;
    };
    EXPECT_EQ(pieces(5, false), pieces(5, true));
    EXPECT_NE(pieces(5, false), pieces(6, false));
    EXPECT_NE(pieces({}, false), pieces({}, true)) << "the order decides where no seed is given";
}

TEST(Rendering, ABodyMovesSmoothlyBetweenSteps) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    // A body whose centre of mass is not the origin of its mesh.
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(1, 0, 0), Vec3(1.6, 0.6, 0.06)), crumbly(), coarse(0.06));
    BodyOptions options(at(0, 0, 1));
    options.velocity = btVector3(2.4f, 0, 0);
    btRigidBody* body = fracture.add(asset.value(), options).value();
    const auto& motion_state = *static_cast<const btDefaultMotionState*>(body->getMotionState());
    EXPECT_LT(motion_state.m_graphicsWorldTrans.getOrigin().distance(btVector3(0, 0, 1)), 1e-5);
    btScalar before = 0;
    for (int frame = 1; frame <= 19; ++frame) {
        scene.world->stepSimulation(1.0f / 600, 4, 1.0f / 240);
        const btTransform drawn = fracture.renderTransform(body);
        EXPECT_LT(drawn.getOrigin().distance(motion_state.m_graphicsWorldTrans.getOrigin()), 1e-5);
        // Bullet draws one step late.
        if (frame > 3) {
            EXPECT_NEAR(drawn.getOrigin().x() - before, 2.4 / 600, 1e-5) << frame;
        }
        before = drawn.getOrigin().x();
    }
    EXPECT_GT(fracture.assetTransform(body).getOrigin().x(), before + 1e-3);
}

TEST(Rendering, FragmentsAreDrawnWhereTheWholeWasFromTheirFirstFrameOn) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    BodyOptions options;
    options.velocity = btVector3(2.4f, 0, 0);
    options.angular_velocity = btVector3(0, 0, 0.5f);
    btRigidBody* body = fracture.add(plate(crumbly()), options).value();
    for (int frame = 0; frame < 9; ++frame) scene.world->stepSimulation(1.0f / 600, 4, 1.0f / 240);
    const btTransform whole = fracture.renderTransform(body);
    ASSERT_GT(whole.getOrigin().distance(fracture.assetTransform(body).getOrigin()), 1e-3)
        << "between two steps";
    Push aside = hard_push;
    aside.impulse_n_s = btVector3(10, 0, -50);
    const BlowEvent event = struck(fracture, body, aside);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    const auto drawnWith = [&](const btTransform& expected, double tolerance) {
        for (const btRigidBody* piece : event.fragments) {
            const btTransform drawn = fracture.renderTransform(piece);
            for (const btVector3& corner : {btVector3(0.3f, 0.3f, 0), btVector3(-0.3f, 0.1f, 0)})
                EXPECT_LT((drawn * corner).distance(expected * corner), tolerance);
        }
    };
    drawnWith(whole, 1e-5);
    // A frame without a step: on with the motion from before the blow.
    scene.world->stepSimulation(1.0f / 2400, 4, 1.0f / 240);
    btTransform on = whole;
    on.getOrigin() += btVector3(2.4f / 2400, 0, 0);
    drawnWith(on, 2e-4);
    // And then with what the blow gave: no jump larger than that motion.
    const double fastest = event.fragments.front()->getLinearVelocity().length() + 2;
    for (int frame = 0; frame < 6; ++frame) {
        scene.world->stepSimulation(1.0f / 600, 4, 1.0f / 240);
        for (const btRigidBody* piece : event.fragments)
            EXPECT_LT(fracture.renderTransform(piece).getOrigin().distance(whole.getOrigin()),
                      fastest * (1.0 / 2400 + (frame + 1) / 600.0));
    }
}

TEST(BodyOptions, MassesBeyondSinglePrecisionAreRefused) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    for (const double density : {1e-40, 1e30}) {
        Material material = Material::plaster();
        material.density_kg_m3 = density;
        const auto body = fracture.add(plate(material), at(0, 0, 0));
        ASSERT_FALSE(body.ok()) << density;
        EXPECT_NE(body.error().find("density_kg_m3"), std::string::npos) << body.error();
    }
    EXPECT_EQ(scene.world->getNumCollisionObjects(), 0);
}

}  // namespace
