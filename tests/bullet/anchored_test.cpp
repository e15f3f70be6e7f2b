// Bodies that the world holds on parts of their surface.

#include <algorithm>
#include <cmath>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

const Vec3 wall_size(1, 0.09, 1);

/// The plaster wall of the scene, its foot at z = 0.
BreakableAsset wall() {
    Settings settings;
    settings.sampling.spacing_m = 0.045;
    const auto asset = BreakableAsset::fromMesh(
        shapes::box(Vec3(-0.5, -0.045, 0), Vec3(0.5, 0.045, 1), 10, 1, 10), Material::plaster(), settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value();
}

BoxRegion flat(const Vec3& lo, const Vec3& hi) {
    return {lo, hi};
}
SurfaceRegion foot() {
    return flat({-1, -1, 0}, {1, 1, 0});
}
std::vector<SurfaceRegion> allRound() {
    return {foot(), flat({-1, -1, 1}, {1, 1, 1}), flat({-0.5, -1, -1}, {-0.5, 1, 2}),
            flat({0.5, -1, -1}, {0.5, 1, 2})};
}

/// The ball of the scene at the wall's middle.
void strikeMiddle(TestWorld& scene, double speed_m_s = 8) {
    scene.addBall(33, 0.1, btVector3(0, -0.165f, 0.5f), btVector3(0, btScalar(speed_m_s), 0));
}

btVector3 placeOf(const FractureWorld& fracture, const btRigidBody* body) {
    return fracture.assetTransform(body).getOrigin();
}

/// Of the pieces that touch the foot (or, with `rim`, any side), how many are static; of the others, how
/// many.
struct Held {
    int static_at_support = 0, moving_at_support = 0, static_elsewhere = 0, moving_elsewhere = 0;
};
Held countHeld(const FractureWorld& fracture, const std::vector<btRigidBody*>& pieces, bool rim) {
    Held held;
    for (const btRigidBody* piece : pieces) {
        if (!fracture.asset(piece)) continue;  // it stood in the way, and was torn out
        const TriangleMesh& surface = fracture.asset(piece)->surface();
        double area = 0;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            if (surface.kinds[t] == SurfaceKind::crack) continue;
            const auto& corner = surface.triangles[t];
            const Vec3 &a = surface.vertices[corner[0]], &b = surface.vertices[corner[1]],
                       &c = surface.vertices[corner[2]];
            const Vec3 middle = (a + b + c) / 3;
            const bool there =
                std::abs(middle.z()) < 1e-6 ||
                (rim && (std::abs(middle.z() - 1) < 1e-6 || std::abs(std::abs(middle.x()) - 0.5) < 1e-6));
            if (there) area += (b - a).cross(c - a).norm() / 2;
        }
        const bool at_support = area > 0.001;
        ++(piece->isStaticObject() ? (at_support ? held.static_at_support : held.static_elsewhere)
                                   : (at_support ? held.moving_at_support : held.moving_elsewhere));
    }
    return held;
}

void expectHeldAtSupportsOnly(const Held& held) {
    EXPECT_GT(held.static_at_support, 0);
    EXPECT_GT(held.moving_elsewhere, 0);
    EXPECT_EQ(held.static_elsewhere, 0);
    EXPECT_EQ(held.moving_at_support, 0);
}

TEST(Anchored, AWallHeldAtItsFootBreaksAndItsFootStays) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    FractureWorld fracture(scene.world.get());
    BodyOptions options;
    options.supports = {foot()};
    const auto added = fracture.add(wall(), options);
    ASSERT_TRUE(added.ok()) << added.error();
    EXPECT_TRUE(added.value()->isStaticObject());
    strikeMiddle(scene);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    expectHeldAtSupportsOnly(countHeld(fracture, event.fragments, false));
    EXPECT_EQ(event.momentum_error_rel, 0);

    std::vector<btRigidBody*> falling;
    for (btRigidBody* piece : event.fragments)
        if (!piece->isStaticObject()) falling.push_back(piece);
    EXPECT_GT(falling.size(), 2u);
    scene.addFloor();
    std::vector<btVector3> before;
    for (const btRigidBody* piece : falling) before.push_back(piece->getCenterOfMassPosition());
    scene.step(240);
    int lower = 0;
    for (std::size_t i = 0; i < falling.size(); ++i)
        lower +=
            !inWorld(scene, falling[i]) || falling[i]->getCenterOfMassPosition().z() < before[i].z() - 0.02;
    EXPECT_GE(lower, static_cast<int>(falling.size()) / 2) << "of " << falling.size();
    for (const btRigidBody* body : fracture.bodies()) {
        if (!body->isStaticObject()) continue;
        EXPECT_LT(placeOf(fracture, body).length(), 1e-5) << "what is held stays where it is";
        EXPECT_FALSE(fracture.asset(body)->supports().empty());
    }
}

