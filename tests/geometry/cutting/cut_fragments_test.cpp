#include "geometry/cutting/cut_fragments.h"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "core/sampling/sample_solid.h"
#include "geometry/cutting/cut_checks.h"
#include "geometry/cutting/fragment_support.h"
#include "geometry/cutting/particle_weights.h"
#include "geometry/mass_properties.h"
#include "support/piece_checks.h"
#include "support/shapes.h"

namespace sherd {
namespace {

using namespace fragment_support;

const double pi = std::acos(-1.0);

FragmentSurfaces cut(const TriangleMesh& mesh, const Discretisation& solid, const FragmentLabels& labels,
                     const CutSettings& settings = {}) {
    auto result = cutFragments(mesh, solid, labels, settings);
    EXPECT_TRUE(result) << result.error();
    return result ? std::move(result).value() : FragmentSurfaces();
}

FragmentLabels labelled(const Discretisation& solid, int count,
                        const std::function<int(const Vec3&)>& label_at) {
    FragmentLabels labels;
    labels.count = count;
    for (const Particle& p : solid.particles) labels.of_particle.push_back(label_at(p.position));
    return labels;
}

double volumeOf(const FragmentSurfaces& fragments) {
    double sum = 0;
    for (const auto& piece : fragments.pieces) sum += solidMoments(piece.mesh).volume;
    return sum;
}

Vec3 areaVector(const TriangleMesh& mesh, int t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]) / 2;
}

// The parts of every triangle of the body cover it, keep its direction, and are the triangle itself where
// nothing cut it.
void expectParentsCovered(const TriangleMesh& body, const FragmentSurfaces& fragments) {
    std::vector<double> covered(body.triangles.size(), 0);
    for (const FragmentSurface& piece : fragments.pieces)
        for (int t = 0; t < static_cast<int>(piece.parents.size()); ++t) {
            const int parent = piece.parents[t];
            if (parent < 0) continue;
            const Vec3 normal = areaVector(body, parent).normalized();
            covered[parent] += areaVector(piece.mesh, t).dot(normal);
            for (int v : piece.mesh.triangles[t])
                EXPECT_NEAR((piece.mesh.vertices[v] - body.vertices[body.triangles[parent][0]]).dot(normal),
                            0, 1e-12);
        }
    for (std::size_t t = 0; t < covered.size(); ++t) {
        const double area = areaVector(body, static_cast<int>(t)).norm();
        EXPECT_NEAR(covered[t], area, 1e-9 * area);
    }
}

struct Shape {
    const char* name;
    TriangleMesh mesh;
    double spacing;
};

TriangleMesh torus() {
    std::vector<std::pair<double, double>> ring;
    for (int i = 0; i < 16; ++i)
        ring.emplace_back(0.5 + 0.15 * std::cos(i * pi / 8), 0.15 * std::sin(i * pi / 8));
    return shapes::revolved(ring, 40);
}

std::vector<Shape> testShapes() {
    return {{"box", shapes::slab({1, 1, 1}), 0.13},
            {"plate", shapes::slab({1, 1, 0.09}, 24, 24, 3), 1 / 22.0},
            {"sphere", shapes::icosphere(0.5, 3), 0.12},
            {"hollow_sphere", shapes::hollowSphere(0.5, 0.4, 3), 0.1},
            {"tube", shapes::tube(0.5, 0.4, 1, 40), 0.1},
            {"cup", shapes::cup(0.5, 1, 0.08, 40, 14), 0.1},
            {"torus", torus(), 0.1},
            {"two_legs", shapes::uShape(0.1, 0.03, 0.6, 0.4), 0.05}};
}

class FragmentsOf : public testing::TestWithParam<Shape> {};

