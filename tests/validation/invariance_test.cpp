#include "validation/invariance.h"

namespace sherd::validation::invariance {
namespace {

/// A block struck off its middle, everything scaled: lengths by `length`, stress by `stiffness`.
StressField struckBlock(double length, double stiffness, const StressSettings& settings) {
    const auto solid = sampledForSplines(shapes::slab(length * size), length * 0.1, Basis::quadratic);
    const double force = 100 * stiffness * length * length;
    return valueOf(build(solid, elasticMaterial(1e9 * stiffness), settings)
                       .solve({{length * Vec3(0.22, 0.11, 0.1), force * Vec3(0.1, 0, -1)},
                               {length * Vec3(0.17, 0.12, 0.1), force * Vec3(0, 0, -1)}}));
}

TEST(Invariance, Scale) {
    for (const StressSettings& settings :
         built({splines(Basis::quadratic), galerkin_gmls, galerkin_mls, heaviside_mls})) {
        const StressField unit = struckBlock(1, 1, settings);
        for (const auto& [length, stiffness] : {std::pair{1e-3, 1e3}, {100.0, 1e-3}, {1.0, 1e3}}) {
            const StressField scaled = struckBlock(length, stiffness, settings);
            EXPECT_LT(largestDifference(unit.particles, scaled.particles, stiffness), 1e-8);
            EXPECT_LT(largestDifference(unit.surface, scaled.surface, stiffness), 1e-8);
            EXPECT_LT(scaled.residual_rel, 1e-10);
        }
    }
}

/// A body whose surface cuts the cells anyhow, and a blow on it.
const double tilted_spacing = 0.09;
TriangleMesh tiltedBlock() {
    return shapes::moved(shapes::slab(size, 3, 2, 1), someRotation());
}
std::vector<PointForce> tiltedBlow(const Mat3& rotation, const Vec3& offset) {
    std::vector<PointForce> loads = {{{0.22, 0.11, 0.1}, {10, 0, -100}}, {{-0.13, 0.02, 0.1}, {0, 5, -50}}};
    for (PointForce& load : loads)
        load = {rotation * (someRotation() * load.position) + offset,
                rotation * (someRotation() * load.force)};
    return loads;
}
const std::vector<Vec3> tiltedPoints() {
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i)
        points.push_back(someRotation() *
                         Vec3(0.01 * (i - 30), 0.006 * (i % 7 - 3) * 10, 0.03 * (i % 5 - 2)));
    return points;
}
std::vector<SymmetricTensor> stressIn(const TriangleMesh& mesh, const Mat3& rotation, const Vec3& offset) {
    std::vector<Vec3> points = tiltedPoints();
    for (Vec3& x : points) x = rotation * x + offset;
    const auto solid = sampledForSplines(mesh, tilted_spacing, Basis::quadratic);
    std::vector<SymmetricTensor> stresses = valueOf(build(solid, elasticMaterial(), splines(Basis::quadratic))
                                                        .solve(tiltedBlow(rotation, offset), points))
                                                .points;
    for (SymmetricTensor& stress : stresses)
        stress = toSymmetricTensor(rotation.transpose() * toMatrix(stress) * rotation);
    return stresses;
}

// The grid of splines goes with the body's bounds: to another place, and by quarter turns.
TEST(Invariance, SplinesGoWithTheBody) {
    const std::vector<SymmetricTensor> here = stressIn(tiltedBlock(), Mat3::Identity(), Vec3::Zero());
    const Vec3 offset(3, -5, 7);
    EXPECT_LT(largestDifference(
                  here, stressIn(shapes::translated(tiltedBlock(), offset), Mat3::Identity(), offset), 1),
              1e-8);
    const Mat3 quarter = (Mat3() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
    EXPECT_LT(
        largestDifference(here, stressIn(shapes::moved(tiltedBlock(), quarter), quarter, Vec3::Zero()), 1),
        1e-8);
}

// Any other rotation turns the body against its grid: what changes is part of the discretisation error, and
// goes with it.
TEST(Invariance, SplinesAtOtherAnglesDifferByTheirErrorOnly) {
    const auto difference = [&](double spacing) {
        const auto bending = [&](const Mat3& tilt) {
            const auto solid = sampledForSplines(shapes::moved(shapes::slab(size, 3, 2, 1), tilt), spacing,
                                                 Basis::quadratic);
            // Pressed in the middle from above, held up by inertia.
            const auto loads =
                spreadOverSurface(*solid, tilt * Vec3(0, 0, -100), [&](const Vec3& x, const Vec3& n) {
                    return (tilt.transpose() * n).z() > 0.9 && (tilt.transpose() * x).head<2>().norm() < 0.1;
                });
            std::vector<Vec3> points;
            for (int i = 0; i < 25; ++i)
                points.push_back(tilt * Vec3(0.04 * (i % 5 - 2), 0.04 * (i / 5 - 2), -0.05));
            std::vector<SymmetricTensor> found =
                valueOf(build(solid, elasticMaterial(), splines(Basis::quadratic)).solve(loads, points))
                    .points;
            for (SymmetricTensor& stress : found)
                stress = toSymmetricTensor(tilt.transpose() * toMatrix(stress) * tilt);
            return found;
        };
        return largestDifference(bending(Mat3::Identity()), bending(someRotation()), 1);
    };
    const double coarse = difference(0.1), fine = difference(0.04);
    EXPECT_LT(fine, 0.05);
    EXPECT_GT(std::log(coarse / fine) / std::log(0.1 / 0.04), expectedRate(Basis::quadratic));
}

// Vertices and triangles in another order: other sums, the same stress.
TEST(Invariance, SplinesDoNotDependOnTheOrderOfTriangles) {
    TriangleMesh mesh = tiltedBlock();
    const std::vector<SymmetricTensor> straight = stressIn(mesh, Mat3::Identity(), Vec3::Zero());
    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    std::reverse(mesh.vertices.begin(), mesh.vertices.end());
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    for (auto& triangle : mesh.triangles)
        for (int& vertex : triangle) vertex = last - vertex;
    EXPECT_LT(largestDifference(straight, stressIn(mesh, Mat3::Identity(), Vec3::Zero()), 1), 1e-8);
}

// Threads share the work, but neither their number nor their haste shows in the result.
TEST(Invariance, SameInputSameBits) {
    for (const StressSettings& settings : built({splines(Basis::quadratic), galerkin_gmls})) {
        const StressField first = struckBlock(1, 1, settings), second = struckBlock(1, 1, settings);
        for (size_t i = 0; i < first.particles.size(); ++i)
            EXPECT_EQ(first.particles[i], second.particles[i]);
        EXPECT_EQ(first.strain_energy_j, second.strain_energy_j);
    }
}

}  // namespace
}  // namespace sherd::validation::invariance
