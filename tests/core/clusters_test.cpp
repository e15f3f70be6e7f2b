#include "core/clustering/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

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
    return static_cast<long>(seen.size()) == std::count(labels.of_particle.begin(), labels.of_particle.end(), label);
}

TEST(Clusters, ADamagedBandLeavesTwoWholePartsAndItsClusters) {
    const Discretisation solid = sheet(20);
    const Damage damage = damageWhere(solid, [](const Vec3& x) { return x.x() > 7.5 && x.x() < 11.5; });
    const FragmentLabels labels = fragmentLabels(solid, damage, 5, 0, 3);
    EXPECT_EQ(labels.count, 7);
    EXPECT_EQ(labels.of_particle[0], labels.of_particle[20 * 19]);
    EXPECT_NE(labels.of_particle[0], labels.of_particle[19]);
    for (int l = 0; l < labels.count; ++l) EXPECT_TRUE(connected(solid, labels, l)) << l;
    EXPECT_GE(*std::min_element(labels.of_particle.begin(), labels.of_particle.end()), 0);
}

TEST(Clusters, SeedChangesTheClustersAndNothingElseDoes) {
    const Discretisation solid = sheet(16);
    const Damage damage = damageWhere(solid, [](const Vec3&) { return true; });
    const auto first = fragmentLabels(solid, damage, 6, 0, 1).of_particle;
    EXPECT_EQ(first, fragmentLabels(solid, damage, 6, 0, 1).of_particle);
    EXPECT_NE(first, fragmentLabels(solid, damage, 6, 0, 2).of_particle);
}

TEST(Clusters, DenserWhereTheStressIsHigher) {
    const Discretisation solid = sheet(40);
    Damage damage = damageWhere(solid, [](const Vec3&) { return true; });
    for (std::size_t i = 0; i < solid.particles.size(); ++i)
        damage.overstress[i] = solid.particles[i].position.x() < 20 ? 16 : 1;
    const FragmentLabels labels = fragmentLabels(solid, damage, 30, 0, 5);
    std::set<int> left, right;
    for (int i = 0; i < 1600; ++i) (i % 40 < 20 ? left : right).insert(labels.of_particle[i]);
    EXPECT_GT(left.size(), 2 * right.size());
}

TEST(Clusters, SpecksJoinWhatSurroundsThem) {
    const Discretisation solid = sheet(12);
    const Damage dots = damageWhere(solid, [](const Vec3& x) { return x.x() == 5 && (x.y() == 5 || x.y() == 6); });
    EXPECT_EQ(fragmentLabels(solid, dots, 4, 0, 1).count, 1);
    const Damage all_but_one = damageWhere(solid, [](const Vec3& x) { return !(x.x() == 5 && x.y() == 5); });
    EXPECT_EQ(fragmentLabels(solid, all_but_one, 4, 0, 1).count, 4);
}

TEST(Clusters, DamageReachesThroughTheWallAndNoFurther) {
    const Discretisation solid = sheet(20);
    const Damage damage = damageWhere(solid, [](const Vec3& x) { return x.x() < 2.5; });
    const auto labels = fragmentLabels(solid, damage, 1, 4, 1).of_particle;  // 0.75 walls of 4: three particles further
    EXPECT_EQ(labels[0], labels[5]);
    EXPECT_NE(labels[0], labels[6]);
}

TEST(Clusters, SeparateDamagedPartsGetSeedsEvenIfFewAreWanted) {
    const Discretisation solid = sheet(20);
    const Damage damage = damageWhere(solid, [](const Vec3& x) { return x.x() < 4 || x.x() > 15; });
    const FragmentLabels labels = fragmentLabels(solid, damage, 1, 0, 1);
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

}  // namespace
