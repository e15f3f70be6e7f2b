#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "headless/camera_fit.h"
#include "headless/corner_normals.h"
#include "scenes/box_mesh.h"

namespace {

using demo::Vec3;

/// Six times the volume that a surface encloses, if it is closed.
double sixVolumes(const sherd::TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
    return sum;
}

TEST(BoxMesh, IsClosedOrientedOutwardAndOfTheRightVolume) {
    const sherd::TriangleMesh mesh = demo::boxMesh({Vec3(1, 0.09, 0.5), 0.03});
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_NEAR(sixVolumes(mesh), 6 * 0.09 * 0.5, 1e-12);
}

TEST(CornerNormals, AreSmoothOverFlatEdgesAndSharpAtCreases) {
    // Two triangles that meet in the edge 0-1; the fold between them is 60 degrees.
    sherd::TriangleMesh mesh;
    const double a = std::acos(-1.0) / 3;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(-std::cos(a), 0, -std::sin(a))};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
    const Vec3 first(0, 0, 1), second(-std::sin(a), 0, std::cos(a));
    const auto sharp = demo::cornerNormals(mesh, 40);
    EXPECT_LT((sharp[0][0] - first).norm(), 1e-12);
    EXPECT_LT((sharp[1][0] - second).norm(), 1e-12);
    const auto smooth = demo::cornerNormals(mesh, 70);
    EXPECT_LT((smooth[0][0] - (first + second).normalized()).norm(), 1e-12);
    EXPECT_LT((smooth[0][1] - first).norm(), 1e-12) << "a corner that only one triangle has";
    mesh.kinds = {sherd::SurfaceKind::original, sherd::SurfaceKind::crack};
    const auto cracked = demo::cornerNormals(mesh, 70);
    EXPECT_LT((cracked[0][0] - first).norm(), 1e-12) << "crack faces do not bend the shading of the outside";
    EXPECT_LT((cracked[1][0] - second).norm(), 1e-12);
}

TEST(CameraFit, LeavesOutAChipThatFlewFar) {
    const demo::Camera camera{Vec3(0, 1, -0.5), 30};
    std::vector<Vec3> body;
    for (int i = 0; i < 50; ++i) body.emplace_back(std::sin(1.7 * i), std::cos(1.7 * i), 0.1 * (i % 7));
    const std::vector<Vec3> chip = {Vec3(30, 0, 0), Vec3(30.1, 0, 0), Vec3(30, 0.1, 0)};
    EXPECT_LT(
        (demo::fitCamera(camera, {body, chip}, 1.6).position - demo::fitCamera(camera, {body}, 1.6).position)
            .norm(),
        1e-12);
}

TEST(CameraFit, TakesInEveryPointAndTouchesTheMargin) {
    const demo::Camera camera{Vec3(0.4, 1, -0.5), 30};
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i)
        points.emplace_back(std::sin(1.7 * i), 0.3 * std::cos(2.3 * i), 0.1 * (i % 7));
    const double aspect = 1.6;
    const demo::Viewpoint view = demo::fitCamera(camera, {points}, aspect);
    const Vec3 along = (view.look_at - view.position).normalized(), right = along.cross(view.up).normalized();
    const double slope = std::tan(15 * std::acos(-1.0) / 180);
    double widest = 0;
    for (const Vec3& point : points) {
        const Vec3 seen = point - view.position;
        ASSERT_GT(seen.dot(along), 0);
        widest = std::max(widest, std::abs(seen.dot(right)) / seen.dot(along) / slope);
        widest = std::max(widest, std::abs(seen.dot(view.up)) / seen.dot(along) / slope * aspect);
    }
    EXPECT_LT(widest, 1);
    EXPECT_GT(widest, 0.8) << "no farther away than needed";
    EXPECT_LT((along - camera.towards.normalized()).norm(), 1e-12);
}

}  // namespace