TEST_P(FragmentsOf, AreCleanOverManySeeds) {
    const TriangleMesh& mesh = GetParam().mesh;
    const Discretisation solid = particlesOnly(mesh, GetParam().spacing);
    const double volume = solidMoments(mesh).volume;
    const int counts[] = {2, 3, 5, 9, 17, 40};
    int checked = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const FragmentLabels labels = randomClusters(solid, counts[seed % 6], seed);
        const FragmentSurfaces fragments = cut(mesh, solid, labels, {seed});
        // A label may lose its piece where its only particle fills next to nothing of the wall.
        EXPECT_GE(static_cast<int>(fragments.pieces.size()), labels.count - labels.count / 20);
        EXPECT_NEAR(volumeOf(fragments), volume, 1e-9 * volume);
        EXPECT_TRUE(fragments.notes.empty());
        EXPECT_EQ(faultOfCut(mesh, fragments), "") << "seed " << seed;
        for (const FragmentSurface& piece : fragments.pieces)
            EXPECT_EQ(piece.mesh.kinds.size(), piece.mesh.triangles.size());
        checked += static_cast<int>(fragments.pieces.size());
    }
    RecordProperty("pieces_checked", checked);
    std::cout << checked << " pieces checked\n";
}

TEST_P(FragmentsOf, CoverTheSurface) {
    const TriangleMesh& mesh = GetParam().mesh;
    const Discretisation solid = particlesOnly(mesh, GetParam().spacing);
    const FragmentSurfaces fragments = cut(mesh, solid, randomClusters(solid, 12, 4), {4});
    expectParentsCovered(mesh, fragments);
}

INSTANTIATE_TEST_SUITE_P(Shapes, FragmentsOf, testing::ValuesIn(testShapes()),
                         [](const auto& info) { return info.param.name; });

// Labels without any order: points where four fragments meet everywhere, strays, islands.
TEST(FragmentSurfaces, StandLabelsWithoutOrder) {
    const TriangleMesh mesh = shapes::hollowSphere(0.5, 0.4, 3);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    std::mt19937 random(5);
    const FragmentLabels labels =
        labelled(solid, 6, [&](const Vec3&) { return static_cast<int>(random() % 6); });
    const FragmentSurfaces fragments = cut(mesh, solid, labels);
    const double volume = solidMoments(mesh).volume;
    EXPECT_NEAR(volumeOf(fragments), volume, 1e-9 * volume);
    EXPECT_EQ(faultOfCut(mesh, fragments), "");
}

TEST(FragmentSurfaces, AtMostAsManyAsAreWanted) {
    const TriangleMesh mesh = shapes::hollowSphere(0.5, 0.4, 3);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    std::mt19937 random(5);
    const FragmentLabels labels =
        labelled(solid, 40, [&](const Vec3&) { return static_cast<int>(random() % 40); });
    CutSettings settings;
    const std::size_t unlimited = cut(mesh, solid, labels, settings).pieces.size();
    for (const int most : {20, 7, 2}) {
        settings.pieces.most = most;
        ASSERT_GT(unlimited, static_cast<std::size_t>(most));
        const FragmentSurfaces fragments = cut(mesh, solid, labels, settings);
        EXPECT_EQ(static_cast<int>(fragments.pieces.size()), most);
        const double volume = solidMoments(mesh).volume;
        EXPECT_NEAR(volumeOf(fragments), volume, 1e-9 * volume);
        EXPECT_EQ(faultOfCut(mesh, fragments), "");
    }
}

// What is kept of a surface serves any number of cuts.
TEST(FragmentSurfaces, AreThoseOfANewSurfaceIfItWasCutBefore) {
    const TriangleMesh mesh = shapes::slab({1, 1, 0.09}, 24, 24, 3);
    const Discretisation solid = particlesOnly(mesh, 1 / 22.0);
    const CuttableSolid kept(mesh, solid);
    for (unsigned seed = 0; seed < 3; ++seed) {
        const FragmentLabels labels = randomClusters(solid, 8, seed);
        const auto again = cutFragments(kept, solid, labels, {seed});
        ASSERT_TRUE(again) << again.error();
        const FragmentSurfaces fresh = cut(mesh, solid, labels, {seed});
        ASSERT_EQ(again.value().pieces.size(), fresh.pieces.size());
        for (std::size_t p = 0; p < fresh.pieces.size(); ++p) {
            EXPECT_EQ(again.value().pieces[p].mesh.triangles, fresh.pieces[p].mesh.triangles);
            EXPECT_EQ(again.value().pieces[p].mesh.vertices, fresh.pieces[p].mesh.vertices);
        }
    }
}

