#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "core/numerics/mesh_measures.h"
#include "fracture/blow_stress.h"
#include "fracture/default_fracture.h"
#include "fracture/random_blows.h"
#include "fracture/struck_plate.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

std::shared_ptr<const BreakableSolid> plate(const Material& material, const Settings& settings = {}) {
    return plateAsset(material, settings).solid();
}

TEST(Strike, HardBlowBreaksAPlateAndLosesNothing) {
    const auto solid = plate(Material::plaster());
    const BlowOutcome out = strike(*solid, blowInTheMiddle(1, 10), 1);
    ASSERT_EQ(out.outcome, Outcome::broke) << out.message;
    EXPECT_GE(out.fragments.size(), 4u);
    EXPECT_LT(out.volume_error_rel, 1e-9);
    EXPECT_LT(out.mass_error_rel, 1e-9);
    EXPECT_LT(out.residual_rel, 1e-10);
    EXPECT_GT(out.largest_stress_pa, solid->material().tensile_strength_pa);
    double crack_faces = 0;
    for (const Fragment& f : out.fragments) {
        const TriangleMesh& mesh = f.solid->surface();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (mesh.kinds[t] == SurfaceKind::crack) crack_faces += areaVector(cornersOf(mesh, t)).norm();
    }
    EXPECT_GT(out.crack_area_m2, 0.5 * 0.03 * 0.4) << "from the middle to the rim";
    EXPECT_NEAR(out.crack_area_m2, crack_faces / 2, 1e-9 * crack_faces);
    EXPECT_EQ(strike(*solid, blowInTheMiddle(0.001, 0.1), 1).crack_area_m2, 0);
    Vec3 moment = Vec3::Zero();
    for (const Fragment& f : out.fragments) moment += f.solid->mass() * f.solid->moments().centroid;
    EXPECT_LT((moment / solid->mass() - solid->moments().centroid).norm(), 1e-9);
}

TEST(Strike, StressGrowsWithTheSpeedOfTheBlow) {
    const auto solid = plate(Material::plaster());
    double last = 0;
    for (const double speed : {0.01, 0.1, 1.0}) {
        const BlowOutcome out = strike(*solid, blowInTheMiddle(0.1, speed), 1);
        EXPECT_GT(out.largest_stress_pa, 3 * last);
        last = out.largest_stress_pa;
    }
}

TEST(Strike, WarningsOfTheStressReachTheOutcome) {
    EXPECT_TRUE(strike(*plate(Material::plaster()), blowInTheMiddle(1, 10), 1).warnings.empty());
    Settings settings;
    settings.stress.trial_function = TrialFunction::mls;
    settings.sampling.spacing_m = 0.025;
    Material soft = Material::plaster();
    soft.poisson_ratio = 0.48;
    const BlowOutcome out = strike(*plate(soft, settings), blowInTheMiddle(1, 10), 1);
    ASSERT_FALSE(out.warnings.empty());
    EXPECT_NE(out.warnings.back().find("Poisson"), std::string::npos) << out.warnings.back();
    EXPECT_TRUE(out.message.empty()) << out.message;
}

double crackArea(const BlowOutcome& out) {
    double twice_m2 = 0;  // both sides
    for (const Fragment& fragment : out.fragments) {
        const TriangleMesh& mesh = fragment.solid->surface();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            if (mesh.kinds[t] == SurfaceKind::crack)
                twice_m2 +=
                    0.5 *
                    (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
        }
    }
    return twice_m2 / 2;
}

// Of bodies so weak that nothing but the energy holds them together.
TEST(Strike, StressThatNoElasticBodyHasIsToldOf) {
    const auto solid = plate(Material::plaster());
    EXPECT_TRUE(strike(*solid, blowInTheMiddle(1, 10), 1).warnings.empty());
    const BlowOutcome out = strike(*solid, blowInTheMiddle(1e6, 1e4), 1);
    EXPECT_GT(out.largest_stress_pa, solid->material().youngs_modulus_pa);
    ASSERT_EQ(out.warnings.size(), 1u);
    EXPECT_EQ(out.warnings[0].find("The largest stress is above Young's modulus"), 0u) << out.warnings[0];
}

