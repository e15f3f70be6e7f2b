#include "fracture/coarse_look.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fracture/blow_stress.h"
#include "fracture/crack_energy.h"
#include "fracture/decided.h"
#include "fracture/default_fracture.h"
#include "fracture/pipeline.h"
#include "fracture/struck_plate.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

/// Two prongs along x, one over the other, with a gap that a cell of the coarse grid bridges; the upper one
/// is struck near its tip.
TriangleMesh prongs() {
    Mat3 lying;
    lying << 0, 0, 1, 0, -1, 0, 1, 0, 0;
    return shapes::moved(shapes::uShape(0.004, 0.005, 0.1, 0.015), lying, Vec3(-0.09, 0.0075, 0.002));
}

/// Pieces of a plate of glass: a shard, a rod, a chunk, and prongs.
std::vector<TriangleMesh> pieces() {
    return {shapes::box(Vec3(-0.08, -0.05, -0.015), Vec3(0.08, 0.05, 0.015)),
            shapes::box(Vec3(-0.1, -0.012, -0.015), Vec3(0.1, 0.012, 0.015)),
            shapes::box(Vec3(-0.03, -0.03, -0.015), Vec3(0.03, 0.03, 0.015)), prongs()};
}

std::shared_ptr<const BreakableSolid> fragment(const TriangleMesh& surface) {
    return plateAsset(Material::glass()).solid()->makeFragment(surface);
}

double fullEnergy(const BreakableSolid& solid, const Blow& blow) {
    StageTimes ms;
    const auto sampling = solid.discretisation();
    const StrikeContext struck{solid, *sampling.value(), solid.settings().fracture, 1};
    return blowStress(struck, blow, ms).value().strain_energy_j;
}

double coarseEnergy(const BreakableSolid& solid, const Blow& blow) {
    StageTimes ms;
    const Result<CoarseModel> model = solid.makeCoarseModel();
    const StressOfLoads solve = [&](const std::vector<PointForce>& loads, const ContactField&,
                                    double) -> Result<UnitResponse> {
        return UnitResponse{model.value().strainEnergy(loads).value()};
    };
    return blowForces(solid, solid.settings().fracture.contact, blow, solve, {model.value().spacing(), false},
                      ms)
        .value()
        .strain_energy_j;
}

TEST(CoarseLook, ItsEnergyIsNearlyTheFullSolves) {
    for (const TriangleMesh& surface : pieces()) {
        const auto solid = fragment(surface);
        const Result<CoarseModel> model = solid->makeCoarseModel();
        ASSERT_TRUE(model.ok()) << model.error();
        const double ratio =
            coarseEnergy(*solid, blowInTheMiddle(0.1, 3)) / fullEnergy(*solid, blowInTheMiddle(0.1, 3));
        EXPECT_GT(ratio, 1 / 1.25) << "the margin of the look";
        EXPECT_LT(ratio, 1.25) << "the dent is added in closed form";
    }
}

TEST(CoarseLook, TellsProngsApartThatLieInOneCell) {
    const auto solid = fragment(prongs());
    const Blow blow = blowInTheMiddle(0.1, 3);
    EXPECT_GT(coarseEnergy(*solid, blow) / fullEnergy(*solid, blow), 0.9);
}

TEST(CoarseLook, WhatItSaysIsHeldIsHeldByAFullSolve) {
    int coarse = 0, full = 0;
    for (const TriangleMesh& surface : pieces())
        for (double speed = 0.5; speed < 30; speed *= 1.2) {
            const auto solid = fragment(surface);
            const FractureSettings& fracture = solid->settings().fracture;
            const Blow blow = blowInTheMiddle(0.02, speed);
            const BlowOutcome out = decided(*solid, blow, fracture);
            coarse += out.level == Level::coarse;
            full += out.level == Level::full;
            if (out.level != Level::coarse) continue;
            EXPECT_EQ(out.outcome, Outcome::held);
            EXPECT_EQ(strike(*solid, blow, fracture, 1).outcome, Outcome::held) << speed;
            EXPECT_LT(fullEnergy(*solid, blow), smallestCrackEnergy(*solid, fracture));
            EXPECT_GT(out.peak_force_n, 0);
            EXPECT_GT(out.contact_time_s, 0);
            EXPECT_DOUBLE_EQ(out.impulse_n_s, normalImpulse(blow));
            EXPECT_GT(out.ms.coarse, 0);
            EXPECT_EQ(out.ms.total(), out.ms.gate + out.ms.coarse);
        }
    EXPECT_GT(coarse, 3);
    EXPECT_GT(full, 3);
}

TEST(CoarseLook, ACheckChangesNoLaterDecision) {
    const auto solid = fragment(pieces()[0]);
    FractureSettings fracture = solid->settings().fracture;
    fracture.check_with_full_solve = true;
    int coarse = 0;
    for (const double speed : {0.01, 4.0, 4.0, 4.2}) {  // all held; the gate decides the first
        const BlowOutcome out = decided(*solid, blowInTheMiddle(0.02, speed), fracture);
        coarse += out.level == Level::coarse;
        EXPECT_NE(out.level, Level::full);
        EXPECT_EQ(out.full_solve_outcome, Outcome::held);
    }
    EXPECT_GE(coarse, 2);
    EXPECT_FALSE(solid->isFactored());
}

TEST(CoarseLook, NobodyAsksForItWhereTheStressIsAtHandOrUnwanted) {
    const auto whole = plateAsset(Material::glass()).solid();
    const Blow blow = blowInTheMiddle(0.02, 1);
    StageTimes ms;
    FractureSettings fracture = whole->settings().fracture;
    EXPECT_FALSE(coarseLook(*whole, blow, fracture, ms)) << "no fragment";
    const auto solid = fragment(pieces()[0]);
    EXPECT_TRUE(coarseLook(*solid, blow, fracture, ms));
    fracture.use_coarse_model = false;
    EXPECT_FALSE(coarseLook(*solid, blow, fracture, ms));
    fracture.use_coarse_model = true;
    ASSERT_TRUE(solid->stressSolver().ok());
    EXPECT_FALSE(coarseLook(*solid, blow, fracture, ms)) << "a further blow is cheap in full";
}

}  // namespace
