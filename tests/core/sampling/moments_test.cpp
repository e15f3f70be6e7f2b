#include <random>

#include "core/sampling/sampling_support.h"
#include "core/sampling/surface_points.h"

namespace sherd {
namespace {

struct NamedShape {
    const char* name;
    TriangleMesh mesh;
    double spacing;
};

std::vector<NamedShape> someShapes() {
    using namespace shapes;
    const TriangleMesh brick = slab({1, 0.7, 0.4}, 3, 2, 1);
    return {{"box on the grid", brick, 0.1},
            {"tilted box", moved(brick, tilt()), 0.1},
            {"tilted box, whole in a few cells", moved(brick, tilt(2.1)), 0.6},
            {"sphere", icosphere(0.5, 3), 0.11},
            {"coarse sphere of one particle", icosphere(0.5, 1), 1},
            {"hollow sphere", hollowSphere(0.5, 0.4, 3), 0.09},
            {"cup", moved(cup(0.04, 0.09, 0.005, 40, 10), tilt(0.3)), 0.004},
            {"cup on the grid", cup(0.04, 0.09, 0.005, 40, 10), 0.005},
            {"steps on grid planes", uShape(0.2, 0.4, 1, 0.6), 0.1},
            {"steps beside grid planes", uShape(0.2, 0.4, 1, 0.6), 0.1003},
            {"sheet thinner than a voxel", moved(slab({1, 1, 0.01}), tilt()), 0.1},
            {"needle", moved(slab({1, 0.02, 0.02}), tilt()), 0.1},
            {"far away", translated(moved(brick, tilt()), {1000.37, -77.1, 3.3}), 0.1}};
}

TEST(SamplingMoments, VolumeCentroidAndSecondMomentAreThoseOfTheSurface) {
    for (const NamedShape& shape : someShapes())
        for (const int cells : {1, 2, 3}) {
            SCOPED_TRACE(shape.name + std::string(", cells per spacing: ") + std::to_string(cells));
            // Coordinates of 1000 m carry 1e-13 m.
            expectMoments(sampled(shape.mesh, shape.spacing, cells), shape.mesh,
                          shape.mesh.vertices[0].norm() > 100 ? 1e-11 : 1e-12);
        }
}

TEST(SamplingMoments, EveryCellCloses) {
    for (const NamedShape& shape : someShapes())
        for (const int cells : {1, 2, 3}) {
            SCOPED_TRACE(shape.name + std::string(", cells per spacing: ") + std::to_string(cells));
            expectSound(sampled(shape.mesh, shape.spacing, cells),
                        shape.mesh.vertices[0].norm() > 100 ? 1e-10 : 1e-12);
        }
}

TEST(SamplingMoments, SurfacePointsIntegrateAsTheSurfaceDoes) {
    const TriangleMesh mesh = shapes::moved(shapes::cup(0.04, 0.09, 0.005, 40, 10), shapes::tilt(0.3));
    const Discretisation solid = sampled(mesh, 0.004);
    Mat3 expected = Mat3::Zero(), found = Mat3::Zero();
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        expected += (a + b + c) / 3 * ((b - a).cross(c - a) / 2).transpose();
    }
    for (const SurfacePoint& q : solid.surface_points) found += q.position * q.area.transpose();
    EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm());
}

TEST(SamplingMoments, FlatSidesTakeOneSurfacePointACell) {
    const TriangleMesh mesh = shapes::moved(shapes::slab({1, 0.7, 0.4}, 5, 3, 2), shapes::tilt());
    const Discretisation solid = sampled(mesh, 0.1);
    std::vector<int> points(solid.cells.size(), 0);
    for (const SurfacePoint& q : solid.surface_points) ++points[q.cell];
    EXPECT_LE(*std::max_element(points.begin(), points.end()), 4);  // a merged cell may reach round a corner
    double on_surface = 0, all = 0;
    const Mat3 back = shapes::tilt().transpose();
    for (const SurfacePoint& q : solid.surface_points) {
        const Vec3 gap = Vec3(0.5, 0.35, 0.2) - (back * q.position).cwiseAbs();
        all += q.area.norm();
        if (std::abs(gap.minCoeff()) < 1e-9) on_surface += q.area.norm();
    }
    EXPECT_NEAR(on_surface / all, 1, 1e-9);
}