TEST(Strike, CracksCostNoMoreThanTheBlowPaysFor) {
    const double share = 4 * FractureSettings().energy_into_cracks;
    int broke = 0, held = 0;
    for (const Shape& shape : tenShapes()) {
        Material weak = shape.material;
        weak.tensile_strength_pa /= 100;
        const auto made = BreakableSolid::make(shape.mesh, weak, coarselySampled());
        ASSERT_TRUE(made.ok()) << made.error();
        const BreakableSolid& solid = *made.value();
        RandomBlows blows(shape.mesh, 21);
        for (int i = 0; i < 20; ++i) {
            const Blow blow = blows.next();
            const BlowOutcome out = strike(solid, blow, 1);
            (out.outcome == Outcome::broke ? broke : held) += 1;
            const double brought_j = blowEnergy(blow, solid.mass(), isHeld(solid, blow));
            EXPECT_LE(weak.fracture_energy_j_m2 * crackArea(out), 1.1 * share * brought_j)
                << shape.name << ", blow " << i;
        }
    }
    EXPECT_GT(broke, 30);
    EXPECT_GT(held, 20);
}

TEST(Strike, ABodyThatNothingCanBreakHolds) {
    Material hard = Material::plaster();
    hard.tensile_strength_pa = 1e15;
    const BlowOutcome out = strike(*plate(hard), blowInTheMiddle(10, 30), 1);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_TRUE(out.fragments.empty());
    EXPECT_EQ(out.damaged_particles, 0);
}

TEST(Strike, TheBoundNeverHidesABreak) {
    // Wherever the stages end in a break, the bound must have let the blow through.
    Settings settings;
    for (const double spacing : {0.01, 0.02}) {
        settings.sampling.spacing_m = spacing;
        const auto solid = plate(Material::plaster(), settings);
        for (double speed = 0.001; speed < 10; speed *= 1.7) {
            const Blow blow = blowInTheMiddle(0.05, speed);
            const bool broke = strike(*solid, blow, 1).outcome == Outcome::broke;
            EXPECT_TRUE(!broke || canBreak(*solid, blow)) << speed;
        }
        EXPECT_FALSE(canBreak(*solid, blowInTheMiddle(0.05, 0.001)));
        EXPECT_TRUE(canBreak(*solid, blowInTheMiddle(1, 10)));
    }
}

/// Plaster that is crushed at three times its tensile strength, and whose cracks cost little.
Material crushable(const std::string& failure_criterion) {
    Material material = Material::plaster();
    material.strength_scatter = 0;
    material.fracture_energy_j_m2 = 0.05;
    material.compressive_strength_pa = 3 * material.tensile_strength_pa;
    material.failure_criterion = failure_criterion;
    return material;
}

/// A cube of 0.1 m, struck from above and from below at once by 0.5 kg each: neither lets it give way to the
/// other.
BlowOutcome squeezeCube(const Material& material, double speed, const Settings& settings,
                        bool* passes = nullptr) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3::Constant(-0.05), Vec3::Constant(0.05)),
                                                material, settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    Blow blow = blowInTheMiddle(0.5, speed);
    blow.contacts.push_back(blow.contacts[0]);
    blow.partners.push_back(blow.partners[0]);
    for (const int side : {0, 1}) {
        ContactImpulse& contact = blow.contacts[side];
        contact.partner = side;
        contact.normal = Vec3::UnitZ() * (side ? 1 : -1);
        contact.point = -0.05 * contact.normal;
        contact.impulse = 0.5 * speed * contact.normal;
        contact.partner_radius_m = 0.1;
    }
    if (passes) *passes = canBreak(*asset.value().solid(), blow);
    return strike(*asset.value().solid(), blow, 1);
}

