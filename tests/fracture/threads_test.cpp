// What may be done with an asset from several threads at once. Worth running with -fsanitize=thread, too.

#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <atomic>
#include <future>
#include <thread>

#include "fracture/default_fracture.h"
#include "fracture/struck_plate.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

BreakableAsset plate(const Settings& settings = {}) {
    return plateAsset(Material::plaster(), settings);
}

Settings coarse() {
    Settings settings;
    settings.sampling.spacing_m = 0.02;
    return settings;
}

std::vector<double> volumesOf(const BlowOutcome& outcome) {
    std::vector<double> volumes;
    for (const Fragment& fragment : outcome.fragments) volumes.push_back(fragment.solid->moments().volume);
    return volumes;
}

TEST(Threads, AnAssetIsPreparedOnOneWhileOthersAskForItAndStrikeOthers) {
    const BreakableAsset asset = plate(coarse()), other = plate(coarse());
    std::thread worker([copy = asset] { EXPECT_TRUE(copy.prepare().ok()); });
    while (!asset.prepared()) {
        EXPECT_FALSE(canBreak(*asset.solid(), blowInTheMiddle(0.1, 0.01)));
        EXPECT_GT(asset.mass(), 0);
        EXPECT_EQ(strike(*other.solid(), blowInTheMiddle(0.1, 0.1), 1).outcome, Outcome::held);
    }
    worker.join();
    const BlowOutcome here = strike(*asset.solid(), blowInTheMiddle(1, 10), 1);
    EXPECT_EQ(here.outcome, Outcome::broke) << here.message;
    EXPECT_EQ(here.ms.factor, 0) << "made on the worker";
    const BreakableAsset prepared_here = plate(coarse());
    ASSERT_TRUE(prepared_here.prepare().ok());
    EXPECT_EQ(volumesOf(here), volumesOf(strike(*prepared_here.solid(), blowInTheMiddle(1, 10), 1)));
}

TEST(Threads, ABlowWaitsForTheFactorThatAnotherThreadMakes) {
    const BreakableAsset asset = plate(coarse());
    std::vector<double> on_worker;
    std::thread worker([&] { on_worker = volumesOf(strike(*asset.solid(), blowInTheMiddle(1, 10), 1)); });
    const BlowOutcome here = strike(*asset.solid(), blowInTheMiddle(1, 10), 1);
    worker.join();
    EXPECT_EQ(here.outcome, Outcome::broke) << here.message;
    EXPECT_EQ(volumesOf(here), on_worker);
}

// The strength field is where a test can stop a blow: it goes on once all else was asked for.
TEST(Threads, ABlowOnOneThreadHoldsUpNothingButItsOwnSolidsStrengths) {
    std::promise<void> in_the_field, asked;
    std::shared_future<void> go_on(asked.get_future());
    std::atomic<bool> entered{false}, waited_in_vain{false};
    Settings settings = coarse();
    settings.strength.field = [&](const Vec3&) {
        if (!entered.exchange(true)) {
            in_the_field.set_value();
            waited_in_vain = go_on.wait_for(std::chrono::seconds(60)) != std::future_status::ready;
        }
        return 1.0;
    };
    const BreakableAsset asset = plate(settings), other = plate(coarse());
    std::thread worker([copy = asset] {
        EXPECT_EQ(strike(*copy.solid(), blowInTheMiddle(1, 10), 1).outcome, Outcome::broke);
    });
    in_the_field.get_future().wait();
    EXPECT_TRUE(asset.solid()->hasSolver());
    EXPECT_FALSE(asset.prepared()) << "a blow has factored it, and nobody asked for more";
    EXPECT_TRUE(asset.prepare().ok());
    EXPECT_TRUE(asset.prepared());
    EXPECT_GT(asset.particleCount(), 0);
    EXPECT_GT(asset.solid()->sampleMilliseconds(), 0);
    EXPECT_TRUE(canBreak(*asset.solid(), blowInTheMiddle(1, 10)));
    EXPECT_EQ(strike(*other.solid(), blowInTheMiddle(1, 10), 1).outcome, Outcome::broke);
    asked.set_value();
    worker.join();
    EXPECT_FALSE(waited_in_vain);
}

}  // namespace