TEST(Anchored, AWallHeldAllRoundKeepsItsRim) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    FractureWorld fracture(scene.world.get());
    BodyOptions options;
    options.supports = allRound();
    ASSERT_TRUE(fracture.add(wall(), options).ok());
    strikeMiddle(scene, 12);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    expectHeldAtSupportsOnly(countHeld(fracture, event.fragments, true));
}

// A rod held at one end and struck at the other stores what the ball brings: 1/2 m v^2 = F^2 L^3 / (6 E I),
// and its stress at the clamp is F L / W. Poisson's ratio is 0, for a clamp that also holds the section's
// width has a singular stress in its corners.
TEST(Anchored, ARodHeldAtOneEndHasTheStressOfACantilever) {
    const double length = 0.5, edge = 0.02, mass = 0.01, speed = 0.4;
    Material material = Material::plaster();
    material.poisson_ratio = 0;
    material.fracture_energy_j_m2 = 1e-3;  // so that the blow is solved; it holds
    const auto rod = BreakableAsset::fromMesh(
        shapes::box(Vec3(0, -edge / 2, -edge / 2), Vec3(length, edge / 2, edge / 2), 25, 1, 1), material,
        Settings{});
    ASSERT_TRUE(rod.ok()) << rod.error();
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    BodyOptions options;
    options.supports = {flat({0, -1, -1}, {0, 1, 1})};
    ASSERT_TRUE(fracture.add(rod.value(), options).ok());
    const double at_x = length - edge / 2;
    scene.addBall(mass, 0.02, btVector3(btScalar(at_x), 0, btScalar(0.02 + edge / 2 + 1e-4)),
                  btVector3(0, 0, btScalar(-speed)));
    for (int i = 0; i < 10; ++i) scene.step();
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_FALSE(events.empty());
    const BlowEvent& event = events.front();
    EXPECT_EQ(event.outcome, Outcome::held) << event.message;
    const double inertia = std::pow(edge, 4) / 12, modulus = material.youngs_modulus_pa;
    const double stiffness = 3 * modulus * inertia / std::pow(at_x, 3);
    const double force = std::sqrt(stiffness * mass) * speed;
    EXPECT_NEAR(event.peak_force_n / force, 1, 0.05) << "the patch and the shear give way too";
    const double stress = event.peak_force_n * at_x / (std::pow(edge, 3) / 6);
    EXPECT_NEAR(event.largest_stress_pa / stress, 1, 0.05);
}

TEST(Anchored, AnAppsStaticWallBreaksOnlyWhereItIsSaidToBeHeld) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    btRigidBody* body = scene.addBox(0, btVector3(0.5f, 0.045f, 0.5f), btVector3(0, 0, 0.5f));
    FractureWorld fracture(scene.world.get());
    const Status refused = fracture.makeBreakable(body, Material::plaster());
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().find("supports"), std::string::npos) << refused.error();
    BreakableOptions options;
    options.supports = {flat({-1, -1, 5}, {1, 1, 5})};
    EXPECT_NE(
        fracture.makeBreakable(body, Material::plaster(), {}, options).error().find("No part of the surface"),
        std::string::npos);
    options.supports = {flat({-1, -1, -0.5}, {1, 1, -0.5})};
    const Status made = fracture.makeBreakable(body, Material::plaster(), {}, options);
    ASSERT_TRUE(made.ok()) << made.error();
    strikeMiddle(scene);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    EXPECT_EQ(event.body, body);
    double mass = 0;
    for (const btRigidBody* piece : event.fragments) mass += fracture.asset(piece)->mass();
    EXPECT_NEAR(mass, wall_size.prod() * Material::plaster().density_kg_m3, 1e-3);
}

TEST(Anchored, PiecesOfABodyHeldByAConstraintStayWhereItHeldThem) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    btRigidBody* body = scene.addBox(104, btVector3(0.5f, 0.045f, 0.5f), btVector3(0, 0, 0.5f));
    btRigidBody* ground = scene.addBox(0, btVector3(1, 1, 0.1f), btVector3(0, 0, -0.2f));
    btFixedConstraint hold(*body, *ground, at(0, 0, -0.5f), at(0, 0, 0.2f));
    scene.world->addConstraint(&hold, true);
    FractureWorld fracture(scene.world.get());
    BreakableOptions options;
    options.supports = {flat({-1, -1, -0.5}, {1, 1, -0.5})};
    const Status made = fracture.makeBreakable(body, Material::plaster(), {}, options);
    ASSERT_TRUE(made.ok()) << made.error();
    strikeMiddle(scene);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    ASSERT_EQ(event.removed_constraints.size(), 1u);
    int held = 0, loose = 0;
    for (const btRigidBody* piece : event.fragments) ++(piece->isStaticObject() ? held : loose);
    EXPECT_GT(held, 0);
    EXPECT_GT(loose, 0);
}

