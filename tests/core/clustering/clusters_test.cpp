#include "core/clustering/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/clustering/affordable_clusters.h"
#include "core/clustering/penalty_distance.h"

namespace {

using namespace sherd;

/// A sheet of n x n particles at distance 1, neighbours across edges.
Discretisation sheet(int n) {
    Discretisation solid;
    solid.spacing = 1;
    solid.particles.resize(n * n);
    solid.neighbours.resize(n * n);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const int i = y * n + x;
            solid.particles[i] = {Vec3(x, y, 0), 1, 1};
            if (y > 0) solid.neighbours[i].push_back(i - n);
            if (x > 0) solid.neighbours[i].push_back(i - 1);
            if (x + 1 < n) solid.neighbours[i].push_back(i + 1);
            if (y + 1 < n) solid.neighbours[i].push_back(i + n);
        }
    }
    return solid;
}

Damage damageWhere(const Discretisation& solid, bool (*test)(const Vec3&)) {
    Damage damage;
    for (const Particle& p : solid.particles) {
        damage.damaged.push_back(test(p.position));
        damage.overstress.push_back(test(p.position) ? 2 : 0.5);
        damage.count += test(p.position);
    }
    return damage;
}

bool connected(const Discretisation& solid, const FragmentLabels& labels, int label) {
    std::vector<int> stack;
    std::set<int> seen;
    for (std::size_t i = 0; i < labels.of_particle.size() && stack.empty(); ++i)
        if (labels.of_particle[i] == label) stack.push_back(static_cast<int>(i));
    while (!stack.empty()) {
        const int i = stack.back();
        stack.pop_back();
        if (!seen.insert(i).second) continue;
        for (int j : solid.neighbours[i])
            if (labels.of_particle[j] == label) stack.push_back(j);
    }
    return static_cast<long>(seen.size()) ==
           std::count(labels.of_particle.begin(), labels.of_particle.end(), label);
}

TEST(Clusters, ADamagedBandLeavesTwoWholePartsAndItsClusters) {
    const Discretisation solid = sheet(20);
    const Damage damage = damageWhere(solid, [](const Vec3& x) { return x.x() > 7.5 && x.x() < 11.5; });
    const FragmentLabels labels = clusterParticles(solid, damage, 5, 0, 3);
    EXPECT_EQ(labels.count, 7);
    EXPECT_EQ(labels.of_particle[0], labels.of_particle[20 * 19]);
    EXPECT_NE(labels.of_particle[0], labels.of_particle[19]);
    for (int l = 0; l < labels.count; ++l) EXPECT_TRUE(connected(solid, labels, l)) << l;
    EXPECT_GE(*std::min_element(labels.of_particle.begin(), labels.of_particle.end()), 0);
}

TEST(Clusters, SeedChangesTheClustersAndNothingElseDoes) {
    const Discretisation solid = sheet(16);
    const Damage damage = damageWhere(solid, [](const Vec3&) { return true; });
    const auto first = clusterParticles(solid, damage, 6, 0, 1).of_particle;
    EXPECT_EQ(first, clusterParticles(solid, damage, 6, 0, 1).of_particle);
    EXPECT_NE(first, clusterParticles(solid, damage, 6, 0, 2).of_particle);
}

TEST(Clusters, DenserWhereTheStressIsHigher) {
    const Discretisation solid = sheet(40);
    Damage damage = damageWhere(solid, [](const Vec3&) { return true; });
    for (std::size_t i = 0; i < solid.particles.size(); ++i)
        damage.overstress[i] = solid.particles[i].position.x() < 20 ? 16 : 1;
    const FragmentLabels labels = clusterParticles(solid, damage, 30, 0, 5);
    std::set<int> left, right;
    for (int i = 0; i < 1600; ++i) (i % 40 < 20 ? left : right).insert(labels.of_particle[i]);
    EXPECT_GT(left.size(), 2 * right.size());
}

