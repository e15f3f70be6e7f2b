#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "geometry/cutting/cut_checks.h"
#include "geometry/cutting/cut_fragments.h"
#include "geometry/cutting/fragment_support.h"
#include "support/shapes.h"

namespace sherd {
namespace {

using namespace fragment_support;

FragmentSurfaces cutWith(const TriangleMesh& mesh, const Discretisation& solid, double roughness,
                         std::uint64_t seed = 5) {
    auto result = cutFragments(mesh, solid, randomClusters(solid, 8, 5), {seed, roughness});
    EXPECT_TRUE(result) << result.error();
    return result ? std::move(result).value() : FragmentSurfaces();
}

// Mean angle between the normals of crack triangles that share an edge, degrees.
double meanTurn(const FragmentSurfaces& fragments) {
    double sum = 0;
    int count = 0;
    for (const FragmentSurface& piece : fragments.pieces) {
        std::map<std::pair<int, int>, Vec3> normal_at;
        for (std::size_t t = 0; t < piece.parents.size(); ++t) {
            if (piece.parents[t] >= 0) continue;
            const auto& v = piece.mesh.triangles[t];
            const Vec3& a = piece.mesh.vertices[v[0]];
            const Vec3 normal =
                (piece.mesh.vertices[v[1]] - a).cross(piece.mesh.vertices[v[2]] - a).normalized();
            for (int i = 0; i < 3; ++i) {
                const auto other = normal_at.find({v[(i + 1) % 3], v[i]});
                normal_at[{v[i], v[(i + 1) % 3]}] = normal;
                if (other == normal_at.end()) continue;
                sum += std::atan2(normal.cross(other->second).norm(), normal.dot(other->second));
                ++count;
            }
        }
    }
    return sum / count * 180 / std::acos(-1.0);
}

TEST(CrackRoughness, TurnsCrackFacesAndLeavesThemSound) {
    const TriangleMesh mesh = shapes::slab({1, 1, 0.3}, 8, 8, 3);
    const Discretisation solid = particlesOnly(mesh, 0.06);
    double turn = meanTurn(cutWith(mesh, solid, 0));
    for (const double roughness : {0.1, 0.25, 0.5}) {
        const FragmentSurfaces fragments = cutWith(mesh, solid, roughness);
        EXPECT_EQ(faultOfCut(mesh, fragments), "");
        EXPECT_TRUE(fragments.notes.empty());
        const double rougher = meanTurn(fragments);
        EXPECT_GT(rougher, turn + 4) << roughness;
        turn = rougher;
    }
}

TEST(CrackRoughness, FollowsTheSeed) {
    const TriangleMesh mesh = shapes::slab({1, 1, 0.3}, 8, 8, 3);
    const Discretisation solid = particlesOnly(mesh, 0.06);
    const auto a = cutWith(mesh, solid, 0.3), b = cutWith(mesh, solid, 0.3), c = cutWith(mesh, solid, 0.3, 6);
    EXPECT_EQ(a.pieces[0].mesh.vertices, b.pieces[0].mesh.vertices);
    EXPECT_NE(a.pieces[0].mesh.vertices, c.pieces[0].mesh.vertices);
}

// The fallback has cracks of its own.
TEST(CrackRoughness, ActsOnApproximateFragments) {
    const TriangleMesh mesh = shapes::slab({1, 1, 0.3}, 8, 8, 3);
    const Discretisation solid = particlesOnly(mesh, 0.06);
    const FragmentLabels labels = randomClusters(solid, 8, 5);
    const auto smooth = cutFragments(mesh, solid, labels, {5, 0, 0}),
               rough = cutFragments(mesh, solid, labels, {5, 0.3, 0});
    ASSERT_TRUE(smooth && rough);
    EXPECT_EQ(faultOfCut(mesh, rough.value()), "");
    EXPECT_GT(meanTurn(rough.value()), meanTurn(smooth.value()) + 4);
}

}  // namespace
}  // namespace sherd
