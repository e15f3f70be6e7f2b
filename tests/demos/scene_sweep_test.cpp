// Every scene with many seeds: what comes out is clean.
#include <gtest/gtest.h>

#include <iostream>
#include <tuple>

#include "demos/stage.h"
#include "support/piece_checks.h"

namespace {

using namespace demo_tests;
using namespace sherd::fragment_support;

constexpr int seeds = 20, seeds_a_test = 5;

struct Pieces {
    std::vector<sherd::TriangleMesh> surfaces;
    double volume = 0, mass = 0;
};

Pieces piecesOf(const Stage& stage) {
    Pieces pieces;
    for (const btRigidBody* body : stage.world->fracture().bodies()) {
        const sherd::BreakableAsset* piece = stage.world->fracture().asset(body);
        pieces.surfaces.push_back(piece->surface());
        pieces.volume += piece->volume();
        pieces.mass += 1 / static_cast<double>(body->getInvMass());
    }
    return pieces;
}

void expectSound(const Pieces& pieces, const Stage& stage) {
    for (const sherd::TriangleMesh& surface : pieces.surfaces) EXPECT_EQ(faultOf(surface), "");
    EXPECT_NEAR(pieces.volume / stage.assets.bodies[0].volume(), 1, 1e-3);
    EXPECT_NEAR(pieces.mass / stage.assets.bodies[0].mass(), 1, 1e-6);
    for (const auto& event : stage.events) EXPECT_EQ(event.message, "");
}

class SweptScene : public testing::TestWithParam<std::tuple<const char*, int>> {};

// Cracks are compared right after the first break: later ones may run across the faces that it made.
TEST_P(SweptScene, BreaksIntoSoundPieces) {
    const auto& [name, first_seed] = GetParam();
    std::size_t checked = 0;
    const SeededScene scene(named(name));
    for (int seed = first_seed; seed < first_seed + seeds_a_test; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Stage stage = scene.stage(static_cast<std::uint64_t>(seed));
        ASSERT_TRUE(stage.runToBreak(1.5));
        const Pieces at_once = piecesOf(stage);
        expectSound(at_once, stage);
        EXPECT_EQ(faultOfCracks(at_once.surfaces), "");
        checked += at_once.surfaces.size();

        stage.run(0.1);
        const Pieces later = piecesOf(stage);
        if (later.surfaces.size() == at_once.surfaces.size()) continue;
        expectSound(later, stage);
        checked += later.surfaces.size();
    }
    RecordProperty("pieces_checked", static_cast<int>(checked));
    std::cout << checked << " pieces checked\n";
}

TEST(SeededScene, BreaksAlikeWhateverSeedWasBefore) {
    const SeededScene used(named("coffee_cup")), fresh(named("coffee_cup"));
    Stage other = used.stage(1), second = used.stage(2), first = fresh.stage(2);
    ASSERT_TRUE(other.runToBreak(1.5));
    ASSERT_TRUE(second.runToBreak(1.5));
    ASSERT_TRUE(first.runToBreak(1.5));
    const Pieces later = piecesOf(second), at_once = piecesOf(first);
    ASSERT_EQ(later.surfaces.size(), at_once.surfaces.size());
    for (std::size_t i = 0; i < later.surfaces.size(); ++i)
        EXPECT_EQ(later.surfaces[i].vertices, at_once.surfaces[i].vertices) << i;
    EXPECT_NE(piecesOf(other).surfaces.front().vertices, at_once.surfaces.front().vertices) << "one seed";
}

INSTANTIATE_TEST_SUITE_P(Scenes, SweptScene,
                         testing::Combine(testing::Values("coffee_cup", "coffee_plate", "glass_wall", "plane",
                                                          "plaster_wall", "wood_wall"),
                                          testing::Range(1, seeds + 1, seeds_a_test)),
                         [](const auto& tested) {
                             return std::string(std::get<0>(tested.param)) + "_from_" +
                                    std::to_string(std::get<1>(tested.param));
                         });

}  // namespace