TEST(Clusters, SpecksJoinWhatSurroundsThem) {
    const Discretisation solid = sheet(12);
    const Damage dots =
        damageWhere(solid, [](const Vec3& x) { return x.x() == 5 && (x.y() == 5 || x.y() == 6); });
    EXPECT_EQ(clusterParticles(solid, dots, 4, 0, 1).count, 1);
    const Damage all_but_one = damageWhere(solid, [](const Vec3& x) { return !(x.x() == 5 && x.y() == 5); });
    EXPECT_EQ(clusterParticles(solid, all_but_one, 4, 0, 1).count, 4);
}

// A body breaks alike on a fine grid and on one of which two particles are as much of the wall as six of
// that.
TEST(Clusters, SpecksAreFewerParticlesWhereTheWallIsThinnerThanTheirSpacing) {
    const Discretisation solid = sheet(12);
    const Damage dots =
        damageWhere(solid, [](const Vec3& x) { return x.x() == 5 && (x.y() == 5 || x.y() == 6); });
    EXPECT_GT(clusterParticles(solid, dots, 4, 0.55, 1).count, 1);
    EXPECT_EQ(clusterParticles(solid, dots, 4, 0.7, 1).count, 1);
}

// Nothing says here which way a wall would go.
TEST(Clusters, DamageReachesTwoParticlesFurtherOrThreeQuartersOfTheWall) {
    const Discretisation solid = sheet(20);
    const Damage damage = damageWhere(solid, [](const Vec3& x) { return x.x() < 2.5; });
    for (const double wall : {2.0, 4.0, 100.0}) {
        const auto labels = clusterParticles(solid, damage, 1, wall, 1).of_particle;
        const int last = wall < 3 ? 3 : 4;
        EXPECT_EQ(labels[0], labels[last]) << wall;
        EXPECT_NE(labels[0], labels[last + 1]) << wall;
    }
}

TEST(Clusters, SeparateDamagedPartsGetSeedsEvenIfFewAreWanted) {
    const Discretisation solid = sheet(20);
    const Damage damage = damageWhere(solid, [](const Vec3& x) { return x.x() < 4 || x.x() > 15; });
    const FragmentLabels labels = clusterParticles(solid, damage, 1, 0, 1);
    EXPECT_EQ(labels.count, 3);
}

TEST(Clusters, MoreEnergyPaysForMoreClusters) {
    int last = 0;
    for (double energy = 0.01; energy < 100; energy *= 2) {
        const int count = affordableClusters({energy, 20, 0.005}, 1e-4);
        EXPECT_GE(count, last);
        last = count;
    }
    EXPECT_GT(last, 100);
    EXPECT_EQ(affordableClusters({0, 20, 0.005}, 1e-4), 1);
}

TEST(PenaltyDistance, IsEquation18) {
    GuideField grain;
    grain.kind = GuideField::Kind::constant;
    grain.direction = Vec3(0, 0, 5);
    grain.cost_along = 0.2;
    const Vec3 a(1, 2, 3), b(4, 6, 8);
    BlowAxis contact;
    EXPECT_NEAR(penaltyDistance(a, b, grain, contact), Vec3(3, 4, 0.2 * 5).norm(), 1e-14);
    EXPECT_EQ(penaltyDistance(a, b, grain, contact), penaltyDistance(b, a, grain, contact));
    for (const double length : {1e-200, 1e200}) {
        grain.direction = Vec3(0, 0, length);
        EXPECT_NEAR(penaltyDistance(a, b, grain, contact), Vec3(3, 4, 0.2 * 5).norm(), 1e-14) << length;
    }
    grain.cost_along = 1;
    EXPECT_NEAR(penaltyDistance(a, b, grain, contact), (b - a).norm(), 1e-14);
    grain.kind = GuideField::Kind::radial;
    grain.cost_along = 0;
    EXPECT_NEAR(penaltyDistance(Vec3(1, 0, 0), Vec3(3, 0, 0), grain, contact), 0, 1e-14);
    EXPECT_NEAR(penaltyDistance(Vec3(1, 0, 0), Vec3(0, 1, 0), grain, contact), 1, 1e-14);
    EXPECT_NEAR(penaltyDistance(Vec3(1, 0, 2), Vec3(3, 0, 5), grain, contact), 1 / std::hypot(1, 2), 1e-13)
        << "no axis: away from the contact, as at the seed";
    contact.direction = Vec3::UnitZ();
    EXPECT_NEAR(penaltyDistance(Vec3(1, 0, 2), Vec3(3, 0, 5), grain, contact), 0, 1e-14)
        << "straight through";
    EXPECT_NEAR(penaltyDistance(Vec3(1, 0, 2), Vec3(-3, 0, 5), grain, contact), 3, 1e-14)
        << "beyond the axis";
    grain.kind = GuideField::Kind::custom;
    grain.custom = [](const Vec3&, const Vec3&) { return Vec3(Vec3::Zero()); };
    EXPECT_NEAR(penaltyDistance(a, b, grain, contact), (b - a).norm(), 1e-14) << "no direction there";
}

