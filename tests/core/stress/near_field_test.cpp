#include "core/stress/near_field.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/numerics/pi.h"

namespace sherd {
namespace {

Vec3 direction(double height, double angle) {
    const double flat = std::sqrt(1 - height * height);
    return {flat * std::cos(angle), flat * std::sin(angle), height};
}

double largestPart(const Mat3& stress) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(stress, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseAbs()
        .maxCoeff();
}

TEST(NearField, IsNowhereMoreThanItsBound) {
    const double radius = 0.02;
    double closest = 0;
    for (const double nu : {0.0, 0.3, 0.5 - 1e-6})
        for (const double tilt : {0.0, 0.5, 1.0})
            for (const double sign : {-1.0, 1.0}) {
                const ContactDisc disc{Vec3::Zero(), Vec3::UnitZ(), radius, sign * direction(tilt, 0.3)};
                const NearField field({disc}, nu);
                for (const double far : {0.0, 0.3, 0.6, 0.8, 1.0, 1.5, 3.0, 10.0, 30.0})
                    for (const double height : {-1.0, -0.9, -0.7, -0.5, -0.4, -0.3, 0.0, 0.2, 0.5, 0.9, 1.0})
                        for (int i = 0; i < 12; ++i) {
                            const Vec3 x = far * radius * direction(height, 0.3 + pi * i / 6);
                            const double share = largestPart(field.stressAt(x)) / field.largestAbout(x, 0);
                            EXPECT_LT(share, 1) << far << ' ' << height << ' ' << i;
                            closest = std::max(closest, share);
                            EXPECT_GE(field.largestAbout(x, 0.01), field.largestAbout(x, 0));
                        }
            }
    EXPECT_GT(closest, 0.8);
}

TEST(NearField, ActsOnManyPiecesAsOnEach) {
    for (const bool hollow : {false, true}) {
        const NearField field({{Vec3(0.1, 0, 0), direction(0.6, 0.4), 0.02, Vec3(3, -1, 7), hollow},
                               {Vec3(0, 0.3, 0), direction(-0.2, 2), 0.05, Vec3(0, 2, 1), false}},
                              0.25);
        std::vector<Vec3> offsets;
        for (const double far : {0.0, 0.02, 0.1, 0.17, 0.3, 2.0})
            for (const double height : {-1.0, -0.6, -0.3, 0.0, 0.4, 1.0})
                for (int i = 0; i < 5; ++i) offsets.push_back(Vec3(0.1, 0, 0) + far * direction(height, i));
        const auto count = static_cast<Eigen::Index>(offsets.size());
        SurfacePieces pieces{RowsOf3(count, 3), RowsOf3(count, 3)};
        for (Eigen::Index i = 0; i < count; ++i) {
            pieces.places.row(i) = offsets[i].transpose();
            pieces.areas.row(i) = direction(0.3, 0.1 * double(i)).transpose();
        }
        const RowsOf3 forces = field.forcesOn(pieces);
        for (Eigen::Index i = 0; i < count; ++i) {
            const Vec3 one = field.stressAt(offsets[i]) * pieces.areas.row(i).transpose();
            // The closed form of a disc loses digits with the distance.
            EXPECT_NEAR((forces.row(i).transpose() - one).norm(), 0, 1e-10 * (1e-6 + one.norm())) << i;
        }
    }
}

TEST(NearField, IsNowhereMoreThanItsBoundBeforeAHollow) {
    for (const double nu : {0.0, 0.3, 0.499})
        for (const double tilt : {0.0, 0.5, 1.0}) {
            const NearField field({{Vec3::Zero(), Vec3::UnitZ(), 1, direction(tilt, 0.3), true}}, nu);
            for (const double far : {0.3, 0.6, 0.8, 0.9, 0.95, 1.0, 1.5, 3.0, 10.0})
                for (const double height : {-0.1, -0.3, -0.43, -0.6, -0.7, -0.9})
                    for (int i = 0; i < 12; ++i) {
                        const Vec3 x = far * direction(height, 0.3 + pi * i / 6);
                        EXPECT_LT(largestPart(field.stressAt(x)), field.largestAbout(x, 0));
                    }
        }
}

TEST(NearField, GoesOnBeforeAHollowAsItChangesBehindIt) {
    const ContactDisc disc{Vec3::Zero(), Vec3::UnitZ(), 1, Vec3(0.3, 0, 1), true};
    const NearField field({disc}, 0.2);
    const Vec3 on(1.3, 0.2, 0), step(0, 0, 0.05);
    const Mat3 middle = field.stressAt(on);
    EXPECT_LT((field.stressAt(on + step) + field.stressAt(on - step) - 2 * middle).norm(),
              1e-9 * middle.norm());
    EXPECT_EQ(field.stressAt(Vec3(0, 0, -30)), Mat3::Zero()) << "another part of the body";
    const NearField flat({{Vec3::Zero(), Vec3::UnitZ(), 1, Vec3(0.3, 0, 1)}}, 0.2);
    EXPECT_EQ(flat.stressAt(Vec3(0, 0, -30)), Mat3::Zero());
    EXPECT_EQ(flat.stressAt(Vec3(0.4, 0, -0.1)), flat.stressAt(Vec3(0.4, 0, 0)));
}

TEST(NearField, ActsOnItsOwnPlaneOnly) {
    const NearField field({{Vec3::Zero(), Vec3::UnitZ(), 1, Vec3(1, 2, 3)}}, 0.3);
    EXPECT_EQ(field.tractionAt(Vec3::Zero(), -Vec3::UnitZ()), Vec3(1, 2, 3));
    EXPECT_EQ(field.tractionAt(Vec3(1.1, 0, 0), -Vec3::UnitZ()), Vec3::Zero());
    EXPECT_EQ(field.tractionAt(Vec3(0, 0, 0.7), -Vec3::UnitZ()), Vec3::Zero()) << "below it";
    EXPECT_EQ(field.tractionAt(Vec3::Zero(), Vec3::UnitX()), Vec3::Zero()) << "on another face";
}

}  // namespace
}  // namespace sherd
