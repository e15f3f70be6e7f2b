#include <gtest/gtest.h>

#include "core/mlpg/splines/contact_remainder.h"
#include "fracture/blow_damage.h"
#include "support/shapes.h"

namespace sherd {
namespace {

/// Something that slides strikes a block, away from its edges or over one.
Blow strikeAt(const Vec3& point, const Vec3& normal) {
    Blow blow;
    ContactImpulse contact;
    contact.point = point;
    contact.normal = normal;
    contact.impulse = normal;
    contact.approach_m_s = 2;
    contact.slip_m_s = 5 * normal.unitOrthogonal();
    contact.friction = 0.3;
    blow.contacts = {contact};
    blow.partners = {Mobility::ofPoint(0.5)};
    return blow;
}

const Blow on_a_face = strikeAt(Vec3(0.02, 0.01, 0.05), -Vec3::UnitZ());
const Blow over_an_edge = strikeAt(Vec3(0.02, 0.06, 0.05), -Vec3::UnitZ());

class NearFieldBlow : public ::testing::Test {
  protected:
    static std::shared_ptr<const BreakableSolid> block(Quality quality) {
        const auto solid = BreakableSolid::make(shapes::slab(Vec3(0.2, 0.15, 0.1), 3, 3, 3),
                                                Material::ceramic(), Settings::forQuality(quality));
        return solid ? solid.value() : nullptr;
    }

    /// The largest stress, Pa/N.
    static double peak(const BreakableSolid& solid, const Blow& blow, Level level) {
        const Discretisation& sampling = *solid.discretisation().value();
        FractureSettings fracture = solid.settings().fracture;
        fracture.use_reduced_model = level == Level::reduced;
        Material strong = solid.material();
        strong.tensile_strength_pa = 1e30;
        strong.strength_scatter = 0;
        const BodyStrength strength(strong, solid.strength().scatterLength(), {});
        StageTimes ms;
        const BlowDamage found = blowDamage({solid, sampling, fracture, 1}, blow, strength, ms);
        EXPECT_EQ(found.level, level);
        EXPECT_FALSE(found.forces.contact.near.empty());
        return found.damage.largest_stress_pa / found.forces.pulse.peak_force_n;
    }

    static double peakOfTheGrid(const BreakableSolid& solid, const Blow& blow) {
        const Discretisation& sampling = *solid.discretisation().value();
        const StrikeContext struck{solid, sampling, solid.settings().fracture, 1};
        const StressSolver& solver = *solid.stressSolver().value();
        StageTimes ms;
        const auto loads = blowStress(struck, solver, blow, ms).value().loads;
        const StressField stress = unitStress(struck, solver, loads, ms).value();
        double largest = 0;
        for (const auto* all : {&stress.particles, &stress.surface})
            for (const SymmetricTensor& s : *all) largest = std::max(largest, largestPrincipal(s));
        return largest;
    }
};

TEST_F(NearFieldBlow, TheLargestStressHardlyDependsOnTheGrid) {
    const auto coarse = block(Quality::preview), fine = block(Quality::game);
    ASSERT_TRUE(coarse && fine);
    const double on_coarse = peak(*coarse, on_a_face, Level::full);
    const double on_fine = peak(*fine, on_a_face, Level::full);
    EXPECT_NEAR(on_coarse, on_fine, 0.06 * on_fine);
    EXPECT_LT(peakOfTheGrid(*coarse, on_a_face), 0.8 * on_fine) << "the grid alone finds less";
}

TEST_F(NearFieldBlow, TheReducedModelFindsTheSameStress) {
    const auto solid = block(Quality::preview);
    ASSERT_TRUE(solid && solid->prepare({}) && solid->reducedStress() && solid->stressSolver());
    for (const Blow* blow : {&on_a_face, &over_an_edge}) {
        const double full = peak(*solid, *blow, Level::full);
        EXPECT_NEAR(peak(*solid, *blow, Level::reduced), full, 0.02 * full);
    }
}

TEST_F(NearFieldBlow, WhatIsLeftForTheGridHasTheForceOfTheContact) {
    const auto solid = block(Quality::preview);
    ASSERT_TRUE(solid && solid->prepare({}) && solid->reducedStress() && solid->stressSolver());
    const ReducedStress& reduced = *solid->reducedStress();
    for (const Blow* blow : {&on_a_face, &over_an_edge}) {
        StageTimes ms;
        const auto stress =
            blowStress({*solid, *solid->discretisation().value(), solid->settings().fracture, 1},
                       *solid->stressSolver().value(), *blow, ms);
        ASSERT_TRUE(stress);
        const auto forces = contactRemainder(reduced.model.problem(), reduced.reading.points(),
                                             reduced.reading.faces(), stress.value().contact);
        ASSERT_TRUE(forces);
        Vec3 left = Vec3::Zero(), strike = Vec3::Zero();
        for (long i = 0; i < forces.value().size(); i += 3) left += forces.value().segment<3>(i);
        for (const PointForce& load : stress.value().strike) strike += load.force;
        EXPECT_LT((left - strike).norm(), 0.05 * strike.norm());
    }
}

}  // namespace
}  // namespace sherd
