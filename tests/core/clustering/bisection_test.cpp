#include "core/clustering/bisection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/clustering/crack_tree.h"
#include "core/clustering/wall_axes.h"
#include "core/clustering/way_out.h"
#include "core/stress/elasticity.h"

namespace {

using namespace sherd;

/// A sheet of n x n particles at distance 1, neighbours across edges, all damaged. `stress` says what acts at
/// x.
struct Sheet {
    template <class Stress>
    Sheet(int n, const Stress& stress) {
        solid.spacing = 1;
        solid.facing.assign(n * n, Vec3::UnitZ() * Vec3::UnitZ().transpose());
        solid.neighbours.resize(n * n);
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const int i = y * n + x;
                solid.particles.push_back({Vec3(x, y, 0), 1, 1});
                solid.cells.push_back({{}, i});
                if (y > 0) solid.faces.push_back({{i - n, i}, Vec3::UnitY(), Vec3(x, y - 0.5, 0)});
                if (x > 0) solid.faces.push_back({{i - 1, i}, Vec3::UnitX(), Vec3(x - 0.5, y, 0)});
                if (y > 0) solid.neighbours[i].push_back(i - n);
                if (x > 0) solid.neighbours[i].push_back(i - 1);
                if (x + 1 < n) solid.neighbours[i].push_back(i + 1);
                if (y + 1 < n) solid.neighbours[i].push_back(i + n);
                damage.damaged.push_back(1);
                damage.overstress.push_back(2);
                damage.stress.push_back(toSymmetricTensor(stress(solid.particles.back().position)));
            }
        damage.count = n * n;
    }
    FragmentLabels labels(int clusters, std::uint64_t seed = 1, const GuideField& guide = {},
                          const BlowAxis& blow = {},
                          double affordable_m2 = std::numeric_limits<double>::infinity()) const {
        return bisectParticles(solid, wallAxes(solid), damage, clusters, 1000, 1, seed, {}, {}, guide, blow,
                               affordable_m2);
    }
    /// Calls visit(middle, normal) for neighbours that a crack parts; `normal` is the crack's.
    template <class Visit>
    void forEachCrack(const FragmentLabels& labels, const Visit& visit) const {
        for (std::size_t i = 0; i < solid.neighbours.size(); ++i)
            for (const int j : solid.neighbours[i]) {
                if (labels.part[i] == labels.part[j]) continue;
                const Vec3 middle = 0.5 * (solid.particles[i].position + solid.particles[j].position);
                const auto lead = [&](const Vec3& x) {
                    return labels.cracks->lead(labels.part[i], labels.part[j], x);
                };
                Vec3 normal;
                for (int d = 0; d < 3; ++d) normal[d] = lead(middle + Vec3::Unit(d)) - lead(middle);
                visit(middle, normal);
            }
    }

    Discretisation solid;
    Damage damage;
};

Mat3 tensionAlong(const Vec3& direction) {
    return 1e6 * direction * direction.transpose();
}

TEST(Bisection, CracksAreAtRightAnglesToTheTension) {
    for (const double angle : {0.0, 0.4, 1.2}) {
        const Vec3 tension(std::cos(angle), std::sin(angle), 0);
        const Sheet sheet(30, [&](const Vec3&) { return tensionAlong(tension); });
        for (const std::uint64_t seed : {1, 2, 3})
            sheet.forEachCrack(sheet.labels(6, seed), [&](const Vec3&, const Vec3& normal) {
                EXPECT_NEAR(normal.norm(), 1, 1e-9);
                EXPECT_GT(std::abs(normal.dot(tension)), std::cos(0.2)) << angle;
            });
    }
}

// A crack through the sheet, which is 30 wide, takes 30 at least.
TEST(Bisection, CracksEndWhereTheAreaIsSpent) {
    const Vec3 tension(std::cos(0.3), std::sin(0.3), 0);
    const Sheet sheet(30, [&](const Vec3&) { return tensionAlong(tension); });
    EXPECT_EQ(sheet.labels(6).count, 6);
    int before = 1;
    for (const double affordable_m2 : {29.0, 34.0, 80.0, 1000.0}) {
        const int count = sheet.labels(6, 1, {}, {}, affordable_m2).count;
        EXPECT_GE(count, before);
        EXPECT_LE(29 * (count - 1), affordable_m2);
        before = count;
        EXPECT_EQ(count == 1, affordable_m2 < 30);
    }
    EXPECT_EQ(before, 6);
}

// Tension all around a point, as in a pane that is struck there: cracks run away from it.
TEST(Bisection, TensionAroundTheBlowMakesRadialCracks) {
    BlowAxis blow;
    blow.contact = Vec3(20, 20, 0);
    blow.direction = Vec3::UnitZ();
    blow.radius_m = 1;
    const Sheet sheet(41, [&](const Vec3& x) {
        const Vec3 around = Vec3::UnitZ().cross(x - blow.contact);
        return tensionAlong(around.isZero(0) ? Vec3::UnitX().eval() : around.normalized());
    });
    double radial = 0, all = 0;
    for (const std::uint64_t seed : {1, 2, 3})
        sheet.forEachCrack(sheet.labels(16, seed, {}, blow), [&](const Vec3& x, const Vec3& normal) {
            ++all;
            radial += std::abs(normal.dot((x - blow.contact).normalized())) < std::sin(20 * 3.14159265 / 180);
        });
    EXPECT_GT(radial / all, 0.8) << "of " << all;
}

