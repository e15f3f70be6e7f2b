#include <gtest/gtest.h>

#include <cmath>

#include "core/loads/surface_region.h"
#include "support/shapes.h"

namespace sherd {
namespace {

constexpr double pi = 3.14159265358979323846;

TriangleMesh caseSurface(const std::string& name) {
    const auto mesh = readObj(std::string(SHERD_TEST_DATA) + "/cases/" + name + "/surface.obj");
    EXPECT_TRUE(mesh) << mesh.error();
    return mesh ? mesh.value() : TriangleMesh();
}

std::vector<AreaPoint> quadrature(const TriangleMesh& mesh, const SurfaceRegion& region, double size) {
    const auto points = regionQuadrature(mesh, region, size);
    EXPECT_TRUE(points) << points.error();
    return points ? points.value() : std::vector<AreaPoint>();
}

double areaOf(const std::vector<AreaPoint>& points) {
    double area = 0;
    for (const AreaPoint& p : points) area += p.area_m2;
    return area;
}

TEST(RegionQuadrature, TheWidthIsTheShorterSideOfAStrip) {
    const TriangleMesh pane = shapes::box(Vec3(0, 0, 0), Vec3(0.8, 0.004, 0.8));
    EXPECT_NEAR(spreadOf(pane, BoxRegion{{-1, -1, 0}, {1, 1, 0}}).width_m(), 0.004, 1e-9);
    const double tolerance = 3e-6;  // of boxes: a millionth of the body's size on either side
    EXPECT_NEAR(spreadOf(pane, BoxRegion{{0.1, -1, 0.8}, {0.102, 1, 0.8}}).width_m(), 0.002, tolerance);
    EXPECT_NEAR(spreadOf(pane, BoxRegion{{-1, -1, 0}, {1, 1, 0}}).area_m2(), 0.8 * 0.004, 1e-9);
    EXPECT_EQ(spreadOf(pane, BoxRegion{{2, 2, 2}, {3, 3, 3}}).width_m(), 0);
}

TEST(RegionQuadrature, TwoStripsSpreadAsFarAsTheyAreApart) {
    const TriangleMesh pane = shapes::box(Vec3(0, 0, 0), Vec3(0.8, 0.004, 0.8));
    AreaSpread spread(Vec3(0.4, 0, 0.4));
    spread.add(pane, BoxRegion{{-1, -1, 0}, {1, 1, 0}});
    spread.add(pane, BoxRegion{{-1, -1, 0.8}, {1, 1, 0.8}});
    EXPECT_NEAR(spread.area_m2(), 2 * 0.8 * 0.004, 1e-9);
    // Along x as far as a strip of 0.8 m, along z by 0.4 m to either side.
    EXPECT_NEAR(spread.width_m(), 0.8, 1e-6);
}

// A = pi r^2 on a face, whether it is two triangles or thousands.
TEST(RegionQuadrature, DiscOnAFlatSlab) {
    const double r = 0.08, area = pi * r * r;
    const SphereRegion middle{{0, 0, 0.045}, r};
    const TriangleMesh coarse =
        shapes::rectilinear({-0.5, 0.5}, {-0.5, 0.5}, {-0.045, 0.045}, [](int, int, int) { return true; });
    for (const TriangleMesh& slab : {coarse, caseSurface("slab_centre")}) {
        const auto points = quadrature(slab, middle, 0.02);
        EXPECT_NEAR(areaOf(points), area, 1e-3 * area);
        EXPECT_LT(points.size(), 1000u);
        Vec3 first = Vec3::Zero();
        for (const AreaPoint& p : points) first += p.area_m2 * p.position;
        EXPECT_LT((first / area - middle.centre).norm(), 1e-3 * r);
    }
}

// The sphere of radius r about a point of a sphere of radius R cuts off a cap of area pi r^2, whatever R.
TEST(RegionQuadrature, CapOfASphere) {
    const double area = pi * 0.08 * 0.08;
    const auto points = quadrature(caseSurface("sphere_squeezed"), SphereRegion{{0, 0, 0.5}, 0.08}, 0.02);
    EXPECT_NEAR(areaOf(points), area, 1e-3 * area);
}

TEST(RegionQuadrature, BoreOfACylinder) {
    const double area = 2 * pi * 0.1 * 0.2;
    const auto points =
        quadrature(caseSurface("thick_cylinder"), CylinderRegion{{0, 0, 0}, {0, 0, 3}, 0.1}, 0.01);
    EXPECT_NEAR(areaOf(points), area, 1e-3 * area);
    EXPECT_LT(points.size(), 8000u);
    for (const AreaPoint& p : points) EXPECT_LT(p.area.dot(Vec3(p.position.x(), p.position.y(), 0)), 0);
}

TEST(RegionQuadrature, FlatBoxTakesItsFaceAlone) {
    const auto points =
        quadrature(caseSurface("cantilever"), BoxRegion{{1, -0.1, -0.1}, {1, 0.1, 0.1}}, 0.02);
    EXPECT_NEAR(areaOf(points), 0.04, 1e-6);
    for (const AreaPoint& p : points) EXPECT_NEAR(p.position.x(), 1, 1e-9);
}

TEST(RegionQuadrature, BoxClipsTriangles) {
    const TriangleMesh cube = shapes::rectilinear({0, 1}, {0, 1}, {0, 1}, [](int, int, int) { return true; });
    // A corner: three squares of 0.3 x 0.3.
    EXPECT_NEAR(areaOf(quadrature(cube, BoxRegion{{-1, -1, -1}, {0.3, 0.3, 0.3}}, 0.1)), 0.27, 1e-5);
}

TEST(RegionQuadrature, ForcesAddUpAndPressurePushesInward) {
    const TriangleMesh cube = shapes::rectilinear({0, 1}, {0, 1}, {0, 1}, [](int, int, int) { return true; });
    const SurfaceLoad load{BoxRegion{{0, 0, 1}, {1, 1, 1}}, {3, 4, 5}, 100};
    Vec3 total = Vec3::Zero();
    for (const PointForce& f : pointForces(load, quadrature(cube, load.region, 0.2))) total += f.force;
    EXPECT_LT((total - Vec3(3, 4, 5 - 100)).norm(), 1e-3);
}

TEST(RegionQuadrature, SaysWhatIsWrong) {
    const TriangleMesh cube = shapes::rectilinear({0, 1}, {0, 1}, {0, 1}, [](int, int, int) { return true; });
    EXPECT_EQ(regionQuadrature(cube, SphereRegion{{0, 0, 5}, 0.5}, 0.1).error(),
              "No part of the surface lies in the sphere about (0, 0, 5) m of radius 0.5 m; the body fills "
              "the box from (0, 0, 0) m to (1, 1, 1) m.");
    for (const SurfaceRegion& bad :
         std::vector<SurfaceRegion>{SphereRegion{{0, 0, 0}, -1}, BoxRegion{{1, 0, 0}, {0, 1, 1}},
                                    CylinderRegion{{0, 0, 0}, {0, 0, 0}, 1}, SphereRegion{{NAN, 0, 0}, 1}})
        EXPECT_NE(regionQuadrature(cube, bad, 0.1).error().find("must be"), std::string::npos);
}

}  // namespace
}  // namespace sherd
