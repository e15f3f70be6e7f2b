// Bodies cut along the planes of the cracks that a stress makes.
#include "geometry/cutting/plane_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "core/clustering/bisection.h"
#include "core/clustering/wall_axes.h"
#include "core/numerics/mesh_measures.h"
#include "core/sampling/sample_solid.h"
#include "core/stress/elasticity.h"
#include "geometry/cutting/cut_checks.h"
#include "geometry/cutting/cut_fragments.h"
#include "geometry/cutting/fragment_support.h"
#include "geometry/cutting/swept_bodies.h"
#include "geometry/surface_checks.h"

namespace sherd {
namespace {

using namespace fragment_support;

TriangleMesh brick() {
    return shapes::slab({0.24, 0.11, 0.07});
}

TriangleMesh ball() {
    return shapes::icosphere(0.5, 3);
}

TriangleMesh hollowBall() {
    return shapes::hollowSphere(0.5, 0.4, 3);
}

TriangleMesh twoLegs() {
    return shapes::uShape(0.1, 0.03, 0.6, 0.4);
}

/// Tension in random directions about a random particle, falling off with the distance from it.
Damage damageAbout(const Discretisation& solid, double size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    const Vec3 centre = solid.particles[random() % solid.particles.size()].position;
    const Vec3 axis = Vec3(any(random), any(random), any(random)).normalized();
    Damage damage;
    for (const Particle& particle : solid.particles) {
        const Vec3 away = particle.position - centre;
        const Vec3 tension = axis.cross(away + 1e-3 * size * Vec3::Ones()).normalized();
        const double overstress = 4 * std::exp(-2 * away.norm() / size);
        damage.overstress.push_back(overstress);
        damage.damaged.push_back(overstress > 1);
        damage.stress.push_back(toSymmetricTensor(Mat3(overstress * tension * tension.transpose())));
    }
    damage.count =
        static_cast<int>(std::count(damage.damaged.begin(), damage.damaged.end(), static_cast<char>(1)));
    return damage;
}

FragmentLabels labelsOf(const TriangleMesh& mesh, const Discretisation& solid, int pieces, unsigned seed) {
    const double size = boundingBox(mesh.vertices).sizes().maxCoeff();
    return bisectParticles(solid, wallAxes(solid), damageAbout(solid, size, seed), pieces, 1000,
                           wallThickness(mesh), seed);
}

class PlaneCutsOf : public testing::TestWithParam<SweptBody> {};

// Each piece is a closed surface without self-intersection, the volumes add up, and both sides of a crack
// have the same triangles.
TEST_P(PlaneCutsOf, AreCleanOverManySeeds) {
    constexpr unsigned seeds = 20;
    const TriangleMesh mesh = GetParam().mesh();
    const auto sampled = sampleSolid(mesh, GetParam().spacing, {});
    ASSERT_TRUE(sampled) << sampled.error();
    const Discretisation& solid = sampled.value();
    const CuttableSurface surface(mesh);
    std::size_t pieces = 0, labelled = 0, by_planes = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const FragmentLabels labels = labelsOf(mesh, solid, 6 + static_cast<int>(2 * seed), seed);
        ASSERT_TRUE(arePlanesEnough(labels));
        by_planes += cutByPlanes(surface, solid, labels).has_value();
        const auto cut = cutFragments(mesh, solid, labels, {seed});
        ASSERT_TRUE(cut) << cut.error();
        EXPECT_EQ(faultOfCut(mesh, cut.value()), "") << "seed " << seed;
        pieces += cut.value().pieces.size();
        labelled += static_cast<std::size_t>(labels.count);
    }
    std::cout << solid.particles.size() << " particles, " << pieces << " pieces of " << labelled
              << " labels, " << by_planes << " of " << seeds << " cut by planes\n";
    EXPECT_EQ(by_planes, seeds);
}

INSTANTIATE_TEST_SUITE_P(Bodies, PlaneCutsOf,
                         testing::Values(SweptBody{"plate", plate, 1 / 22.0},
                                         SweptBody{"brick", brick, 0.012}, SweptBody{"ball", ball, 0.1},
                                         SweptBody{"hollow_ball", hollowBall, 0.08},
                                         SweptBody{"two_legs", twoLegs, 0.03},
                                         SweptBody{"cup", coffeeCup, 0.004},
                                         SweptBody{"bowl", thinBowl, 0.005}),
                         [](const auto& info) { return info.param.name; });

// The tree's second plane lies outside of the body: the part has particles on one side of it only.
TEST(PlaneCuts, APlaneBesideABodyCutsNothing) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1}, 2, 2, 2);
    const Discretisation solid = particlesOnly(mesh, 0.25);
    auto tree = std::make_shared<CrackTree>();
    const int below = tree->cut(tree->addRoot(), {Vec3::UnitX(), 0.03});
    tree->cut(below, {Vec3::UnitX(), -5});
    FragmentLabels labels;
    labels.count = 2;
    labels.cracks = tree;
    for (const Particle& particle : solid.particles) {
        const bool is_above = particle.position.x() > 0.03;
        labels.of_particle.push_back(is_above);
        labels.part.push_back(is_above ? below + 1 : tree->below(below) + 1);
    }
    const auto cut = cutFragments(mesh, solid, labels, {});
    ASSERT_TRUE(cut) << cut.error();
    EXPECT_EQ(faultOfCut(mesh, cut.value()), "");
    EXPECT_EQ(cut.value().pieces.size(), 2u);
    EXPECT_TRUE(cutByPlanes(CuttableSurface(mesh), solid, labels));
}

}  // namespace
}  // namespace sherd
