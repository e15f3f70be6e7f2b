// Blows that are short for the body they fall on.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"
#include "fracture/blow_damage.h"
#include "fracture/decided.h"
#include "support/shapes.h"

namespace sherd {
namespace {

Material unbreakable(Material material) {
    material.tensile_strength_pa = 9e9;
    material.compressive_strength_pa = 9e10;
    material.strength_scatter = 0;
    return material;
}

std::shared_ptr<const BreakableSolid> prepared(const TriangleMesh& mesh, const Material& material,
                                               const Settings& settings = {}) {
    const auto solid = BreakableSolid::make(mesh, material, settings);
    EXPECT_TRUE(solid && solid.value()->prepare({}) && solid.value()->reducedStress());
    return solid.value();
}

/// A ball of that modulus flies in the direction of y.
Blow ball(const Vec3& point, double mass_kg, double speed_m_s, double radius_m, double modulus_pa) {
    ContactImpulse contact;
    contact.point = point;
    contact.normal = contact.impulse = Vec3::UnitY();
    contact.approach_m_s = speed_m_s;
    contact.partner_radius_m = radius_m;
    contact.partner_youngs_modulus_pa = modulus_pa;
    contact.partner_poisson_ratio = 0.3;
    return {{contact}, {Mobility::ofPoint(mass_kg)}};
}

BlowDamage solved(const BreakableSolid& solid, const Blow& blow, Level level) {
    FractureSettings fracture = solid.settings().fracture;
    fracture.use_reduced_model = level == Level::reduced;
    StageTimes ms;
    BlowDamage found =
        blowDamage({solid, *solid.discretisation().value(), fracture, 1}, blow, solid.strength(), ms);
    EXPECT_EQ(found.level, level);
    return found;
}

/// Displacement of an oscillator of rate w over its static one, t after half a sine wave of that duration has
/// begun to push it.
double answerToHalfASine(double t, double w, double duration_s) {
    const auto ramp = [&](double since) {
        if (since <= 0) return 0.0;
        const double r = pi / (w * duration_s);
        return (std::sin(pi * since / duration_s) - r * std::sin(w * since)) / (1 - r * r);
    };
    return ramp(t) + ramp(t - duration_s);
}

/// A free beam after Euler and Bernoulli that half a sine wave strikes in its middle. The symmetric modes
/// have tan(k L / 2) + tanh(k L / 2) = 0.
struct StruckBeam {
    double length, height, width, youngs, density;

    double rate(int mode) const {
        const double k = kl(mode) / length;
        return k * k * height / std::sqrt(12.0) * std::sqrt(youngs / density);
    }
    /// The largest stress in the middle, until the first swing after the pulse is over, Pa/N.
    double peakPerNewton(double duration_s) const {
        const double end = duration_s + 2 * pi / rate(0);
        double peak = 0;
        constexpr int steps = 3000;
        for (int i = 1; i <= steps; ++i) peak = std::max(peak, stressAt(end * i / steps, duration_s));
        return peak;
    }
    double staticPerNewton() const { return length / 8 * height / 2 / inertia(); }