TEST(SamplingMoments, ChamfersTakeAPointOnEachOfTheirPlanes) {
    // A prism of eight sides, 45 degrees from one to the next.
    const TriangleMesh prism = shapes::moved(shapes::tube(0.5, 0.2, 0.4, 8), shapes::tilt());
    const Discretisation solid = sampled(prism, 0.09);
    double worst = 0;
    for (const SurfacePoint& q : solid.surface_points) {
        const Vec3 x = shapes::tilt().transpose() * q.position;
        const double turn = std::acos(-1.0) / 4, side = std::floor(std::atan2(x.y(), x.x()) / turn) + 0.5;
        const double across =
            (x.x() * std::cos(side * turn) + x.y() * std::sin(side * turn)) / std::cos(turn / 2);
        worst = std::max(worst, std::min({std::abs(x.z()), std::abs(x.z() - 0.4), std::abs(across - 0.5),
                                          std::abs(across - 0.2)}));
    }
    EXPECT_LT(worst, 1e-9);
}

TEST(SamplingMoments, SurfacePointsOfACurvedWallStayOnEachSideOfIt) {
    // Both sides of the wall pass through the same voxels.
    const Discretisation solid = sampled(shapes::hollowSphere(0.5, 0.47, 5), 0.12);
    int inner = 0, outer = 0;
    for (const SurfacePoint& q : solid.surface_points) {
        const double r = q.position.norm();
        EXPECT_LT(r, 0.501);
        EXPECT_LT(std::min(std::abs(r - 0.5), std::abs(r - 0.47)), 0.006) << r;
        ++(r < 0.485 ? inner : outer);
    }
    EXPECT_GT(inner, 500);
    EXPECT_GT(outer, 500);
}

// Facets so small that where they lie from each other is rounding: their spread in some direction may come
// out below zero.
TEST(SamplingMoments, SurfacePointsOfSliversAreFinite) {
    SamplingGrid grid;
    grid.origin = Vec3(0.31, -0.27, 0.4);
    grid.cell_size = Vec3::Constant(0.003);
    grid.count = Eigen::Vector3i::Constant(4);
    SolidVoxels solid;
    solid.of_cut_voxel = {0};
    CutCells cells;
    cells.of_voxel = {0};
    cells.moments.resize(1);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
    for (int i = 0; i < 2000; ++i) {
        CutSurface surface;
        surface.voxels = {0};
        const Vec3 place = 0.4 * vector(), along = vector(), area = 1e-10 * vector();
        for (int k = 0; k < 5; ++k)
            surface.pieces.push_back({0, area + 2e-11 * vector(), place + 1e-4 * any(random) * along});
        for (const SurfacePoint& q : surfacePoints(grid, surface, solid, cells))
            ASSERT_TRUE(q.position.allFinite() && q.area.allFinite()) << i;
    }
}

TEST(SamplingMoments, SurfacePointsLieInsideRatherThanOutside) {
    const Discretisation solid = sampled(shapes::icosphere(0.5, 4), 0.2);
    for (const SurfacePoint& q : solid.surface_points) EXPECT_LT(q.position.norm(), 0.5003);
}

TEST(SamplingMoments, OffsetsOfTheGridChangeNothingButRounding) {
    const TriangleMesh ball = shapes::icosphere(0.5, 2);
    const Discretisation here = sampled(ball, 0.13);
    const Vec3 offset(0.1234567, -7.654321, 3.1);
    const Discretisation there = sampled(shapes::translated(ball, offset), 0.13);
    ASSERT_EQ(here.particles.size(), there.particles.size());
    for (std::size_t p = 0; p < here.particles.size(); ++p)
        EXPECT_LT((here.particles[p].position + offset - there.particles[p].position).norm(), 1e-12);
}

TEST(SamplingMoments, FillsOfVoxelsAddUpToTheVolume) {
    const TriangleMesh mesh = shapes::hollowSphere(0.5, 0.4, 3);
    const Discretisation solid = sampled(mesh, 0.07);
    double filled = 0;
    long long last = -1;
    for (const Discretisation::Voxel& voxel : solid.voxels) {
        EXPECT_GT(voxel.fill, 0);
        EXPECT_LE(voxel.fill, 1);
        const long long order = (voxel.index.z() * 1000LL + voxel.index.y()) * 1000 + voxel.index.x();
        EXPECT_GT(order, last);
        last = order;
        filled += voxel.fill * solid.cell_size.prod();
        const Vec3 middle = solid.grid_origin +
                            (voxel.index.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.cell_size);
        EXPECT_LT((middle - solid.cells.at(voxel.cell).moments.centroid).norm(), 2 * solid.cell_size.norm());
    }
    EXPECT_NEAR(filled, meshMoments(mesh).volume, 1e-9 * filled);
}

}  // namespace
}  // namespace sherd
