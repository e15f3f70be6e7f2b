#include "core/clustering/wall_axes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/clustering/clusters.h"
#include "core/sampling/sampling_support.h"

namespace {

using namespace sherd;

const Vec3 size(1, 1, 0.2);
constexpr double spacing = 0.05;

Discretisation turnedSlab(const Mat3& turn) {
    TriangleMesh slab = shapes::slab(size, 4, 4, 2);
    for (Vec3& v : slab.vertices) v = turn * v;
    return sampled(slab, spacing);
}

bool nearRim(const Vec3& x) {
    return std::max(std::abs(x.x()), std::abs(x.y())) > 0.5 - 2 * spacing;
}

TEST(WallAxes, OfASlabGoThroughIt) {
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Discretisation solid = turnedSlab(turn);
    const std::vector<Vec3> axes = wallAxes(solid);
    int checked = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (nearRim(turn.transpose() * solid.particles[i].position)) continue;
        EXPECT_GT(std::abs(axes[i].dot(turn.col(2))), 0.99);
        ++checked;
    }
    EXPECT_GT(checked, 500);
}

TEST(WallAxes, AreNoneInTheCornersOfACube) {
    const Discretisation solid = sampled(shapes::slab({1, 1, 1}, 2, 2, 2), 0.1);
    const std::vector<Vec3> axes = wallAxes(solid);
    for (std::size_t i = 0; i < axes.size(); ++i)
        if (solid.particles[i].position.cwiseAbs().minCoeff() > 0.42) {
            EXPECT_TRUE(axes[i].isZero(0));
        }
}

// A slab that is damaged on one side, left of a line: the cluster reaches through to the other side, and no
// further to the right there.
TEST(WallAxes, LeadDamageStraightThroughAWall) {
    const Discretisation solid = turnedSlab(Mat3::Identity());
    Damage damage;
    damage.overstress.assign(solid.particles.size(), 0.5);
    for (const Particle& particle : solid.particles) {
        const Vec3& x = particle.position;
        damage.damaged.push_back(x.z() > 0.05 && x.x() < 0);
    }
    const FragmentLabels labels = clusterParticles(solid, damage, 1, size.z(), 1);
    ASSERT_EQ(labels.count, 2);
    for (std::size_t i = 0; i < solid.particles.size(); ++i) {
        const Vec3& x = solid.particles[i].position;
        if (nearRim(x) || std::abs(x.x()) < spacing) continue;
        EXPECT_EQ(labels.of_particle[i], x.x() < 0 ? 1 : 0) << x.transpose();
    }
}

}  // namespace
