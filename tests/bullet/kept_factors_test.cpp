// Stress problems that fragments keep which held a blow.

#include <algorithm>
#include <future>
#include <vector>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// The pieces of a plate that float in space, each struck on its own.
struct Pieces {
    Pieces() {
        Budget budget = Budget::none();
        budget.prepared_fragments = 0;
        EXPECT_TRUE(fracture.setBudget(budget).ok());
        BodyOptions options;
        options.fracture.emplace();
        options.fracture->use_coarse_model = false;
        options.fracture->largest_fragment_count = 8;
        const Result<btRigidBody*> whole = fracture.add(plate(Material::plaster(), 0.03), options);
        EXPECT_TRUE(whole.ok());
        EXPECT_TRUE(fracture.applyBlow(whole.value(), {btVector3(0, 0, 0.03f), btVector3(0, 0, -50)}).ok());
        scene.step(60);  // the pieces part, and may break
        fracture.takeEvents();
        bodies = fracture.bodies();
    }
    /// At a corner, towards the centre. The event, if more than the gate decides it.
    std::vector<BlowEvent> strike(btRigidBody* piece, double impulse_n_s) {
        const Vec3 corner = fracture.asset(piece)->surface().vertices.front();
        const btTransform placed = fracture.assetTransform(piece);
        const btVector3 at =
            placed * btVector3(btScalar(corner.x()), btScalar(corner.y()), btScalar(corner.z()));
        const btVector3 inwards = (piece->getCenterOfMassPosition() - at).normalized();
        const Status pushed = fracture.applyBlow(piece, {at, btScalar(impulse_n_s) * inwards});
        EXPECT_TRUE(pushed.ok()) << pushed.error();
        return fracture.takeEvents();
    }
    bool isFactored(const btRigidBody* piece) const { return fracture.asset(piece)->unknownCount() > 0; }

    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    std::vector<btRigidBody*> bodies;
};

/// The weakest blow that is solved, N s; 0 if the piece does not hold it.
double heldImpulse(Pieces& pieces, btRigidBody* piece) {
    for (double impulse = 1e-4; impulse < 100; impulse *= 1.5)
        for (const BlowEvent& event : pieces.strike(piece, impulse))
            return event.outcome == Outcome::held && event.level == Level::full ? impulse : 0;
    return 0;
}

TEST(KeptFactors, AreThoseOfTheFragmentsThatHeldLast) {
    Pieces pieces;
    std::vector<btRigidBody*> held;
    std::vector<double> impulses;
    for (btRigidBody* piece : pieces.bodies) {
        const double impulse = heldImpulse(pieces, piece);
        if (impulse == 0) continue;
        EXPECT_TRUE(pieces.isFactored(piece));
        held.push_back(piece);
        impulses.push_back(impulse);
    }
    ASSERT_GE(held.size(), 4u);
    for (std::size_t i = 0; i < held.size(); ++i)
        EXPECT_EQ(pieces.isFactored(held[i]), i + 2 >= held.size()) << i << " of " << held.size();

    const auto again = pieces.strike(held[0], impulses[0]);
    ASSERT_EQ(again.size(), 1u);
    EXPECT_EQ(again[0].level, Level::full);
    EXPECT_EQ(again[0].outcome, Outcome::held);
    EXPECT_TRUE(pieces.isFactored(held[0]));
    EXPECT_FALSE(pieces.isFactored(held[held.size() - 2]))
        << "the one of which nothing was heard for longest";
}

/// An app may have asked for it when the body broke off, and draws it.
TEST(KeptFactors, WhatElseIsMadeOfAFragmentStays) {
    Pieces pieces;
    btRigidBody* const first = pieces.bodies[0];
    const TriangleMesh& surface = pieces.fracture.asset(first)->surface();
    const std::size_t vertices = surface.vertices.size();
    std::future<Status> prepared;
    std::size_t held = 0;
    for (btRigidBody* piece : pieces.bodies) {
        held += heldImpulse(pieces, piece) > 0;
        if (piece == first)
            prepared = std::async(std::launch::async,
                                  [asset = *pieces.fracture.asset(first)] { return asset.prepare(); });
    }
    ASSERT_GE(held, 4u);
    EXPECT_EQ(&pieces.fracture.asset(first)->surface(), &surface);
    EXPECT_EQ(surface.vertices.size(), vertices);
    ASSERT_TRUE(prepared.get().ok());
    EXPECT_TRUE(pieces.fracture.asset(first)->prepared());
}

/// Each would keep some megabytes.
TEST(KeptFactors, AreNotThoseOfEvents) {
    Pieces pieces;
    for (btRigidBody* piece : pieces.bodies)
        for (double impulse = 1e-4; impulse < 100; impulse *= 1.5) {
            const auto events = pieces.strike(piece, impulse);
            if (events.empty()) continue;
            EXPECT_EQ(events[0].asset.unknownCount(), 0);
            EXPECT_EQ(&events[0].asset.surface(), &pieces.fracture.asset(piece)->surface());
            break;
        }
}

/// What a blow on one left behind would tell whether a coarse look decides that on the other.
TEST(KeptFactors, AreNotSharedByBodiesThatAnAppMakesOfAFragment) {
    Pieces pieces;
    const BreakableAsset asset = *pieces.fracture.asset(pieces.bodies[0]);
    BodyOptions options(at(0, 5, 0));
    options.fracture.emplace();
    options.fracture->use_coarse_model = false;
    btRigidBody* const a = pieces.fracture.add(asset, options).value();
    options.start = at(0, 9, 0);
    btRigidBody* const b = pieces.fracture.add(asset, options).value();
    EXPECT_GT(heldImpulse(pieces, a), 0);
    EXPECT_TRUE(pieces.isFactored(a));
    EXPECT_FALSE(pieces.isFactored(b));
    EXPECT_EQ(a->getCollisionShape(), b->getCollisionShape());
}

}  // namespace