// Fragments of fragments: what comes out is valid input.
TEST(FragmentSurfaces, CanBeCutAgain) {
    int checked = 0;
    const TriangleMesh mesh = shapes::slab({1, 1, 0.09}, 24, 24, 3);
    const Discretisation solid = particlesOnly(mesh, 1 / 22.0);
    for (unsigned seed = 0; seed < 3; ++seed)
        for (const FragmentSurface& parent :
             cut(mesh, solid, randomClusters(solid, 8, seed), {seed}).pieces) {
            const Discretisation parent_solid = particlesOnly(parent.mesh, 0.03);
            const auto fragments =
                cut(parent.mesh, parent_solid, randomClusters(parent_solid, 5, seed), {seed});
            const double volume = solidMoments(parent.mesh).volume;
            EXPECT_NEAR(volumeOf(fragments), volume, 1e-9 * volume);
            for (const FragmentSurface& piece : fragments.pieces) {
                EXPECT_EQ(faultOf(piece.mesh), "");
                for (std::size_t t = 0; t < piece.parents.size(); ++t)
                    EXPECT_EQ(piece.mesh.kinds[t], piece.parents[t] < 0
                                                       ? SurfaceKind::crack
                                                       : parent.mesh.kinds[piece.parents[t]]);
                ++checked;
            }
        }
    std::cout << checked << " pieces checked\n";
}

// The real thing, three generations deep: the cup, cut cells, fragments of fragments of fragments.
TEST(FragmentSurfaces, OfTheCupAreCleanForThreeGenerations) {
    auto cup = readObj(SHERD_ASSETS "/coffee_cup.obj");
    ASSERT_TRUE(cup) << cup.error();
    std::vector<TriangleMesh> generation = {cup.value()};
    int checked = 0;
    for (const int count : {6, 4, 3}) {
        std::vector<TriangleMesh> next;
        for (const TriangleMesh& parent : generation) {
            const auto solid = sampleSolid(parent, 0.004, {});
            ASSERT_TRUE(solid) << solid.error();
            if (solid.value().particles.size() < 12) continue;
            const FragmentSurfaces fragments =
                cut(parent, solid.value(), randomClusters(solid.value(), count, 3));
            const double volume = solidMoments(parent).volume;
            EXPECT_NEAR(volumeOf(fragments), volume, 1e-9 * volume);
            for (const FragmentSurface& piece : fragments.pieces) {
                EXPECT_EQ(faultOf(piece.mesh), "");
                next.push_back(piece.mesh);
                ++checked;
            }
        }
        generation = next;
    }
    EXPECT_GE(checked, 6 + 6 * 4);
    std::cout << checked << " pieces checked\n";
}

// Two halves: the crack is the plane between them, up to the irregularity that is wanted.
TEST(FragmentSurfaces, RunHalfwayBetweenTwoLabels) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1}, 4, 4, 4);
    const double h = 0.1;
    const Discretisation solid = particlesOnly(mesh, h);
    const auto fragments = cut(mesh, solid, labelled(solid, 2, [](const Vec3& x) { return x.x() > 0; }));
    ASSERT_EQ(fragments.pieces.size(), 2u);
    for (const FragmentSurface& piece : fragments.pieces) {
        EXPECT_NEAR(solidMoments(piece.mesh).volume, 0.5, 0.01);
        double area = 0;
        for (std::size_t t = 0; t < piece.parents.size(); ++t) {
            if (piece.parents[t] >= 0) continue;
            area += areaVector(piece.mesh, static_cast<int>(t)).norm();
            for (int v : piece.mesh.triangles[t]) EXPECT_NEAR(piece.mesh.vertices[v].x(), 0, 0.25 * h);
        }
        EXPECT_NEAR(area, 1, 0.05);
    }
}