TEST(Anchored, WhatIsNoSupportIsRefusedWithASentence) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = wall();
    EXPECT_NE(asset.anchored({}).error().find("no support"), std::string::npos);
    EXPECT_NE(asset.anchored({SphereRegion{Vec3(0, 0, 9), 0.1}}).error().find("No part of the surface"),
              std::string::npos);
    EXPECT_NE(asset.anchored({SphereRegion{Vec3(0, 0, 0), -1}}).error().find("radius"), std::string::npos);
    EXPECT_NE(asset.anchored({SphereRegion{Vec3(0, 0.045, 0.5), 0.001}}).error().find("turn"),
              std::string::npos);
    BodyOptions options;
    options.supports = {foot()};
    options.velocity = btVector3(1, 0, 0);
    EXPECT_NE(fracture.add(asset, options).error().find("static"), std::string::npos);
}

TEST(Anchored, SaysThatOnlyTheFreeBodyWasPrepared) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.5, -0.05, 0), Vec3(0.5, 0.05, 1)),
                                                crumbly(), coarse(0.1));
    ASSERT_TRUE(asset.value().prepare().ok());
    BodyOptions options;
    options.supports = {foot()};
    const auto warnings = [&] {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(asset.value(), options).value();
        EXPECT_TRUE(fracture.applyBlow(body, {btVector3(0, -0.05f, 0.8f), btVector3(0, 100, 0)}).ok());
        return fracture.takeEvents().at(0).warnings;
    };
    const std::vector<std::string> not_prepared = warnings();
    ASSERT_EQ(not_prepared.size(), 1u);
    EXPECT_NE(not_prepared[0].find("not as supports hold this body"), std::string::npos) << not_prepared[0];
    const BreakableAsset held = asset.value().anchored(options.supports).value();
    ASSERT_TRUE(held.prepare().ok());
    EXPECT_TRUE(warnings().empty()) << "bodies that are held alike share what is prepared";
}

TEST(Anchored, BodiesWithSeedsThatAreHeldAlikeArePreparedTogether) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = wall();
    BodyOptions options;
    options.supports = {foot()};
    std::vector<btRigidBody*> bodies;
    for (const int seed : {4, 5}) {  // nothing but the bodies keeps what they share
        options.seed = seed;
        bodies.push_back(fracture.add(asset, options).value());
    }
    ASSERT_TRUE(fracture.asset(bodies[0])->prepare().ok());
    EXPECT_TRUE(fracture.asset(bodies[1])->prepared());
}

/// Of the bodies that move, kg m/s.
btVector3 momentumOf(const FractureWorld& fracture) {
    btVector3 sum(0, 0, 0);
    for (const btRigidBody* body : fracture.bodies())
        if (body->getInvMass() > 0) sum += body->getLinearVelocity() / body->getInvMass();
    return sum;
}

/// A wall held at its foot that breaks at a touch.
struct WeakWall {
    WeakWall() {
        BodyOptions options;
        options.supports = {foot()};
        const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.5, -0.05, 0), Vec3(0.5, 0.05, 1)),
                                                    crumbly(), coarse(0.1));
        EXPECT_TRUE(asset.ok()) << asset.error();
        body = fracture.add(asset.value(), options).value();
    }
    Push push(double speed_m_s = 50) const {
        return {btVector3(0, -0.05f, 0.8f), btVector3(0, 100, 0), 0, speed_m_s};
    }

    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    btRigidBody* body = nullptr;
};

