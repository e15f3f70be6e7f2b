// What comes out when no lattice can be cut: forced by allowing none.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "geometry/cutting/cut_checks.h"
#include "geometry/cutting/cut_fragments.h"
#include "geometry/cutting/fragment_support.h"
#include "geometry/mass_properties.h"
#include "geometry/surface_feet.h"
#include "support/shapes.h"

namespace sherd {
namespace {

using namespace fragment_support;

const CutSettings no_lattice = {1, 0, 0};

FragmentSurfaces approximated(const TriangleMesh& mesh, const Discretisation& solid,
                              const FragmentLabels& labels) {
    auto result = cutFragments(mesh, solid, labels, no_lattice);
    EXPECT_TRUE(result) << result.error();
    return result ? std::move(result).value() : FragmentSurfaces();
}

struct Shape {
    const char* name;
    TriangleMesh mesh;
    double spacing;
    double largest_distance;  // of a vertex from the surface it stands for, in particle spacings
};

class ApproximateFragmentsOf : public testing::TestWithParam<Shape> {};

TEST_P(ApproximateFragmentsOf, AreAsSoundAsOthers) {
    const TriangleMesh& mesh = GetParam().mesh;
    const Discretisation solid = particlesOnly(mesh, GetParam().spacing);
    const double volume = solidMoments(mesh).volume;
    for (unsigned seed = 0; seed < 3; ++seed) {
        const FragmentSurfaces fragments = approximated(mesh, solid, randomClusters(solid, 9, seed));
        EXPECT_EQ(faultOfCut(mesh, fragments), "");
        EXPECT_GE(fragments.pieces.size(), 8u);
        double sum = 0, farthest = 0;
        for (const FragmentSurface& piece : fragments.pieces) {
            sum += solidMoments(piece.mesh).volume;
            std::set<int> outer_vertices;
            for (std::size_t t = 0; t < piece.parents.size(); ++t)
                if (piece.parents[t] >= 0)
                    outer_vertices.insert(piece.mesh.triangles[t].begin(), piece.mesh.triangles[t].end());
            std::vector<Vec3> outer;
            for (int v : outer_vertices) outer.push_back(piece.mesh.vertices[v]);
            for (const SurfaceFoot& foot : surfaceFeet(mesh, outer, 1e-9))
                farthest = std::max(farthest, foot.distance);
        }
        // Masses are volumes times a density.
        EXPECT_NEAR(sum, volume, 1e-12 * volume);
        EXPECT_LT(farthest, GetParam().largest_distance * GetParam().spacing);
        ASSERT_EQ(fragments.notes.size(), 1u);
        EXPECT_EQ(
            fragments.notes[0].rfind("The surface could not be cut cleanly (no lattice was tried): ", 0), 0u);
        std::cout << fragments.pieces.size() << " pieces, " << fragments.notes[0] << '\n';
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ApproximateFragmentsOf,
                         testing::Values(Shape{"box", shapes::slab({1, 1, 1}), 0.13, 0.6},
                                         Shape{"plate", shapes::slab({1, 1, 0.09}, 24, 24, 3), 1 / 22.0, 0.6},
                                         Shape{"sphere", shapes::icosphere(0.5, 3), 0.12, 0.35},
                                         Shape{"hollow_sphere", shapes::hollowSphere(0.5, 0.4, 3), 0.1, 0.3},
                                         Shape{"cup", shapes::cup(0.5, 1, 0.08, 40, 14), 0.1, 0.5}),
                         [](const auto& info) { return info.param.name; });

// A fin that the lattice does not see: it is lost, and leaves no crumbs where a node happened to be inside
// it.
TEST(ApproximateFragments, LoseFinsWithoutCrumbs) {
    const TriangleMesh mesh = shapes::rectilinear({0, 1, 1.2}, {0, 0.5, 0.52, 1}, {0, 1},
                                                  [](int i, int j, int) { return i == 0 || j == 1; });
    const Discretisation solid = particlesOnly(shapes::box({0, 0, 0}, {1, 1, 1}), 0.13);
    for (unsigned seed = 0; seed < 4; ++seed) {
        const FragmentLabels labels = randomClusters(solid, 4, seed);
        const auto fragments = cutFragments(mesh, solid, labels, {seed, 0, 0});
        ASSERT_TRUE(fragments) << fragments.error();
        EXPECT_EQ(faultOfCut(mesh, fragments.value()), "");
        EXPECT_EQ(fragments.value().pieces.size(), 4u);
    }
}

TEST(ApproximateFragments, OfSheetsFarThinnerThanTheLatticeAreRefused) {
    const TriangleMesh mesh = shapes::slab({10, 10, 0.01}, 4, 4, 1);
    const Discretisation solid = particlesOnly(mesh, 0.5);
    const auto fragments = cutFragments(mesh, solid, randomClusters(solid, 4, 1), no_lattice);
    ASSERT_FALSE(fragments);
    EXPECT_NE(fragments.error().find("walls are too thin for the lattice"), std::string::npos)
        << fragments.error();
}

TEST(ApproximateFragments, TakeAttributesFromTrianglesNearBy) {
    TriangleMesh mesh = shapes::icosphere(0.5, 3);
    for (const Vec3& v : mesh.vertices) mesh.colours.push_back(v + Vec3::Constant(0.5));
    mesh.materials = {"south", "north"};
    for (const auto& [a, b, c] : mesh.triangles)
        mesh.material.push_back(mesh.vertices[a].z() + mesh.vertices[b].z() + mesh.vertices[c].z() > 0);
    const Discretisation solid = particlesOnly(mesh, 0.12);
    const auto pieces = approximated(mesh, solid, randomClusters(solid, 4, 1)).pieces;
    ASSERT_GT(pieces.size(), 1u);
    for (const FragmentSurface& piece : pieces) {
        ASSERT_EQ(piece.mesh.colours.size(), piece.mesh.vertices.size());
        for (std::size_t t = 0; t < piece.parents.size(); ++t) {
            const auto& [a, b, c] = piece.mesh.triangles[t];
            if (piece.parents[t] < 0) continue;
            const double height =
                piece.mesh.vertices[a].z() + piece.mesh.vertices[b].z() + piece.mesh.vertices[c].z();
            if (std::abs(height) > 0.3) {
                EXPECT_EQ(piece.mesh.materials[piece.mesh.material[t]], height > 0 ? "north" : "south");
            }
            for (int v : {a, b, c})
                // A lattice triangle may reach as far as that beyond its parent.
                EXPECT_LT((piece.mesh.colours[v] - piece.mesh.vertices[v] - Vec3::Constant(0.5)).norm(),
                          0.15);
        }
    }
}

}  // namespace
}  // namespace sherd