// In the middle of a squeezed cube is tension across the load and some three times as much compression along
// it (the Brazilian test): neither reaches its strength where both together do.
TEST(Strike, TensionAcrossCompressionDamagesByMohrCoulombOnly) {
    Settings settings;
    settings.sampling.spacing_m = 0.0125;
    settings.strength.field = [](const Vec3& x) { return std::abs(x.z()) < 0.026 ? 1.0 : 100.0; };
    const Material rankine = crushable("largest_principal_stress"), coulomb = crushable("mohr_coulomb");
    // The strong ends hold the cube together, whichever way the cracks run between them.
    const BlowOutcome held = squeezeCube(rankine, 4.9, settings);
    EXPECT_EQ(held.outcome, Outcome::held);
    const BlowOutcome broken = squeezeCube(coulomb, 4.9, settings);
    EXPECT_GE(broken.damaged_particles, 5 * held.damaged_particles) << broken.message;
    EXPECT_GT(broken.damaged_particles, 0);
    // The largest tension of all is at the rims of the contacts, where the strength is a hundredfold.
    EXPECT_LT(broken.largest_stress_pa, coulomb.tensile_strength_pa * 2);
}

// Right under a contact there is compression from all sides, which crushes by the largest compression, and
// not by Mohr-Coulomb, where side pressure strengthens.
TEST(Strike, CompressionFromAllSidesCrushesByTheLargestCompressionOnly) {
    Settings settings;
    settings.sampling.spacing_m = 0.0125;
    settings.fracture.contact.largest_patch = 1;
    Material rankine = crushable("largest_principal_stress"), coulomb = crushable("mohr_coulomb");
    rankine.compressive_strength_pa = coulomb.compressive_strength_pa = 2 * rankine.tensile_strength_pa;
    const BlowOutcome broken = squeezeCube(rankine, 1.9, settings);
    EXPECT_EQ(broken.outcome, Outcome::broke) << broken.message;
    EXPECT_LT(broken.largest_stress_pa, rankine.tensile_strength_pa);
    EXPECT_EQ(squeezeCube(coulomb, 1.9, settings).outcome, Outcome::held);
}

// The same with cracks that cost nothing, so that the bound is that of the failure criterion.
TEST(Strike, TheBoundOfAFailureCriterionNeverHidesABreak) {
    Settings settings;
    settings.sampling.spacing_m = 0.025;
    for (const FailureCriterion* criterion : failureCriteria()) {
        Material material = crushable(criterion->name);
        material.fracture_energy_j_m2 = 1e-12;
        int skipped = 0, broke = 0;
        for (double speed = 0.001; speed < 10; speed *= 2) {
            bool passes = false;
            const BlowOutcome out = squeezeCube(material, speed, settings, &passes);
            skipped += !passes;
            broke += out.outcome == Outcome::broke;
            EXPECT_TRUE(passes || out.damaged_particles == 0) << criterion->name << " " << speed;
        }
        EXPECT_GT(skipped, 0);
        EXPECT_GT(broke, 0);
    }
}

TEST(Strike, PressingContactsCannotBreak) {
    const auto solid = plate(Material::plaster());
    Blow blow = blowInTheMiddle(1, 10);
    blow.contacts[0].approach_m_s = 0;
    EXPECT_FALSE(canBreak(*solid, blow));
}

TEST(Strike, AFurtherBlowAssemblesAndFactorsNothing) {
    const auto solid = plate(Material::glass());
    const BlowOutcome first = strike(*solid, blowInTheMiddle(0.01, 0.1), 1);
    const BlowOutcome further = strike(*solid, blowInTheMiddle(0.01, 0.1), 1);
    EXPECT_GT(first.ms.assemble, 0);
    EXPECT_GT(first.ms.factor, 0);
    EXPECT_EQ(further.ms.assemble, 0);
    EXPECT_EQ(further.ms.factor, 0);
    EXPECT_EQ(further.largest_stress_pa, first.largest_stress_pa);
}

TEST(Strike, SameSeedSameFragmentsOtherSeedOthers) {
    const auto volumes = [](std::uint64_t seed) {
        Settings settings;
        settings.strength.seed = seed;
        std::vector<double> v;
        for (const Fragment& f :
             strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), seed).fragments)
            v.push_back(f.solid->moments().volume);
        return v;
    };
    EXPECT_EQ(volumes(1), volumes(1));
    EXPECT_NE(volumes(1), volumes(2));
}

