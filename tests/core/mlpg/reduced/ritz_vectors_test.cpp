#include "core/mlpg/reduced/ritz_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/linear_algebra/block_product.h"
#include "core/mlpg/reduced/reduced_support.h"
#include "core/numerics/pi.h"
#include "core/vibration/oscillators.h"
#include "support/newmark.h"

namespace sherd {
namespace {

/// Half a sine wave that has pushed for a time t.
double halfSine(double t, double duration_s) {
    return t < duration_s ? std::sin(pi * t / duration_s) : 0;
}

/// Follows modes under half a sine wave, with the force and the amplitudes after each of `steps` of it and as
/// many after it.
void follow(const StruckModes& modes, double duration_s, int steps,
            const std::function<void(double force, const Eigen::ArrayXd& amplitudes)>& see) {
    Oscillators oscillators(modes);
    constexpr int substeps = 20;
    const double substep = duration_s / steps / substeps;
    oscillators.setStep(substep);
    for (int i = 1; i <= 2 * steps * substeps; ++i) {
        oscillators.swing();
        oscillators.push(halfSine((i - 0.5) * substep, duration_s));
        if (i % substeps == 0) see(halfSine(i * substep, duration_s), oscillators.amplitudes());
    }
}

/// Oscillators of unit mass whose rates are evenly spaced from 1 on, as those of a plate. A patch that is not
/// small pushes the fastest less. The slowest are known.
struct Spectrum {
    StruckModes all;
    int known;
    double energy_share = 0.1;

    Spectrum(int count, int known_count) : known(known_count) {
        all.rates_rad_s = Eigen::ArrayXd::LinSpaced(count, 1, count);
        const double patch = 4.0 * known_count;
        all.work = (-0.5 * (all.rates_rad_s / patch).square()).exp() / all.rates_rad_s;
    }

