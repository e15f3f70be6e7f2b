// No blow stores more energy in a body than it brings: random blows on bodies of all kinds.
#include <gtest/gtest.h>

#include <cstdio>

#include "fracture/blow_damage.h"
#include "fracture/blow_stress.h"
#include "fracture/random_blows.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

void strikeAtRandom(int count) {
    int supported = 0, answered = 0;
    double most = 0;
    for (const Shape& shape : tenShapes()) {
        const auto made = BreakableSolid::make(shape.mesh, shape.material, coarselySampled());
        ASSERT_TRUE(made.ok()) << shape.name << ": " << made.error();
        const BreakableSolid& solid = *made.value();
        const auto solver = solid.stressSolver();
        ASSERT_TRUE(solver.ok()) << shape.name << ": " << solver.error();
        const StrikeContext struck{solid, *solid.discretisation().value(), solid.settings().fracture, 1};
        RandomBlows blows(shape.mesh, 7);
        for (int i = 0; i < count / 10; ++i) {
            const Blow blow = blows.next();
            StageTimes ms;
            const auto stress = blowStress(struck, blow, ms);
            ASSERT_TRUE(stress.ok()) << shape.name << ", blow " << i << ": " << stress.error();
            const double brought = blowEnergy(blow, solid.mass(), isHeld(solid, blow));
            const double stored = stress.value().strain_energy_j;
            ASSERT_GT(stored, 0) << shape.name << ", blow " << i;
            ASSERT_LE(stored, brought) << shape.name << ", blow " << i;
            const Strike strike = strikeOf(struckBody(solid, blow), blow, solid.settings().fracture.contact);
            ASSERT_LE(stored, broughtEnergy(solid, blow, strike) * (1 + 1e-9))
                << shape.name << ", blow " << i;
            supported += blow.isSupported();
            answered += stress.value().loads.size() > stress.value().strike.size();
            most = std::max(most, stored / brought);
        }
    }
    std::printf("%d of %d supported, %d of these answer; at most %.1f %% of the energy is stored\n",
                supported, count, answered, 100 * most);
    EXPECT_GT(supported, count / 4);
    EXPECT_GT(answered, supported / 10);
    EXPECT_GT(most, 0.5) << "slender bodies store most of it";
}

TEST(StoredEnergy, IsNoMoreThanABlowBrings) {
    strikeAtRandom(300);
}

// Label `long`, see tests/CMakeLists.txt.
TEST(StoredEnergy, DISABLED_IsNoMoreThanTenThousandBlowsBring) {
    strikeAtRandom(10000);
}

// Where a body rings on, too.
TEST(StoredEnergy, OfABodyThatRingsIsNoMoreThanABlowBrings) {
    int rang = 0;
    for (const Vec3& size : {Vec3(0.6, 0.03, 0.024), Vec3(0.3, 0.24, 0.008), Vec3(0.5, 0.02, 0.5)}) {
        const TriangleMesh mesh = shapes::slab(size, 12, 8, 8);
        const auto made = BreakableSolid::make(mesh, Material::glass(), coarselySampled());
        ASSERT_TRUE(made.ok()) << made.error();
        const BreakableSolid& solid = *made.value();
        ASSERT_TRUE(solid.prepare({}).ok());
        const StrikeContext struck{solid, *solid.discretisation().value(), solid.settings().fracture, 1};
        const BodyStrength strength(solid.material(), solid.strength().scatterLength(), {});
        RandomBlows blows(mesh, 3);
        for (int i = 0; i < 100; ++i) {
            const Blow blow = blows.next();
            StageTimes ms;
            BlowDamage found = blowDamage(struck, blow, strength, ms);
            const bool may_ring = found.add_ringing != nullptr;
            if (may_ring) found.add_ringing(found);
            rang += may_ring || !found.forces.ringing.empty();
            const Strike strike = strikeOf(struckBody(solid, blow), blow, solid.settings().fracture.contact);
            ASSERT_LE(found.forces.strain_energy_j, broughtEnergy(solid, blow, strike) * (1 + 1e-9))
                << size.transpose() << ", blow " << i;
        }
    }
    EXPECT_GT(rang, 100);
}

// A plaster rod of 1 m and 1 cm across, struck in its middle at 0.3 m/s: a contact of more than a hundredth
// of a second.
TEST(StoredEnergy, OfASlenderRodIsNoMoreThanASlowBlowBrings) {
    const auto made =
        BreakableSolid::make(shapes::slab(Vec3(1, 0.01, 0.01), 20, 1, 1), Material::plaster(), Settings{});
    ASSERT_TRUE(made.ok()) << made.error();
    const BreakableSolid& rod = *made.value();
    ContactImpulse contact;
    contact.point = Vec3(0, 0, 0.005);
    contact.normal = -Vec3::UnitZ();
    contact.impulse = -Vec3::UnitZ();
    contact.approach_m_s = 0.3;
    contact.partner_radius_m = 0.02;
    const Blow blow{{contact}, {Mobility::ofPoint(0.25)}};
    StageTimes ms;
    const auto stress =
        blowStress({rod, *rod.discretisation().value(), rod.settings().fracture, 1}, blow, ms);
    ASSERT_TRUE(stress.ok()) << stress.error();
    const double brought = 0.5 / (1 / 0.25 + 1 / rod.mass()) * 0.3 * 0.3;
    EXPECT_LE(stress.value().strain_energy_j, brought);
    EXPECT_GT(stress.value().strain_energy_j, 0.9 * brought);
    EXPECT_GT(stress.value().pulse.duration_s, 1e-2);
}

}  // namespace
