#include <gtest/gtest.h>
#include <sherd/stress_model.h>

#include <cmath>

#include "support/shapes.h"

namespace {

using namespace sherd;

const TriangleMesh bar = shapes::box(Vec3(0, 0, 0), Vec3(1, 0.2, 0.2));
const BoxRegion left{Vec3(0, 0, 0), Vec3(0, 0.2, 0.2)}, right{Vec3(1, 0, 0), Vec3(1, 0.2, 0.2)};

StressModel modelOf(const TriangleMesh& mesh, const std::vector<SurfaceRegion>& supports = {}) {
    Material material;
    material.poisson_ratio = 0.3;
    auto model = StressModel::make(mesh, material, Settings::forQuality(Quality::preview), supports);
    if (!model) throw std::runtime_error(model.error());
    return std::move(model).value();
}

SurfaceLoad pressureOn(const SurfaceRegion& region, double pressure_pa) {
    SurfaceLoad load{region};
    load.pressure_pa = pressure_pa;
    return load;
}

/// Stress across the middle of the facet at radius `at` of a tube with a pressure of 1 MPa in its bore.
double acrossFacet(double outer, double inner, int sides, double at) {
    const StressModel tube = modelOf(shapes::tube(outer, inner, 0.2 * outer, sides));
    const double half = std::acos(-1.0) / sides;
    const Vec3 normal(std::cos(half), std::sin(half), 0);
    const auto field = tube.solve({pressureOn(CylinderRegion{Vec3::Zero(), Vec3::UnitZ(), inner}, 1e6)},
                                  {Vec3(at * std::cos(half) * normal + 0.1 * outer * Vec3::UnitZ())});
    EXPECT_TRUE(field.ok()) << field.error();
    const SymmetricTensor& v = field.value().points[0];
    Mat3 stress;
    stress << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
    return normal.dot(stress * normal);
}

TEST(StressModel, WhatIsNotFiniteIsNamed) {
    const StressModel model = modelOf(bar);
    EXPECT_EQ(model.solve({}, {Vec3(0.5, 0.1, 0.1), Vec3(NAN, 0, 0)}).error(),
              "Point number 1 (from 0) is not finite.");
    EXPECT_EQ(model.solve({}, {Vec3(INFINITY, 0, 0)}).error(), "Point number 0 (from 0) is not finite.");
    EXPECT_NE(model.solve({}, {}, Vec3(NAN, 0, 0)).error().find("spin"), std::string::npos);
}

TEST(StressModel, PointsOutsideAreCounted) {
    const auto field =
        modelOf(bar).solve({pressureOn(left, 1e6), pressureOn(right, 1e6)},
                           {Vec3(0.5, 0.1, 0.1), Vec3(500, 100, 100), Vec3(0.5, 0.1, 0.2), Vec3(-1, 0, 0)});
    ASSERT_TRUE(field.ok()) << field.error();
    ASSERT_EQ(field.value().warnings.size(), 1u);
    EXPECT_EQ(field.value().warnings[0].find("2 of 4 points lie outside the body, the first is number 1"),
              0u);
    EXPECT_NEAR(field.value().points[0][0], -1e6, 10);
    EXPECT_NEAR(field.value().points[2][0], -1e6, 10);
}

// Held in a point or on a line a body is a mechanism: no stress is right.
TEST(StressModel, SupportsHaveToHold) {
    Material material;
    const auto make = [&](const SurfaceRegion& support) {
        return StressModel::make(bar, material, Settings::forQuality(Quality::preview), {support});
    };
    for (const SurfaceRegion& support :
         {SurfaceRegion(SphereRegion{Vec3(0, 0.1, 0.1), 1e-5}),
          SurfaceRegion(BoxRegion{Vec3(0, 0, 0.09999), Vec3(0, 0.2, 0.10001)})}) {
        const auto model = make(support);
        ASSERT_FALSE(model.ok());
        EXPECT_NE(model.error().find("free to turn"), std::string::npos) << model.error();
    }
    EXPECT_TRUE(make(left).ok());
}

// The traction that the surface carries is the one that was placed, by the same tolerance: also when a flat
// box misses its face by what digits in a file lose, and on coarse facets of a bore.
TEST(StressModel, SurfaceCarriesTheLoadsThatWerePlaced) {
    const BoxRegion missed{Vec3(1 + 5e-7, 0, 0), Vec3(1 + 5e-7, 0.2, 0.2)};
    const StressModel model = modelOf(bar);
    const auto field = model.solve({pressureOn(left, 1e6), pressureOn(missed, 1e6)},
                                   {Vec3(1, 0.1, 0.1), Vec3(0.999, 0.1, 0.1)});
    ASSERT_TRUE(field.ok()) << field.error();
    for (const SymmetricTensor& stress : field.value().points) EXPECT_NEAR(stress[0], -1e6, 1e3);

    constexpr int sides = 12;
    EXPECT_NEAR(acrossFacet(0.2, 0.1, sides, 0.1), -1e6, 1);
}

// A thin ring: its outer face is free although it lies within a hundredth of the bore's radius.
TEST(StressModel, TheOtherFaceOfAThinRingIsFree) {
    EXPECT_NEAR(acrossFacet(0.1005, 0.1, 96, 0.1005), 0, 1);
}

// Points that stand for a pressure lie closer than the grid can tell, however large the surface is.
TEST(StressModel, PressureAllAroundIsTheSameEverywhere) {
    for (const Quality quality : {Quality::game, Quality::film}) {
        const auto cup = StressModel::make(shapes::cup(0.036, 0.1, 0.004, 40, 16), Material::ceramic(),
                                           Settings::forQuality(quality));
        ASSERT_TRUE(cup.ok()) << cup.error();
        const auto solved = cup.value().solve({pressureOn(SphereRegion{Vec3(0, 0, 0), 10}, 1e6)});
        ASSERT_TRUE(solved.ok()) << solved.error();
        SymmetricTensor exact = SymmetricTensor::Zero();
        exact.head<3>().setConstant(-1e6);
        for (const SymmetricTensor& stress : solved.value().particles)
            EXPECT_LT((stress - exact).cwiseAbs().maxCoeff(), 0.02e6);
        for (const SymmetricTensor& stress : solved.value().surface)
            EXPECT_LT((stress - exact).cwiseAbs().maxCoeff(), 0.05e6);
    }
}

}  // namespace