/// Mean over clusters of their spread along a direction over that across it.
double meanElongation(const Discretisation& solid, const FragmentLabels& labels, const Vec3& along) {
    const Vec3 across = Vec3::UnitZ().cross(along);
    double sum = 0;
    for (int label = 0; label < labels.count; ++label) {
        Vec3 mean = Vec3::Zero();
        double count = 0, second[2] = {1e-9, 1e-9};
        for (std::size_t i = 0; i < labels.of_particle.size(); ++i)
            if (labels.of_particle[i] == label) mean += solid.particles[i].position, ++count;
        mean /= count;
        for (std::size_t i = 0; i < labels.of_particle.size(); ++i) {
            if (labels.of_particle[i] != label) continue;
            const Vec3 x = solid.particles[i].position - mean;
            second[0] += std::pow(x.dot(along), 2);
            second[1] += std::pow(x.dot(across), 2);
        }
        sum += std::sqrt(second[0] / second[1]) / labels.count;
    }
    return sum;
}

TEST(Clusters, GrowAlongTheGrainHoweverItLies) {
    const Discretisation solid = sheet(40);
    const Damage damage = damageWhere(solid, [](const Vec3&) { return true; });
    GuideField grain;
    EXPECT_NEAR(meanElongation(solid, clusterParticles(solid, damage, 16, 0, 1, grain), Vec3::UnitX()), 1,
                0.25);
    grain.kind = GuideField::Kind::constant;
    for (const double angle : {0.0, 0.5, 0.8}) {
        grain.direction = Vec3(std::cos(angle), std::sin(angle), 0);
        const FragmentLabels labels = clusterParticles(solid, damage, 16, 0, 1, grain);
        EXPECT_EQ(labels.count, 16);
        EXPECT_GT(meanElongation(solid, labels, grain.direction), 2.5) << angle;
    }
}

// About the blow clusters are sectors: long along the radius.
TEST(Clusters, ARadialFieldMakesSectors) {
    const Discretisation solid = sheet(41);
    const Damage damage = damageWhere(solid, [](const Vec3&) { return true; });
    const BlowAxis contact{Vec3(20, 20, 0), Vec3::Zero()};
    GuideField radial;
    radial.kind = GuideField::Kind::radial;
    radial.cost_along = 0.1;
    const auto spreadOf = [&](const GuideField& guide) {
        const FragmentLabels labels = clusterParticles(solid, damage, 16, 0, 1, guide, contact);
        double along = 0, across = 0;
        for (std::size_t i = 0; i < solid.neighbours.size(); ++i)
            for (int j : solid.neighbours[i]) {
                if (labels.of_particle[i] == labels.of_particle[j]) continue;
                // A border between two clusters has the direction of the step across it.
                const Vec3 step = (solid.particles[j].position - solid.particles[i].position).normalized();
                const Vec3 radius =
                    (0.5 * (solid.particles[i].position + solid.particles[j].position) - contact.contact)
                        .normalized();
                along += std::pow(step.dot(radius), 2);
                across += 1 - std::pow(step.dot(radius), 2);
            }
        return across / along;
    };
    EXPECT_GT(spreadOf(radial), 1.5 * spreadOf({}));
}

}  // namespace