TEST(Anchored, WhatComesLooseTakesTheImpulseOfAnAppliedBlow) {
    WeakWall between;
    ASSERT_TRUE(between.fracture.applyBlow(between.body, between.push()).ok());
    ASSERT_FALSE(inWorld(between.scene, between.body));
    EXPECT_NEAR(momentumOf(between.fracture).y(), 100, 0.01);
    // As one rigid body: the top, which is above the centre, is the fastest.
    const btRigidBody *highest = nullptr, *lowest = nullptr;
    for (const btRigidBody* piece : between.fracture.bodies()) {
        if (piece->isStaticObject()) continue;
        const btScalar z = piece->getCenterOfMassPosition().z();
        if (!highest || z > highest->getCenterOfMassPosition().z()) highest = piece;
        if (!lowest || z < lowest->getCenterOfMassPosition().z()) lowest = piece;
    }
    ASSERT_NE(highest, lowest);
    EXPECT_GT(highest->getLinearVelocity().y(), lowest->getLinearVelocity().y());
    EXPECT_EQ(highest->getAngularVelocity(), lowest->getAngularVelocity());

    WeakWall inside;
    inside.scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            WeakWall& self = *static_cast<WeakWall*>(world->getWorldUserInfo());
            if (self.fracture.asset(self.body)) (void)self.fracture.applyBlow(self.body, self.push());
        },
        &inside);
    inside.scene.step();
    inside.scene.world->setInternalTickCallback(nullptr);
    EXPECT_NEAR(momentumOf(inside.fracture).y(), 100, 0.01);
}

TEST(Anchored, WhatComesLooseIsNoFasterThanWhatStruckIt) {
    for (const double speed_m_s : {0.0, 1.2}) {  // 0: that which the impulse gives to the wall, as a mass
        WeakWall wall;
        const double mass = wall.fracture.asset(wall.body)->mass();
        const Push push = wall.push(speed_m_s);
        ASSERT_TRUE(wall.fracture.applyBlow(wall.body, push).ok());
        ASSERT_FALSE(inWorld(wall.scene, wall.body));
        const double fastest = speed_m_s > 0 ? speed_m_s : 100 / mass;
        EXPECT_GT(momentumOf(wall.fracture).y(), 10);
        for (const btRigidBody* piece : wall.fracture.bodies()) {
            if (piece->isStaticObject()) continue;
            const btVector3 at_push =
                piece->getVelocityInLocalPoint(push.point - piece->getCenterOfMassPosition());
            EXPECT_NEAR(at_push.y(), fastest, 1e-3 * fastest);
        }
    }
}

TEST(Anchored, APushInPartsMovesWhatComesLooseAsTheWholePushDoes) {
    const auto momentumBy = [](int parts) {
        WeakWall wall;
        Push part = wall.push(1.2);
        part.impulse_n_s = btVector3(0, btScalar(1000) / btScalar(parts), 0);
        EXPECT_TRUE(wall.fracture.applyBlow(wall.body, std::vector<Push>(std::size_t(parts), part)).ok());
        EXPECT_FALSE(inWorld(wall.scene, wall.body));
        return double(momentumOf(wall.fracture).y());
    };
    const double whole = momentumBy(1);
    EXPECT_GT(whole, 10);
    EXPECT_NEAR(momentumBy(8) / whole, 1, 1e-3);
}

TEST(Anchored, WhatHitsAFragmentThatStaysHeldMovesNothing) {
    WeakWall wall;
    Push push = wall.push();
    push.point = btVector3(0, -0.05f, 0);
    ASSERT_TRUE(wall.fracture.applyBlow(wall.body, push).ok());
    ASSERT_FALSE(inWorld(wall.scene, wall.body));
    EXPECT_EQ(momentumOf(wall.fracture).length(), 0);
}

TEST(Anchored, AnExplosionThrowsWhatComesLoose) {
    WeakWall wall;
    const Result<int> struck = explode(wall.fracture, Explosion{btVector3(0, -0.4f, 0.6f), 2000, 3});
    ASSERT_TRUE(struck.ok()) << struck.error();
    EXPECT_EQ(struck.value(), 1);
    // The wall, 0.35 m away, fills about a third of the half-space: its share along y is some hundreds of N
    // s.
    EXPECT_GT(momentumOf(wall.fracture).y(), 100);
    EXPECT_LT(momentumOf(wall.fracture).y(), 1000);
}

// Cracks part a wall before a harder blast has damaged all of it: what is left does not hang together again.
TEST(Anchored, AHarderExplosionLeavesHardlyFewerPieces) {
    Settings settings;
    settings.sampling.spacing_m = 0.09;
    const auto wall = BreakableAsset::fromMesh(boxMesh({2, 0.12, 1.5}), Material::brick(), settings)
                          .value()
                          .anchored({BoxRegion{{-1, -1, -0.75}, {1, 1, -0.75}}});
    ASSERT_TRUE(wall.value().prepare().ok());
    std::size_t most = 1;
    for (double impulse_n_s = 5000; impulse_n_s < 60000; impulse_n_s *= 1.3) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.add(wall.value()).ok());
        ASSERT_TRUE(explode(fracture, Explosion{btVector3(0, -1.5f, 0), impulse_n_s, 5}).ok());
        const std::size_t pieces = fracture.bodies().size();
        EXPECT_GE(pieces + 1, most) << impulse_n_s;
        most = std::max(most, pieces);
    }
    EXPECT_EQ(most, 20u);
}