// With distances from seeds the crack lies where both are equally near, also between two rows of particles.
TEST(FragmentSurfaces, LieWhereTwoSeedsAreEquallyNear) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1}, 4, 4, 4);
    const double h = 0.1, middle = 0.03;
    const Discretisation solid = particlesOnly(mesh, h);
    FragmentLabels labels = labelled(solid, 2, [&](const Vec3& x) { return x.x() > middle; });
    labels.distance = [](const Vec3& seed, const Vec3& x) { return (seed - x).norm(); };
    labels.seeds = {Vec3(middle - 0.3, 0, 0), Vec3(middle + 0.3, 0, 0)};
    labels.cluster = labels.of_particle;
    const auto fragments = cut(mesh, solid, labels);
    ASSERT_EQ(fragments.pieces.size(), 2u);
    double sum = 0;
    int count = 0;
    for (std::size_t t = 0; t < fragments.pieces[0].parents.size(); ++t) {
        if (fragments.pieces[0].parents[t] >= 0) continue;
        for (int v : fragments.pieces[0].mesh.triangles[t]) {
            const double x = fragments.pieces[0].mesh.vertices[v].x();
            EXPECT_NEAR(x, middle, 0.25 * h);  // points keep off the nodes of the lattice
            sum += x, ++count;
        }
    }
    EXPECT_NEAR(sum / count, middle, 0.1 * h);
}

// Crack planes: the second ends at the first, and all faces lie in one of the two.
TEST(FragmentSurfaces, LieInCrackPlanes) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1}, 4, 4, 4);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const CrackPlane first{Vec3(1, 0.5, 0.2).normalized(), 0.03},
        second{Vec3(-0.3, 1, 0.4).normalized(), -0.02};
    auto tree = std::make_shared<CrackTree>();
    const int below = tree->cut(tree->addRoot(), first), low = tree->cut(below + 1, second);
    FragmentLabels labels = labelled(solid, 3, [&](const Vec3& x) {
        return first.distance(x) < 0 ? 0 : second.distance(x) < 0 ? 1 : 2;
    });
    labels.cracks = tree;
    for (const int label : labels.of_particle) labels.part.push_back(std::array{below, low, low + 1}[label]);
    const auto fragments = cut(mesh, solid, labels);
    ASSERT_EQ(fragments.pieces.size(), 3u);
    double inside = 0, off = 0;
    for (const FragmentSurface& piece : fragments.pieces)
        for (std::size_t t = 0; t < piece.parents.size(); ++t) {
            if (piece.parents[t] >= 0) continue;
            const Vec3 area = areaVector(piece.mesh, static_cast<int>(t));
            const bool is_of_first = piece.label == 0 || fragments.pieces[piece.across[t]].label == 0;
            off += area.norm() - std::abs(area.dot((is_of_first ? first : second).normal));
            inside += area.norm();
        }
    EXPECT_LT(off / inside, 0.005);
}

// Clusters across the diagonal of the particle grid: a plane, halfway between the rows x + y = 0 and 0.1, not
// a staircase, whose area would be larger by sqrt(2).
TEST(FragmentSurfaces, AreNoStaircases) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1}, 4, 4, 4);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const auto fragments =
        cut(mesh, solid, labelled(solid, 2, [](const Vec3& x) { return x.x() + x.y() > 0.03; }));
    ASSERT_EQ(fragments.pieces.size(), 2u);
    double area = 0;
    for (std::size_t t = 0; t < fragments.pieces[0].parents.size(); ++t)
        if (fragments.pieces[0].parents[t] < 0)
            area += areaVector(fragments.pieces[0].mesh, static_cast<int>(t)).norm();
    EXPECT_NEAR(area, std::sqrt(2.0) * 0.95, 0.06);
}

TEST(FragmentSurfaces, KeepFragmentsOfOneParticle) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1});
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const auto alone = static_cast<int>(solid.particles.size() / 2 + 5);
    FragmentLabels labels = labelled(solid, 2, [](const Vec3&) { return 0; });
    labels.of_particle[alone] = 1;
    const auto fragments = cut(mesh, solid, labels);
    ASSERT_EQ(fragments.pieces.size(), 2u);
    const auto& small = fragments.pieces[fragments.pieces[0].label == 1 ? 0 : 1];
    const Moments moments = solidMoments(small.mesh);
    EXPECT_GT(moments.volume, 0.3e-3);
    EXPECT_LT(moments.volume, 2e-3);
    EXPECT_LT((moments.centroid - solid.particles[alone].position).norm(), 0.02);
}

