// Strength and damage belong to the places of the body that was whole at first.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/clustering/damaged_region.h"
#include "fracture/can_break.h"
#include "fracture/default_fracture.h"
#include "fracture/struck_plate.h"

namespace sherd {
namespace {

using namespace fracture_tests;

Material weibullPlaster() {
    Material material = Material::plaster();
    material.weibull_modulus = 8;
    return material;
}

std::shared_ptr<const BreakableSolid> plate(const Material& material, const Settings& settings = {}) {
    return plateAsset(material, settings).solid();
}

std::vector<Vec3> places() {
    std::vector<Vec3> places;
    for (double x = -0.2; x <= 0.2; x += 0.037)
        for (double y = -0.2; y <= 0.2; y += 0.041) places.emplace_back(x, y, 0.012 * std::sin(60 * x + y));
    return places;
}

TEST(MaterialStrengthOfBodies, IsTheSameAtAllQualities) {
    for (const Material& material : {Material::plaster(), weibullPlaster()}) {
        const BreakableAsset game = plateAsset(material);
        for (const Quality quality : {Quality::preview, Quality::film}) {
            const BreakableAsset other = plateAsset(material, Settings::forQuality(quality));
            ASSERT_NE(other.solid()->spacing(), game.solid()->spacing());
            for (const Vec3& x : places()) EXPECT_EQ(other.tensileStrength(x), game.tensileStrength(x));
        }
    }
}

/// Of all fragments, and of theirs if they break again under a blow in the middle.
void expectStrengthOf(const BreakableAsset& whole, const BreakableSolid& solid, int generations) {
    for (const double mass_kg : {0.5, 5.0, 50.0}) {
        const BlowOutcome out = strike(solid, blowInTheMiddle(mass_kg, 8), 1);
        if (out.outcome != Outcome::broke) continue;
        for (const Fragment& piece : out.fragments) {
            const BreakableAsset fragment(piece.solid);
            for (const Vec3& x : places()) ASSERT_EQ(fragment.tensileStrength(x), whole.tensileStrength(x));
            const Discretisation& sampling = *piece.solid->discretisation().value();
            const std::vector<double>& strengths = piece.solid->strength().atSamples(sampling);
            for (std::size_t i = 0; i < sampling.particles.size(); ++i)
                ASSERT_EQ(strengths[i], whole.tensileStrength(sampling.particles[i].position));
            if (generations > 1 && &piece == &out.fragments.front())
                expectStrengthOf(whole, *piece.solid, generations - 1);
        }
        return;
    }
    FAIL() << "nothing broke";
}

TEST(MaterialStrengthOfBodies, IsThatOfTheWholeInItsPieces) {
    Settings settings;
    settings.strength.seed = 9;
    settings.strength.field = [](const Vec3& x) { return 1 + 0.3 * std::sin(30 * x.x()); };
    for (const Material& material : {Material::plaster(), weibullPlaster()}) {
        const BreakableAsset whole = plateAsset(material, settings);
        expectStrengthOf(whole, *whole.solid(), 1);
        const BreakableAsset body = whole.ofBody(4);
        expectStrengthOf(body, *body.solid(), 1);
    }
}

TEST(MaterialStrengthOfBodies, ABodyWithASeedHasItsOwnAndSharesTheRest) {
    const BreakableAsset asset = plateAsset();
    const BreakableAsset a = asset.ofBody(1), b = asset.ofBody(2);
    int same = 0;
    for (const Vec3& x : places()) {
        EXPECT_EQ(a.tensileStrength(x), asset.ofBody(1).tensileStrength(x));
        same += a.tensileStrength(x) == b.tensileStrength(x);
        same += a.tensileStrength(x) == asset.tensileStrength(x);
    }
    EXPECT_EQ(same, 0);
    EXPECT_EQ(a.solid()->discretisation().value(), asset.solid()->discretisation().value());
    EXPECT_EQ(&a.surface(), &asset.surface());
    ASSERT_TRUE(b.prepare().ok());
    EXPECT_TRUE(asset.prepared());
    EXPECT_EQ(a.solid()->reducedStress(), b.solid()->reducedStress());
    const DamageReading& reading = asset.solid()->reducedStress()->reading;
    EXPECT_NE(a.solid()->strength().atPoints(reading), b.solid()->strength().atPoints(reading));
}

class EarlierDamage : public ::testing::Test {
  protected:
    /// A blow that damages something and parts nothing: the strongest of its kind that the plate holds.
    static Blow heldBlow() {
        Blow held;
        for (double speed = 0.5; speed < 20; speed *= 1.03) {
            const Blow blow = blowInTheMiddle(0.2, speed);
            const BlowOutcome out = strike(solid(), blow, 1);
            if (out.outcome == Outcome::broke) break;
            if (out.damaged) held = blow;
        }
        return held;
    }
    static const BreakableSolid& solid() {
        static const std::shared_ptr<const BreakableSolid> brittle = [] {
            Material material = Material::plaster();
            material.fracture_energy_j_m2 = 0.05;  // so that every blow pays for a crack
            return plate(material);
        }();
        return *brittle;
    }
    static const Discretisation& sampling() { return *solid().discretisation().value(); }
    static std::vector<char> column(double from_x, double to_x) {
        std::vector<char> damaged;
        for (const Particle& p : sampling().particles)
            damaged.push_back(p.position.x() > from_x && p.position.x() < to_x);
        return damaged;
    }
};

TEST_F(EarlierDamage, IsLeftByABlowThatDamagesAndPartsNothing) {
    const Blow blow = heldBlow();
    ASSERT_FALSE(blow.contacts.empty());
    const BlowOutcome first = strike(solid(), blow, 1);
    EXPECT_EQ(first.outcome, Outcome::held);
    ASSERT_TRUE(first.damaged);
    const std::vector<char> damaged = first.damaged->particles(sampling());
    EXPECT_EQ(std::count(damaged.begin(), damaged.end(), 1), first.damaged_particles);
    EXPECT_GT(first.damaged_particles, 0);
    // The same blow damages the same again; what lies elsewhere stays.
    EXPECT_EQ(
        strike(solid(), blow, solid().settings().fracture, 1, first.damaged).damaged->particles(sampling()),
        damaged);
    std::vector<char> both = column(0.1, 0.13);
    const auto elsewhere = DamagedMaterial::with(nullptr, sampling(), both);
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] || damaged[i];
    const BlowOutcome second = strike(solid(), blow, solid().settings().fracture, 1, elsewhere);
    EXPECT_EQ(second.damaged_particles, std::count(both.begin(), both.end(), 1));
}

TEST_F(EarlierDamage, TakesPartWhenTheBodyComesApart) {
    const Blow blow = heldBlow();
    ASSERT_FALSE(blow.contacts.empty());
    const auto crack = DamagedMaterial::with(nullptr, sampling(), column(0.1, 0.13));
    const BlowOutcome out = strike(solid(), blow, solid().settings().fracture, 1, crack);
    ASSERT_EQ(out.outcome, Outcome::broke) << "the crack parts the plate in two";
    EXPECT_FALSE(out.damaged);
    double right = 0;
    for (const Fragment& piece : out.fragments) right = std::max(right, piece.solid->moments().centroid.x());
    EXPECT_GT(right, 0.13);
}

TEST_F(EarlierDamage, BreaksNothingByItself) {
    const auto crack = DamagedMaterial::with(nullptr, sampling(), column(0.1, 0.13));
    const BlowOutcome out =
        strike(solid(), blowInTheMiddle(0.2, 0.02), solid().settings().fracture, 1, crack);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_FALSE(out.damaged);
}

TEST_F(EarlierDamage, IsNotLeftByABlowThatPaysForNoCrack) {
    const auto tough = [] {
        Material material = Material::plaster();
        material.fracture_energy_j_m2 = 1e6;
        return plate(material);
    }();
    const BlowOutcome out = strike(*tough, blowInTheMiddle(0.5, 8), 1);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_GT(out.damaged_particles, 0);
    EXPECT_FALSE(out.damaged);
}

}  // namespace
}  // namespace sherd