/// Four walls about an explosion: all but the nearest wait for their turn.
struct WallsInTurn : WeakWall {
    WallsInTurn() {
        scene.world->setGravity(btVector3(0, 0, 0));
        for (const btTransform& start : {at(-1.1f, 0, 0), at(1.1f, 0, 0), at(0, -0.7f, 0)}) {
            BodyOptions beside;
            beside.start = start;
            EXPECT_TRUE(fracture.add(*fracture.asset(body), beside).ok());
        }
        Budget budget;
        budget.milliseconds_per_step = 0.1;
        EXPECT_TRUE(fracture.setBudget(budget).ok());
        EXPECT_EQ(explode(fracture, Explosion{btVector3(0, -0.4f, 0.6f), 2000, 5}).value(), 4);
        EXPECT_TRUE(inWorld(scene, body));
        EXPECT_EQ(ahead(), 0);
        EXPECT_LT(momentumOf(fracture).y(), -100) << "the nearest";
    }
    /// The momentum of what is beyond the explosion, kg m/s.
    btScalar ahead() const {
        btScalar sum = 0;
        for (const btRigidBody* piece : fracture.bodies())
            if (!piece->isStaticObject() && piece->getCenterOfMassPosition().y() > -0.4f)
                sum += piece->getLinearVelocity().y() / piece->getInvMass();
        return sum;
    }
};

TEST(Anchored, AnExplosionAmongManyThrowsWhatComesLooseLater) {
    WallsInTurn walls;
    for (int step = 0; step < 130 && inWorld(walls.scene, walls.body); ++step) walls.scene.step();
    ASSERT_FALSE(inWorld(walls.scene, walls.body));
    EXPECT_GT(walls.ahead(), 100);
    EXPECT_LT(walls.ahead(), 1000);
}

TEST(Anchored, AWeakerStrikeDoesNotForestallAnExplosion) {
    WallsInTurn walls;
    const auto tile = BreakableAsset::fromMesh(shapes::box(Vec3(-0.1, -0.03, -0.1), Vec3(0.1, 0.03, 0.1)),
                                               Material::glass(), coarse(0.05));
    BodyOptions flying(at(0, 0.15f, 0.8f));
    flying.velocity = btVector3(0, -8, 0);
    ASSERT_TRUE(walls.fracture.add(tile.value(), flying).ok());
    double waited_s = -1;
    for (int step = 0; step < 130 && waited_s < 0; ++step) {
        walls.scene.step();
        for (const BlowEvent& event : walls.fracture.takeEvents())
            if (event.body == walls.body && event.outcome == Outcome::broke) waited_s = event.waited_s;
    }
    EXPECT_GT(waited_s, 0);
}

TEST(Anchored, AnotherBlowDoesNotTakeAwayWhatAnExplosionIsStillToThrow) {
    WallsInTurn walls;
    Push push = walls.push();
    push.impulse_n_s *= 0.4f;
    ASSERT_TRUE(walls.fracture.applyBlow(walls.body, push).ok());
    ASSERT_FALSE(inWorld(walls.scene, walls.body));
    EXPECT_GT(walls.ahead(), 100 + push.impulse_n_s.y());
}

TEST(Anchored, AnExplosionBetweenTwoHeldWallsThrowsEachOutwards) {
    WeakWall walls;
    BodyOptions behind;
    behind.start = at(0, -0.8f, 0);
    ASSERT_TRUE(walls.fracture.add(*walls.fracture.asset(walls.body), behind).ok());
    const Result<int> struck = explode(walls.fracture, Explosion{btVector3(0, -0.4f, 0.6f), 2000, 3});
    ASSERT_TRUE(struck.ok()) << struck.error();
    EXPECT_EQ(struck.value(), 2);
    btScalar ahead = 0, back = 0;
    for (const btRigidBody* piece : walls.fracture.bodies())
        if (!piece->isStaticObject())
            (piece->getCenterOfMassPosition().y() > -0.4f ? ahead : back) +=
                piece->getLinearVelocity().y() / piece->getInvMass();
    EXPECT_GT(ahead, 100);
    EXPECT_NEAR(ahead, -back, 0.3 * ahead) << "alike but for where the cracks run";
}

}  // namespace
