#include <gtest/gtest.h>
#include <sherd/triangle_mesh.h>

#include <cmath>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"
#include "geometry/surface_checks.h"

namespace sherd {
namespace {

double volumeOf(const TriangleMesh& mesh) {
    return enclosedVolume(mesh.vertices, mesh.triangles, Vec3(0.3, -0.1, 0.2));
}

TEST(SimpleMeshes, AreClosedAndTurnedOutward) {
    const TriangleMesh box = boxMesh(Vec3(0.25, 0.12, 0.06));
    EXPECT_NEAR(volumeOf(box), 0.25 * 0.12 * 0.06, 1e-12);
    constexpr int sides = 24;
    const TriangleMesh cylinder = cylinderMesh(0.1, 0.5, sides);
    EXPECT_NEAR(volumeOf(cylinder), 0.5 * sides / 2 * std::sin(2 * pi / sides) * 0.01, 1e-12);
    for (const TriangleMesh& mesh : {box, cylinder}) {
        const Status closed = checkSurface(mesh);
        EXPECT_TRUE(closed.ok()) << closed.error();
    }
}

TEST(SimpleMeshes, WithoutASizeAreRefused) {
    for (const TriangleMesh& mesh : {boxMesh(Vec3(1, 0, 1)), boxMesh(Vec3(1, -1, 1)), cylinderMesh(0, 1)})
        EXPECT_FALSE(checkSurface(mesh).ok());
}

}  // namespace
}  // namespace sherd