// A fragment inside another: the outer one has a cavity, made of crack faces alone.
TEST(FragmentSurfaces, MayLieInsideEachOther) {
    const TriangleMesh mesh = shapes::slab({1, 1, 1}, 3, 3, 3);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const auto fragments =
        cut(mesh, solid, labelled(solid, 2, [](const Vec3& x) { return x.norm() < 0.25; }));
    ASSERT_EQ(fragments.pieces.size(), 2u);
    for (const FragmentSurface& piece : fragments.pieces) {
        EXPECT_EQ(faultOf(piece.mesh), "");
        const double core = 56e-3;  // as many particles; smoothing takes a part of so small a ball
        EXPECT_NEAR(solidMoments(piece.mesh).volume, piece.label == 1 ? core : 1 - core, 0.25 * core);
    }
}

TEST(FragmentSurfaces, KeepACavityThatNoCrackTouches) {
    const TriangleMesh mesh =
        shapes::joined(shapes::slab({2, 1, 1}),
                       shapes::inverted(shapes::translated(shapes::icosphere(0.2, 2), {0.5, 0, 0})));
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const auto fragments = cut(mesh, solid, labelled(solid, 2, [](const Vec3& x) { return x.x() > 0; }));
    ASSERT_EQ(fragments.pieces.size(), 2u);
    const double bubble = -solidMoments(shapes::inverted(shapes::icosphere(0.2, 2))).volume;
    for (const FragmentSurface& piece : fragments.pieces) {
        EXPECT_EQ(faultOf(piece.mesh), "");
        EXPECT_NEAR(solidMoments(piece.mesh).volume, piece.label == 1 ? 1 - bubble : 1, 0.01);
    }
}

// Without any crack the surface comes back as it is, part by part.
TEST(FragmentSurfaces, AreThePartsOfTheSurfaceWhereNothingCracks) {
    const TriangleMesh left = shapes::slab({1, 1, 1}, 2, 2, 2),
                       mesh = shapes::joined(left, shapes::translated(left, {3, 0, 0}));
    const Discretisation solid = particlesOnly(mesh, 0.2);
    for (int count : {1, 2}) {
        const auto fragments = cut(
            mesh, solid, labelled(solid, count, [&](const Vec3& x) { return count == 2 && x.x() > 1.5; }));
        ASSERT_EQ(fragments.pieces.size(), 2u);
        EXPECT_EQ(fragments.pieces[1].label, count - 1);
        const TriangleMesh& part = fragments.pieces[0].mesh;
        ASSERT_EQ(part.triangles.size(), left.triangles.size());
        for (int t = 0; t < static_cast<int>(part.triangles.size()); ++t)
            EXPECT_EQ(cornersOf(part, t, false), cornersOf(left, t, false));
    }
}

// Two legs a third of a spacing apart, and a foot: labels do not reach through the gap.
TEST(FragmentSurfaces, DoNotReachAcrossGaps) {
    const TriangleMesh mesh = shapes::uShape(0.1, 0.015, 0.6, 0.2);
    const Discretisation solid = particlesOnly(mesh, 0.05);
    const auto fragments = cut(mesh, solid, labelled(solid, 4, [](const Vec3& x) {
                                   return (x.x() > 0.107) + 2 * (x.z() > 0.3 + 0.1 * (x.x() > 0.107));
                               }));
    ASSERT_EQ(fragments.pieces.size(), 4u);
    for (const FragmentSurface& piece : fragments.pieces) {
        const double upper = piece.label == 2 ? 0.3 : 0.2;
        if (piece.label >= 2) {
            EXPECT_NEAR(solidMoments(piece.mesh).volume, 0.1 * 0.2 * upper, 0.1 * 0.1 * 0.2 * upper);
        }
    }
}