TEST(Strike, OneAssetBreaksAsTheSettingsOfABodySay) {
    const auto solid = plate(Material::plaster());
    FractureSettings few = solid->settings().fracture, many = few;
    few.fragment_count = 3;
    many.fragment_count = 30;
    many.smallest_fragment_m3 = 1e-4;
    many.debris = Debris::dropped;
    const BlowOutcome coarse = strike(*solid, blowInTheMiddle(1, 10), few, 1);
    const BlowOutcome fine = strike(*solid, blowInTheMiddle(1, 10), many, 1);
    EXPECT_LT(coarse.fragments.size() + 5, fine.fragments.size());
    const auto dropped = [](const BlowOutcome& out) {
        return std::count_if(out.fragments.begin(), out.fragments.end(),
                             [](const Fragment& f) { return f.dropped; });
    };
    EXPECT_EQ(dropped(coarse), 0);
    EXPECT_GT(dropped(fine), 0);
    few.contact.largest_patch = few.contact.smallest_patch = 0.9;
    EXPECT_NE(strike(*solid, blowInTheMiddle(1, 10), few, 1).largest_stress_pa, coarse.largest_stress_pa);
    few.energy_into_cracks = 1e-9;
    EXPECT_FALSE(canBreak(*solid, blowInTheMiddle(1, 10), few));
}

TEST(Strike, FragmentsBreakAgain) {
    Settings settings;
    settings.fracture.fragment_count = 4;
    const BlowOutcome out = strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
    ASSERT_EQ(out.outcome, Outcome::broke) << out.message;
    const Fragment* largest = &out.fragments.front();
    for (const Fragment& f : out.fragments)
        if (f.solid->mass() > largest->solid->mass()) largest = &f;
    Blow blow = blowInTheMiddle(1, 20);
    blow.contacts[0].point = largest->solid->moments().centroid + Vec3(0, 0, 0.02);
    const BlowOutcome again = strike(*largest->solid, blow, 2);
    EXPECT_EQ(again.outcome, Outcome::broke) << again.message;
    EXPECT_LT(again.volume_error_rel, 1e-9);
}

TEST(Strike, WithoutContactsNothingHappens) {
    const BlowOutcome out = strike(*plate(Material::plaster()), {}, 1);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_EQ(out.damaged_particles, 0);
}

TEST(Strike, CracksStopWhereTheStrengthFieldIsHigh) {
    Settings settings;
    const auto pieces_on_the_left = [&] {
        const auto solid = plate(Material::plaster(), settings);
        const BlowOutcome out = strike(*solid, blowInTheMiddle(0.5, 6), 1);
        EXPECT_EQ(out.outcome, Outcome::broke) << out.message;
        EXPECT_GE(out.fragments.size(), 10u);
        return std::count_if(out.fragments.begin(), out.fragments.end(), [&](const Fragment& f) {
            return f.solid->moments().centroid.x() < -0.5 * settings.sampling.spacing_m;
        });
    };
    settings.sampling.spacing_m = 0.01;
    EXPECT_GE(pieces_on_the_left(), 4);
    settings.strength.field = [](const Vec3& x) { return x.x() > 0 ? 1.0 : 1e4; };
    EXPECT_EQ(pieces_on_the_left(), 1);
}

// The blow pays for a crack, but not for a particle at a hundred times the strength.
TEST(Strike, AWeakBlowSamplesNoSolidWithAStrengthField) {
    Settings settings;
    settings.strength.field = [](const Vec3& x) { return x.x() > 0 ? 100.0 : 200.0; };
    Material strong = Material::plaster();
    strong.tensile_strength_pa = 1e7;
    const Blow blow = blowInTheMiddle(1, 0.5);
    for (const double minimum : {0.0, 1.0, 100.0}) {
        settings.strength.field_minimum = minimum;
        const auto solid = plate(strong, settings);
        EXPECT_EQ(canBreak(*solid, blow), minimum < 100) << minimum;
        EXPECT_TRUE(canBreak(*solid, blowInTheMiddle(1000, 100)));
        EXPECT_EQ(solid->sampleMilliseconds(), 0) << "sampled to answer";
        EXPECT_EQ(strike(*solid, blow, 1).outcome, Outcome::held) << "nothing was hidden";
    }
    settings.strength.field_minimum = 150;
    const BlowOutcome wrong = strike(*plate(strong, settings), blow, 1);
    EXPECT_EQ(wrong.outcome, Outcome::failed);
    EXPECT_NE(wrong.message.find("nowhere below 150"), std::string::npos) << wrong.message;
}