TEST(Bisection, EveryParticleIsOnItsSideOfAllCracksAndPiecesAreConnected) {
    const Sheet sheet(30, [](const Vec3& x) { return tensionAlong(Vec3(1, x.y() / 30, 0).normalized()); });
    const FragmentLabels labels = sheet.labels(12);
    EXPECT_EQ(labels.count, 12);
    std::set<int> used(labels.of_particle.begin(), labels.of_particle.end());
    EXPECT_EQ(used.size(), 12u);
    for (int i = 0; i < 900; ++i)
        for (int j = 0; j < 900; j += 7) {
            if (labels.part[i] == labels.part[j]) continue;
            const Vec3& x = sheet.solid.particles[i].position;
            EXPECT_GE(labels.cracks->lead(labels.part[i], labels.part[j], x), 0);
        }
}

TEST(Bisection, PiecesGrowWithTheDistanceFromTheBlow) {
    BlowAxis blow;
    blow.contact = Vec3(20, 20, 0);
    blow.direction = Vec3::UnitZ();
    const Sheet sheet(41, [](const Vec3&) {
        return Mat3(1e6 *
                    (Vec3::UnitX() * Vec3::UnitX().transpose() + Vec3::UnitY() * Vec3::UnitY().transpose()));
    });
    const FragmentLabels labels = sheet.labels(24, 1, {}, blow);
    std::vector<int> sizes(labels.count);
    for (const int label : labels.of_particle) ++sizes[label];
    double near = 0, far = 0, near_count = 0, far_count = 0;
    for (int i = 0; i < 41 * 41; ++i) {
        const double r = (sheet.solid.particles[i].position - blow.contact).norm();
        if (r < 4) near += sizes[labels.of_particle[i]], ++near_count;
        if (r > 16) far += sizes[labels.of_particle[i]], ++far_count;
    }
    EXPECT_GT(far / far_count, 3 * near / near_count);
}

TEST(Bisection, PiecesAreLongAlongAGuide) {
    const Sheet sheet(40, [](const Vec3&) { return Mat3(1e6 * Mat3::Identity()); });
    GuideField grain;
    grain.kind = GuideField::Kind::constant;
    for (const double angle : {0.0, 0.5}) {
        grain.direction = Vec3(std::cos(angle), std::sin(angle), 0);
        double along = 0, across = 0;
        sheet.forEachCrack(sheet.labels(16, 1, grain), [&](const Vec3&, const Vec3& normal) {
            ++(std::abs(normal.dot(grain.direction)) < 0.5 ? along : across);
        });
        EXPECT_GT(along, 2.5 * across) << angle;
    }
}

TEST(Bisection, AnotherSeedMakesOtherCracksAndNothingElseDoes) {
    const Sheet sheet(20, [](const Vec3&) { return Mat3(1e6 * Mat3::Identity()); });
    EXPECT_EQ(sheet.labels(8, 1).of_particle, sheet.labels(8, 1).of_particle);
    EXPECT_NE(sheet.labels(8, 1).of_particle, sheet.labels(8, 2).of_particle);
}

// Two sheets with a gap between them; only one of them is damaged.
TEST(Bisection, WhatIsNotConnectedIsOnePieceMore) {
    Sheet sheet(20, [](const Vec3&) { return tensionAlong(Vec3::UnitX()); });
    for (int y = 0; y < 20; ++y)
        for (const int x : {9, 10}) {
            auto& of = sheet.solid.neighbours[y * 20 + x];
            of.erase(std::remove(of.begin(), of.end(), y * 20 + 19 - x), of.end());
        }
    for (int i = 0; i < 400; ++i)
        if (i % 20 >= 10) sheet.damage.damaged[i] = 0, sheet.damage.overstress[i] = 0;
    const FragmentLabels labels = sheet.labels(3);
    EXPECT_EQ(labels.count, 4);
    std::set<int> whole;
    for (int i = 0; i < 400; ++i)
        if (i % 20 >= 10) whole.insert(labels.of_particle[i]);
    EXPECT_EQ(whole.size(), 1u);
}

TEST(Bisection, WithoutDamageThereIsOnePiece) {
    Sheet sheet(10, [](const Vec3&) { return Mat3(Mat3::Zero()); });
    std::fill(sheet.damage.damaged.begin(), sheet.damage.damaged.end(), 0);
    EXPECT_EQ(sheet.labels(5).count, 1);
}

TEST(WayOut, IsThereUnlessCracksCloseInFromAllSides) {
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    EXPECT_TRUE(hasWayOut({}));
    EXPECT_TRUE(hasWayOut({x, -x, y, -y})) << "along a wall";
    EXPECT_TRUE(hasWayOut({x, -x, y, -y, z})) << "into the open";
    EXPECT_FALSE(hasWayOut({x, -x, y, -y, z, -z}));
    EXPECT_FALSE(hasWayOut({x, -x, Vec3(0.5, 1, 0.5).normalized(), Vec3(0, -1, 0.6).normalized(), -z, y}));
}

TEST(CrackTree, KnowsWhichPlaneSeparatesTwoParts) {
    CrackTree tree;
    const int root = tree.addRoot(), below = tree.cut(root, {Vec3::UnitX(), 1}), above = below + 1;
    const int low = tree.cut(above, {Vec3::UnitY(), 2}), high = low + 1;
    const Vec3 x(4, 7, 0);
    EXPECT_EQ(tree.lead(below, low, x), -3);
    EXPECT_EQ(tree.lead(high, below, x), 3);
    EXPECT_EQ(tree.lead(high, low, x), 5);
    const int one = tree.addPiece(low), other = tree.addPiece(low);
    EXPECT_TRUE(std::isnan(tree.lead(one, other, x)));
    EXPECT_EQ(tree.lead(one, high, x), -5);
}

}  // namespace