    StruckModes struck() const { return {all.rates_rad_s.head(known), all.work.head(known)}; }
    BeyondModes beyond() const {
        const auto unknown = [this](Eigen::ArrayXd u) {
            u.head(known).setZero();
            return Eigen::VectorXd(u);
        };
        return {unknown(all.work / all.rates_rad_s), energy_share, [](const Eigen::VectorXd& u) { return u; },
                [this, unknown](const Eigen::VectorXd& p) {
                    return unknown(p.array() / all.rates_rad_s.square());
                }};
    }
    /// The curvature at the load of a displacement.
    double bending(const Eigen::ArrayXd& u) const { return (all.rates_rad_s.square() * all.work * u).sum(); }
};

TEST(RitzVectors, StandForAllFasterModesOfAPlate) {
    const Spectrum plate(1000, 20);
    StruckModes modes = plate.struck();
    addRitzVectors(plate.beyond(), modes);
    ASSERT_EQ(modes.work.size(), 22);
    ASSERT_EQ(modes.ritz_vectors.cols(), 2);
    EXPECT_GT(modes.rates_rad_s[20], 20);
    for (const double times : {0.5, 1.0, 2.0}) {  // as fast as the fastest known mode
        const double duration = pi / (times * 20);
        constexpr int steps = 40;
        std::vector<double> expected, found;  // beyond the known modes and the static answer
        follow(plate.all, duration, steps, [&](double force, const Eigen::ArrayXd& amplitudes) {
            Eigen::ArrayXd beyond = (amplitudes - force * plate.all.work) / plate.all.rates_rad_s;
            beyond.head(20).setZero();
            expected.push_back(plate.bending(beyond));
        });
        follow(modes, duration, steps, [&](double force, const Eigen::ArrayXd& amplitudes) {
            const Eigen::VectorXd beyond = (amplitudes - force * modes.work).tail(2);
            found.push_back(plate.bending((modes.ritz_vectors.cast<double>() * beyond).array()));
        });
        const double expected_peak = *std::max_element(expected.begin(), expected.end());
        const double peak = *std::max_element(found.begin(), found.end());
        double missed = 0, all = 0;
        for (int i = 0; i < 2 * steps; ++i) {
            missed += std::pow(found[i] - expected[i], 2);
            all += std::pow(expected[i], 2);
        }
        EXPECT_NEAR(peak, expected_peak, 0.3 * expected_peak) << times;
        EXPECT_LT(std::sqrt(missed / all), 0.6) << times << "; without them all is missed";
    }
}

TEST(RitzVectors, OfFewModesAreTheseModes) {
    for (const int left : {1, 2}) {
        const Spectrum body(10 + left, 10);
        StruckModes modes = body.struck();
        addRitzVectors(body.beyond(), modes);
        ASSERT_EQ(modes.work.size(), 10 + left);
        for (int m = 10; m < 10 + left; ++m) {
            EXPECT_NEAR(modes.rates_rad_s[m], body.all.rates_rad_s[m], 1e-6 * body.all.rates_rad_s[m]);
            EXPECT_NEAR(std::abs(modes.work[m]), body.all.work[m], 1e-6 * body.all.work[m]);
        }
    }
    const Spectrum known(10, 10);
    StruckModes modes = known.struck();
    addRitzVectors(known.beyond(), modes);
    EXPECT_EQ(modes.work.size(), 10);
}

TEST(RitzVectors, AreNotMadeOfRounding) {
    Spectrum plate(1000, 20);
    plate.energy_share = 1e-3;
    StruckModes modes = plate.struck();
    addRitzVectors(plate.beyond(), modes);
    EXPECT_EQ(modes.work.size(), 20);
}

// Of a block the fastest known modes are not its own: they and the vectors would have to be solved together.
TEST(RitzVectors, AreNotMadeWhereModesAreJoinedToThem) {
    const BothSolutions both = bothSolutions(shapes::slab({0.3, 0.25, 0.2}, 1, 1, 1), 0.025);
    const ReducedModel& model = both.reduced.model;
    std::mt19937 random(3);
    const auto loads = randomPush(*both.solid, 0.03, random);
    ReducedModel::LocalSystem kept;
    const double duration = pi / model.vibrations().rates_rad_s.maxCoeff();
    EXPECT_EQ(model.struckModes(loads, duration, kept).ritz_vectors.cols(), 0);
}

// Against Newmark's method on the same grid, with the mass matrix and no modes. The cells of an oblique wall
// are cut.
TEST(RitzVectors, AnswerAShortContactOnAWall) {
    const BothSolutions both = bothSolutions(obliqueWall(), 0.02);
    ReducedModelLimits few;
    few.modes = 64;
    const ReducedModel model = valueOf(ReducedModel::make(both.problem, both.stiffness, both.unit, few));
    const double duration = 2 * pi / model.vibrations().rates_rad_s.maxCoeff();
    constexpr int steps = 20;
    const Newmark newmark(*both.problem);
    const auto stepper = valueOf(newmark.stepper(duration / steps));
    std::mt19937 random(3);
    for (int blow = 0; blow < 4; ++blow) {
        const auto loads = randomPush(*both.solid, 0.02, random);
        const auto tension = [&](const Eigen::VectorXd& u) {
            return largestTension(stressUnder(both, u, loads));
        };
        const Eigen::VectorXd force = valueOf(forcesAt(*both.problem, loads));
        Newmark::Motion now(newmark.unknowns());
        double expected = 0;
        for (int step = 1; step <= 2 * steps; ++step) {
            const double push = halfSine(step * duration / steps, duration);
            ASSERT_TRUE(newmark.advance(*stepper, duration / steps, push * force, now));
            expected = std::max(expected, tension(now.displacement));
        }

        ReducedModel::LocalSystem kept;
        const ReducedResponse unit = valueOf(model.respond(loads, kept));
        const auto peak = [&](const StruckModes& modes) {
            double largest = 0;
            follow(modes, duration, steps, [&](double push, const Eigen::ArrayXd& amplitudes) {
                const Eigen::VectorXf beyond = model.vibration(modes, amplitudes - push * modes.work);
                largest = std::max(
                    largest, tension((static_cast<float>(push) * unit.unknowns + beyond).cast<double>()));
            });
            return largest;
        };
        const StruckModes modes = model.struckModes(loads, duration, kept);
        ASSERT_EQ(modes.ritz_vectors.cols(), 2);
        EXPECT_LT(modes.staticEnergy(), 1.001 * unit.strain_energy_j);
        EXPECT_NEAR(peak(modes), expected, 0.08 * expected) << blow;

        const StruckModes of_slow_contact = model.struckModes(loads, 100 * duration, kept);
        ASSERT_EQ(of_slow_contact.ritz_vectors.cols(), 0);
        EXPECT_LT(peak(of_slow_contact), 0.9 * expected) << "the test needs faster modes";
    }
}

}  // namespace
}  // namespace sherd