TEST(Strike, AStrengthFieldThatIsNotPositiveIsNamedAndTheBodyHolds) {
    Settings settings;
    settings.strength.field = [](const Vec3& x) { return x.x(); };
    const auto solid = plate(Material::plaster(), settings);
    EXPECT_TRUE(canBreak(*solid, blowInTheMiddle(1, 10)));
    const BlowOutcome out = strike(*solid, blowInTheMiddle(1, 10), 1);
    EXPECT_EQ(out.outcome, Outcome::failed);
    EXPECT_NE(out.message.find("the strength field is -"), std::string::npos) << out.message;
}

TEST(Strike, FunctionsOfTheAppMayThrowAnything) {
    const Blow blow = blowInTheMiddle(1, 10);
    const std::function<double(const Vec3&)> fields[] = {
        [](const Vec3&) -> double { throw std::runtime_error("not painted here"); },
        [](const Vec3&) -> double { throw 3; },
        [](const Vec3&) { return std::numeric_limits<double>::infinity(); },
    };
    for (const auto& field : fields) {
        Settings settings;
        settings.strength.field = field;
        const auto solid = plate(Material::plaster(), settings);
        for (int time = 0; time < 2; ++time) {  // what is wrong is said again at the next blow
            EXPECT_TRUE(canBreak(*solid, blow));
            const BlowOutcome out = strike(*solid, blow, 1);
            EXPECT_EQ(out.outcome, Outcome::failed);
            EXPECT_FALSE(out.message.empty());
        }
    }
    Settings settings;
    settings.fracture.guide.kind = GuideField::Kind::custom;
    settings.fracture.guide.custom = [](const Vec3&, const Vec3&) -> Vec3 { throw 3; };
    const BlowOutcome out = strike(*plate(Material::plaster(), settings), blow, 1);
    EXPECT_EQ(out.outcome, Outcome::failed);
    EXPECT_NE(out.message.find("guide field"), std::string::npos);
    settings.fracture.guide.custom = [](const Vec3&, const Vec3&) -> Vec3 { return Vec3(NAN, 0, 0); };
    const BlowOutcome not_finite = strike(*plate(Material::plaster(), settings), blow, 1);
    EXPECT_EQ(not_finite.outcome, Outcome::failed);
    EXPECT_NE(not_finite.message.find("guide field is (nan"), std::string::npos) << not_finite.message;
}

TEST(Strike, FurtherWavesOnlyAddDamage) {
    Settings settings;
    settings.sampling.spacing_m = 0.015;
    settings.fracture.largest_fragment_count = 1000;
    Material material = Material::plaster();
    material.tensile_strength_pa = 3.5e6;
    std::vector<int> damaged;
    for (const int waves : {1, 2, 4, 20}) {
        settings.fracture.damage_waves = waves;
        damaged.push_back(strike(*plate(material, settings), blowInTheMiddle(0.2, 3), 1).damaged_particles);
    }
    RecordProperty("damaged particles after 1, 2, 4, 20 waves", testing::PrintToString(damaged));
    EXPECT_GT(damaged[0], 0);
    EXPECT_GT(damaged[1], damaged[0]);
    EXPECT_GE(damaged[2], damaged[1]);
    EXPECT_GE(damaged[3], damaged[2]);
}

