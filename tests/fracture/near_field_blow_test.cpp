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
    static std::shared_ptr<const BreakableSolid> block(Quality quality,
                                                       const Vec3& size = Vec3(0.2, 0.15, 0.1)) {
        const auto solid = BreakableSolid::make(shapes::slab(size, 3, 3, 3), Material::ceramic(),
                                                Settings::forQuality(quality));
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
        const auto loads = blowStress(struck, blow, ms).value().loads;
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
            blowStress({*solid, *solid->discretisation().value(), solid->settings().fracture, 1}, *blow, ms);
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

/// Every point a face of its own.
SurfaceFaces allPoints(const ReadingPoints& points) {
    SurfaceFaces all;
    all.starts = points.starts;
    for (const ReadingPoint& point : points.points) all.faces.push_back({point.xi, point.area});
    return all;
}

TEST_F(NearFieldBlow, FarFromTheContactsFacesStandForTheirPoints) {
    const auto solid = block(Quality::preview, Vec3(0.4, 0.4, 0.02));
    ASSERT_TRUE(solid && solid->prepare({}) && solid->reducedStress() && solid->stressSolver());
    const ReducedStress& reduced = *solid->reducedStress();
    const ReadingPoints& points = reduced.reading.points();
    EXPECT_LT(3 * reduced.reading.faces().faces.size(), points.points.size());
    StageTimes ms;
    const auto stress = blowStress({*solid, *solid->discretisation().value(), solid->settings().fracture, 1},
                                   strikeAt(Vec3(0.02, 0.01, 0.01), -Vec3::UnitZ()), ms);
    ASSERT_TRUE(stress);
    const auto remainder = [&](const SurfaceFaces& faces) {
        auto forces = contactRemainder(reduced.model.problem(), points, faces, stress.value().contact);
        EXPECT_TRUE(forces) << forces.error();
        return forces ? std::move(forces).value() : Eigen::VectorXd();
    };
    const Eigen::VectorXd by_points = remainder(allPoints(points));
    const Eigen::VectorXd by_faces = remainder(reduced.reading.faces());
    EXPECT_GT((by_faces - by_points).norm(), 0) << "no part is far";
    EXPECT_LT((by_faces - by_points).norm(), 0.01 * by_points.norm());
    ReducedModel::LocalSystem near;
    ASSERT_TRUE(reduced.model.respond(stress.value().loads, near));
    const auto exact = reduced.model.respond(by_points, near), cheap = reduced.model.respond(by_faces, near);
    ASSERT_TRUE(exact && cheap);
    EXPECT_NEAR(cheap.value().strain_energy_j, exact.value().strain_energy_j,
                0.005 * exact.value().strain_energy_j);
}

}  // namespace
}  // namespace sherd