TEST(FragmentSurfaces, AreTheSameForTheSameSeedOnly) {
    const TriangleMesh mesh = shapes::icosphere(0.5, 3);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const FragmentLabels labels = randomClusters(solid, 6, 1);
    const auto a = cut(mesh, solid, labels, {7}), b = cut(mesh, solid, labels, {7}),
               c = cut(mesh, solid, labels, {8});
    ASSERT_EQ(a.pieces.size(), b.pieces.size());
    for (std::size_t p = 0; p < a.pieces.size(); ++p) {
        EXPECT_EQ(a.pieces[p].mesh.vertices, b.pieces[p].mesh.vertices);
        EXPECT_EQ(a.pieces[p].mesh.triangles, b.pieces[p].mesh.triangles);
    }
    EXPECT_NE(a.pieces[0].mesh.vertices, c.pieces[0].mesh.vertices);
}

// Programs that trap floating-point exceptions break things too.
TEST(FragmentSurfaces, DivideNothingByZero) {
    const TriangleMesh mesh = shapes::icosphere(0.5, 3);
    const Discretisation solid = particlesOnly(mesh, 0.1);
    const FragmentLabels labels = randomClusters(solid, 6, 1);
    std::feclearexcept(FE_DIVBYZERO);
    particleWeights(solid, reachOfParticles(solid), labels);
    EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO));
}

// A power of two changes no digit, so there is no length hidden anywhere.
TEST(FragmentSurfaces, ScaleWithTheBody) {
    TriangleMesh mesh = shapes::icosphere(0.5, 3);
    Discretisation solid = particlesOnly(mesh, 0.125);
    const FragmentLabels labels = randomClusters(solid, 6, 1);
    const auto large = cut(mesh, solid, labels);
    const double scale = std::ldexp(1.0, -10);
    for (Vec3& v : mesh.vertices) v *= scale;
    solid.spacing *= scale;
    for (Particle& p : solid.particles)
        p.position *= scale, p.spacing *= scale, p.volume *= scale * scale * scale;
    const auto small = cut(mesh, solid, labels);
    ASSERT_EQ(small.pieces.size(), large.pieces.size());
    for (std::size_t p = 0; p < small.pieces.size(); ++p) {
        EXPECT_EQ(small.pieces[p].mesh.triangles, large.pieces[p].mesh.triangles);
        for (std::size_t v = 0; v < small.pieces[p].mesh.vertices.size(); ++v)
            EXPECT_EQ(small.pieces[p].mesh.vertices[v], Vec3(scale * large.pieces[p].mesh.vertices[v]));
    }
}

TEST(FragmentSurfaces, StandFarFromTheOrigin) {
    const TriangleMesh mesh = shapes::translated(shapes::icosphere(0.05, 3), {40, -70, 100});
    const Discretisation solid = particlesOnly(mesh, 0.01);
    const auto fragments = cut(mesh, solid, randomClusters(solid, 9, 2));
    ASSERT_GT(fragments.pieces.size(), 1u);
    for (const FragmentSurface& piece : fragments.pieces) EXPECT_EQ(faultOf(piece.mesh), "");
}

TEST(FragmentSurfaces, SayWhatIsWrongWithTheInput) {
    TriangleMesh mesh = shapes::slab({1, 1, 1});
    const Discretisation solid = particlesOnly(mesh, 0.25);
    const FragmentLabels labels = randomClusters(solid, 3, 1);
    FragmentLabels wrong = labels;
    wrong.of_particle.pop_back();
    EXPECT_EQ(cutFragments(mesh, solid, wrong, {}).error(),
              "There is not one fragment label for each particle.");
    wrong.of_particle.push_back(3);
    EXPECT_EQ(cutFragments(mesh, solid, wrong, {}).error(), "A fragment label is out of range.");
    EXPECT_EQ(cutFragments({}, solid, labels, {}).error(), "The surface to be cut has no triangles.");
    mesh.triangles.pop_back();
    EXPECT_EQ(cutFragments(mesh, solid, labels, {}).error(),
              "The surface to be cut is not closed and oriented; check it before it is made breakable.");
}

}  // namespace
}  // namespace sherd