TEST(Strike, DebrisIsKeptMergedOrDropped) {
    Settings settings;
    settings.fracture.fragment_count = settings.fracture.largest_fragment_count = 30;
    settings.fracture.smallest_fragment_m3 = 1e-4;  // of 4.8e-3
    const auto struck = [&](Debris debris) {
        settings.fracture.debris = debris;
        return strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
    };
    const auto small = [&](const BlowOutcome& out) {
        int count = 0;
        for (const Fragment& f : out.fragments) count += f.solid->moments().volume < 0.9e-4;
        return count;
    };
    const BlowOutcome kept = struck(Debris::unbreakable), merged = struck(Debris::merged),
                      dropped = struck(Debris::dropped);
    ASSERT_GT(small(kept), 3);
    // Merging goes by particles, and the cut is smooth: a piece may end up a little smaller than its
    // particles.
    EXPECT_EQ(small(merged), 0);
    EXPECT_LT(merged.fragments.size(), kept.fragments.size());
    ASSERT_EQ(dropped.fragments.size(), kept.fragments.size());
    for (const Fragment& f : dropped.fragments) EXPECT_EQ(f.dropped, f.solid->moments().volume < 1e-4);
    for (const BlowOutcome* out : {&kept, &merged, &dropped}) EXPECT_LT(out->mass_error_rel, 1e-9);
}

TEST(Strike, MergedDebrisStaysMergedAlongAGuideField) {
    for (const auto kind : {GuideField::Kind::constant, GuideField::Kind::radial}) {
        Settings settings;
        settings.sampling.spacing_m = 0.015;
        settings.fracture.guide.kind = kind;
        settings.fracture.guide.direction = Vec3::UnitX();
        settings.fracture.smallest_fragment_m3 = 1e-4;
        settings.fracture.debris = Debris::merged;
        const BlowOutcome out = strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
        ASSERT_EQ(out.outcome, Outcome::broke) << out.message;
        for (const Fragment& f : out.fragments) EXPECT_GT(f.solid->moments().volume, 0.9e-4);
    }
}

TEST(Strike, AtMostTheLargestNumberOfFragments) {
    Settings settings;
    settings.fracture.largest_fragment_count = 5;
    const BlowOutcome out = strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
    ASSERT_EQ(out.outcome, Outcome::broke);
    EXPECT_LE(out.fragments.size(), 5u);
    EXPECT_GE(out.fragments.size(), 2u);
}

TEST(Strike, RoughCracksMakeAboutAsManyPieces) {
    Settings settings;
    const auto pieces = [&](double roughness) {
        settings.fracture.crack_roughness = roughness;
        const BlowOutcome out = strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
        EXPECT_EQ(out.outcome, Outcome::broke) << out.message;
        return out.fragments.size();
    };
    const auto smooth = static_cast<double>(pieces(0));
    EXPECT_GE(smooth, 4);
    // Smooth ones are cut by planes, rough ones between clusters.
    for (const double roughness : {0.1, 0.5})
        EXPECT_NEAR(static_cast<double>(pieces(roughness)), smooth, 0.2 * smooth) << roughness;
}

TEST(Strike, FragmentsThatComeApartInTheCutCountEach) {
    Settings settings;
    settings.sampling.smallest_count = 300;
    settings.fracture.guide.kind = GuideField::Kind::radial;
    settings.fracture.guide.cost_along = 0;  // sectors that are a point at the contact
    const BlowOutcome out = strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
    ASSERT_EQ(out.outcome, Outcome::broke) << out.message;
    EXPECT_LE(static_cast<int>(out.fragments.size()), settings.fracture.largest_fragment_count);
    EXPECT_LT(out.volume_error_rel, 1e-9);
}

TEST(Strike, TwiceTheImpulseNeverDamagesLess) {
    for (const double spacing : {0.01, 0.02}) {
        Settings settings;
        settings.sampling.spacing_m = spacing;
        const auto solid = plate(Material::plaster(), settings);
        for (const bool faster : {false, true}) {  // or heavier
            int last = 0;
            for (double factor = 0.01; factor < 50; factor *= 2) {
                const Blow blow =
                    faster ? blowInTheMiddle(0.3, 3 * factor) : blowInTheMiddle(0.3 * factor, 3);
                const int damaged = strike(*solid, blow, 1).damaged_particles;
                EXPECT_GE(damaged, last) << factor;
                last = damaged;
            }
            EXPECT_GT(last, 0);
        }
    }
}

}  // namespace