  private:
    static double kl(int mode) { return mode == 0 ? 4.730041 : (2 * mode + 1.5) * pi; }
    double inertia() const { return width * height * height * height / 12; }
    double stressAt(double t, double duration_s) const {
        double sum = 0;
        for (int mode = 0; mode < 40; ++mode) {
            // A symmetric mode is cos(k x) / cos(k L / 2) + cosh(k x) / cosh(k L / 2); its square has the
            // integral L.
            const double half = kl(mode) / 2, k = kl(mode) / length;
            const double value = 1 / std::cos(half) + 1 / std::cosh(half);
            const double curvature = k * k * (1 / std::cosh(half) - 1 / std::cos(half));
            sum -=
                value * curvature / (length * k * k * k * k) * answerToHalfASine(t, rate(mode), duration_s);
        }
        return height / 2 / inertia() * sum;
    }
};

TEST(VibrationBlow, ARodIsBentAsAStruckBeam) {
    const Material material = unbreakable(Material::ceramic());
    const StruckBeam beam{0.8, 0.02, 0.024, material.youngs_modulus_pa, material.density_kg_m3};
    const auto rod = prepared(shapes::slab({0.8, 0.02, 0.024}, 20, 1, 1), material);
    const double period = 2 * pi / beam.rate(0);
    EXPECT_NEAR(beam.peakPerNewton(20 * period), beam.staticPerNewton(), 0.05 * beam.staticPerNewton());
    for (const double modulus : {1e9, 3e7, 3e6}) {
        const BlowDamage found = solved(*rod, ball(Vec3(0, -0.01, 0), 0.2, 2, 0.03, modulus), Level::reduced);
        const ContactPulse& pulse = found.forces.pulse;
        const double stress = found.damage.largest_stress_pa / pulse.peak_force_n;
        const double expected = beam.peakPerNewton(pulse.duration_s);
        EXPECT_NEAR(stress, expected, 0.1 * expected) << pulse.duration_s / period << " periods";
        EXPECT_GT(std::abs(beam.staticPerNewton() - expected), 0.1 * expected) << "it is no static blow";
    }
}

/// The largest stress anywhere in a free beam that half a sine wave strikes at `place` (of its length), until
/// a period after it is over; after Euler and Bernoulli, Pa/N.
double peakOfFreeBeam(double length, double height, double width, double youngs, double density, double place,
                      double duration_s) {
    const double kl[] = {4.730041,  7.853205,  10.995608, 14.137165,
                         17.278760, 20.420352, 23.561945, 26.703538};
    constexpr int modes = 8, places = 100, steps = 2000;
    // Its moment at some places (rows) under each mode of its static amplitude, over the force.
    Eigen::MatrixXd moments(places, modes);
    Eigen::ArrayXd rates(modes);
    for (int m = 0; m < modes; ++m) {
        const double root = kl[m], k = root / length;
        const double sigma = (std::cosh(root) - std::cos(root)) / (std::sinh(root) - std::sin(root));
        // With sign 1 its shape, whose square has the integral L, with -1 its curvature.
        const auto sum = [&](double x, double sign) {
            return std::cosh(x) + sign * std::cos(x) - sigma * (std::sinh(x) + sign * std::sin(x));
        };
        for (int j = 0; j < places; ++j)
            moments(j, m) = sum(root * place, 1) * sum(root * j / places, -1) / (k * k * length);
        rates[m] = k * k * height / std::sqrt(12.0) * std::sqrt(youngs / density);
    }
    const double end = duration_s + 2 * pi / rates[0];
    double peak = 0;
    for (int i = 1; i <= steps; ++i) {
        Eigen::VectorXd answers(modes);
        for (int m = 0; m < modes; ++m) answers[m] = answerToHalfASine(end * i / steps, rates[m], duration_s);
        peak = std::max(peak, (moments * answers).cwiseAbs().maxCoeff());
    }
    const double inertia = width * height * height * height / 12;
    return height / 2 / inertia * peak;
}

// Its waves meet away from where it was struck, and from where any of its vibrations alone strains it most.
TEST(VibrationBlow, ARodRingsHardestWhereItsWavesMeet) {
    const Material material = unbreakable(Material::ceramic());
    const double length = 0.6, height = 0.02, width = 0.024;
    const auto rod = prepared(shapes::slab({length, height, width}, 20, 1, 1), material);
    for (const double place : {0.6, 0.65, 0.75})
        for (const double modulus : {3e9, 1e9, 3e8}) {
            const BlowDamage found =
                solved(*rod, ball(Vec3((place - 0.5) * length, -height / 2, 0), 0.05, 5, 0.02, modulus),
                       Level::reduced);
            const ContactPulse& pulse = found.forces.pulse;
            const double expected =
                pulse.peak_force_n * peakOfFreeBeam(length, height, width, material.youngs_modulus_pa,
                                                    material.density_kg_m3, place, pulse.duration_s);
            // The closed form leaves out that short waves shear the rod.
            EXPECT_NEAR(found.damage.largest_stress_pa, expected, 0.12 * expected)
                << "at " << place << ", " << modulus << " Pa";
        }
}

// Its stress is far above that of the plate, but what bends the plate hardly moves it.
TEST(VibrationBlow, AThinPegDoesNotHideAPlate) {
    const auto body =
        prepared(shapes::rectilinear({-0.15, -0.1, -0.05, 0, 0.05, 0.1, 0.13, 0.134, 0.15},
                                     {-0.004, 0.004, 0.05}, {-0.12, -0.06, 0, 0.06, 0.1, 0.104, 0.12},
                                     [](int i, int j, int k) { return j == 0 || (k == 4 && i == 6); }),
                 unbreakable(Material::ceramic()));
    const VibrationModes& vibrations = body->reducedStress()->model.vibrations();
    const Eigen::VectorXf sizes = vibrations.hot_pa.rowwise().norm();
    EXPECT_GT((sizes.array() < 0.2f * sizes.maxCoeff()).count(), 20) << "places that are not on the peg";
}

/// The largest stress at the root of a beam that is held at one end and struck at `place` (of its length) by
/// half a sine wave, until a period after it is over; after Euler and Bernoulli, Pa/N.
double rootStressOfCantilever(double length, double height, double width, double youngs, double density,
                              double place, double duration_s) {
    const double kl[] = {1.875104, 4.694091, 7.854757, 10.995541, 14.137168,
                         5.5 * pi, 6.5 * pi, 7.5 * pi, 8.5 * pi,  9.5 * pi};
    const double inertia = width * height * height * height / 12;
    const auto rate = [&](double k) {
        return k * k * height / std::sqrt(12.0) * std::sqrt(youngs / density);
    };
    const double end = duration_s + 2 * pi / rate(kl[0] / length);
    constexpr int steps = 5000;
    double peak = 0;
    for (int i = 1; i <= steps; ++i) {
        double moment = 0;
        for (const double root : kl) {
            // Its square has the integral L, and it has a curvature of 2 k^2 at the root.
            const double k = root / length, x = k * place * length;
            const double sigma = (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
            const double shape = std::cosh(x) - std::cos(x) - sigma * (std::sinh(x) - std::sin(x));
            moment += 2 * shape / (k * k * length) * answerToHalfASine(end * i / steps, rate(k), duration_s);
        }
        peak = std::max(peak, std::abs(moment));
    }
    return height / 2 / inertia * peak;
}

// It swings on after a short contact, and is bent most where nothing struck it.
TEST(VibrationBlow, ACantileverBreaksAtItsRoot) {
    const Material material = unbreakable(Material::ceramic());
    const double length = 0.8, side = 0.03;
    const auto held = BreakableSolid::make(shapes::slab({length, side, side}, 20, 1, 1), material, {},
                                           {BoxRegion{{-length / 2, -1, -1}, {-length / 2, 1, 1}}});
    ASSERT_TRUE(held && held.value()->prepare({}));
    for (const double mass : {0.05, 0.1, 0.3}) {
        const BlowDamage found = solved(
            *held.value(), ball(Vec3(length / 4, -side / 2, 0), mass, 0.5, 0.05, 5e10), Level::reduced);
        const ContactPulse& pulse = found.forces.pulse;
        const double expected =
            pulse.peak_force_n * rootStressOfCantilever(length, side, side, material.youngs_modulus_pa,
                                                        material.density_kg_m3, 0.75, pulse.duration_s);
        // The corners of a clamp have more than a beam's root.
        EXPECT_GT(found.damage.largest_stress_pa, 0.9 * expected) << mass;
        EXPECT_LT(found.damage.largest_stress_pa, 1.3 * expected) << mass;
        const auto& stresses = found.damage.stress;
        const auto hottest = std::max_element(
            stresses.begin(), stresses.end(),
            [](const auto& a, const auto& b) { return largestPrincipal(a) < largestPrincipal(b); });
        const auto& particles = held.value()->discretisation().value()->particles;
        EXPECT_LT(particles[static_cast<std::size_t>(hottest - stresses.begin())].position.x(),
                  -0.4 * length);
    }
}

TEST(VibrationBlow, TheReducedModelAndTheFullSolveAgree) {
    const auto plate = prepared(shapes::slab({0.3, 0.01, 0.24}, 10, 1, 8), unbreakable(Material::glass()),
                                Settings::forQuality(Quality::preview));
    for (const double modulus : {5e10, 1e8}) {
        const Blow blow = ball(Vec3(0.05, -0.005, 0.03), 0.05, 3, 0.02, modulus);
        const BlowDamage fast = solved(*plate, blow, Level::reduced),
                         full = solved(*plate, blow, Level::full);
        ASSERT_FALSE(fast.forces.pressed.empty());
        EXPECT_NEAR(fast.forces.pulse.peak_force_n, full.forces.pulse.peak_force_n,
                    0.02 * full.forces.pulse.peak_force_n);
        EXPECT_NEAR(fast.damage.largest_stress_pa, full.damage.largest_stress_pa,
                    0.04 * full.damage.largest_stress_pa);
    }
}

TEST(VibrationBlow, AContactAsFastAsTheFastestModeHasRitzVectors) {
    const auto plate = prepared(shapes::slab({0.3, 0.01, 0.24}, 10, 1, 8), unbreakable(Material::glass()),
                                Settings::forQuality(Quality::preview));
    const auto stress = [&](const BlowDamage& found) {
        return found.damage.largest_stress_pa / found.forces.pulse.peak_force_n;
    };
    const Blow soft = ball(Vec3(0.05, -0.005, 0.03), 0.05, 3, 0.02, 1e8);
    EXPECT_EQ(solved(*plate, soft, Level::reduced).forces.modes.ritz_vectors.cols(), 0);
    const Blow pellet = ball(Vec3(0.05, -0.005, 0.03), 0.0005, 20, 0.003, 2e11);
    const BlowDamage fast = solved(*plate, pellet, Level::reduced),
                     full = solved(*plate, pellet, Level::full);
    for (const BlowDamage* found : {&fast, &full}) {
        const StruckModes& modes = found->forces.modes;
        ASSERT_EQ(modes.ritz_vectors.cols(), 2);
        EXPECT_LT(found->forces.pulse.duration_s * modes.rates_rad_s[modes.rates_rad_s.size() - 3], 3 * pi);
        for (const VibrationState& state : found->forces.pressed)
            EXPECT_EQ(state.modes.size(), modes.work.size());
    }
    EXPECT_NEAR(stress(fast), stress(full), 0.04 * stress(full));
}

TEST(VibrationBlow, ALongContactIsQuasiStatic) {
    const TriangleMesh mesh = shapes::slab({0.2, 0.15, 0.1}, 3, 3, 3);
    const Settings preview = Settings::forQuality(Quality::preview);
    const auto block = prepared(mesh, unbreakable(Material::ceramic()), preview);
    const auto bare = BreakableSolid::make(mesh, unbreakable(Material::ceramic()), preview).value();
    const Blow blow = ball(Vec3(0.02, -0.075, 0.01), 5, 0.5, 0.1, 1e7);
    const BlowDamage found = solved(*block, blow, Level::full), plain = solved(*bare, blow, Level::full);
    EXPECT_TRUE(found.forces.pressed.empty());
    EXPECT_EQ(found.forces.pulse.peak_force_n, plain.forces.pulse.peak_force_n);
    EXPECT_EQ(found.damage.largest_stress_pa, plain.damage.largest_stress_pa);
}

// What the contact damages may be too little for a crack right through; then the body rings all the same.
TEST(VibrationBlow, WhatBreaksUnderABlowBreaksUnderAHarderOne) {
    const auto rod = prepared(shapes::slab({0.8, 0.02, 0.024}, 20, 1, 1), Material::ceramic(),
                              Settings::forQuality(Quality::preview));
    for (const double modulus : {2e11, 2e9}) {
        double broke_at = 0;
        for (double speed = 1; speed < 10; speed *= 1.1) {
            const Blow blow = ball(Vec3(0.1, -0.01, 0), 0.05, speed, 0.02, modulus);
            const BlowOutcome out = decided(*rod, blow, rod->settings().fracture);
            if (out.outcome == Outcome::broke) {
                if (broke_at == 0) broke_at = speed;
                EXPECT_EQ(out.damaged, nullptr) << "pieces have what earlier blows damaged, not this one";
            } else {
                EXPECT_EQ(broke_at, 0) << modulus << " Pa: it does not break at " << speed << " m/s";
            }
        }
        EXPECT_GT(broke_at, 0) << modulus << " Pa";
    }
}

// While it is pressed, the rod is compressed, which plaster bears; then it pulls itself apart, with less
// energy.
TEST(VibrationBlow, WhatRingsFaintlyBreaksARodThatAContactCompresses) {
    const auto rod = prepared(shapes::slab({0.045, 0.408, 0.044}, 1, 9, 1), Material::plaster(),
                              Settings::forQuality(Quality::preview));
    const Blow blow = ball(Vec3(-0.004, -0.204, -0.003), 0.334, 45, 0.0614, 3.8e7);
    const BlowOutcome out = decided(*rod, blow, rod->settings().fracture);
    EXPECT_EQ(out.outcome, Outcome::broke) << out.largest_stress_pa << " Pa";
}

double largestPiece(const BreakableSolid& solid, const Blow& blow) {
    const BlowOutcome out = decided(solid, blow, solid.settings().fracture);
    EXPECT_EQ(out.outcome, Outcome::broke) << out.message;
    double largest = 0;
    for (const Fragment& fragment : out.fragments) largest = std::max(largest, fragment.solid->mass());
    return largest / solid.mass();
}

TEST(VibrationBlow, AFastBallLeavesAHoleInAWallAndASlowOneBringsItDown) {
    const TriangleMesh mesh = shapes::slab({1.2, 0.06, 0.9}, 12, 1, 9);
    Settings settings = Settings::forQuality(Quality::game);
    const Vec3 from(0.03, -0.03, 0.02);
    const Blow fast = ball(from, 0.05, 40, 0.012, 2e11), slow = ball(from, 50, 4, 0.2, 1e7);
    for (const CrackPattern pattern : {CrackPattern::stress, CrackPattern::seeds}) {
        settings.fracture.crack_pattern = pattern;
        const auto wall = prepared(mesh, Material::plaster(), settings);
        EXPECT_GT(largestPiece(*wall, fast), 0.9);
        EXPECT_LT(largestPiece(*wall, slow), 0.5);
        const auto bare = BreakableSolid::make(mesh, Material::plaster(), settings).value();
        EXPECT_LT(largestPiece(*bare, fast), 0.6) << "a quasi-static solve bends all of the wall";
    }
}

}  // namespace
}  // namespace sherd
