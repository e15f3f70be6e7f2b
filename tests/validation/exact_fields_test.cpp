#include "validation/known_fields.h"

namespace sherd::validation {
namespace {

// Constant curvatures come with a quadratic displacement, so quadratic splines have no thickness locking,
// whatever Poisson's ratio and however few particles lie across.
TEST(PlateInBending, ConstantCurvatureIsExactAtAnyPoissonRatio) {
    for (const double nu : {0.0, 0.2, 0.43, 0.49, 0.499})
        for (const int layers : {1, 2, 3}) {
            const double thickness = 0.12;
            const ClosedForm plate = curvedPlate(nu, thickness);
            const double rounding = 1e-8 / (1 - 2 * nu);
            EXPECT_LT(errorsOf(turned(plate, someRotation()), thickness / layers, Basis::quadratic).surface,
                      rounding)
                << "nu " << nu << ", " << layers << " layers";
        }
}

/// A disc about z, its rim split at every degree.
TriangleMesh disc(double radius, double thickness) {
    constexpr int segments = 360;
    TriangleMesh mesh;
    for (const double z : {-thickness / 2, thickness / 2}) {
        const int first = static_cast<int>(mesh.vertices.size());
        mesh.vertices.emplace_back(0, 0, z);
        for (int s = 0; s < segments; ++s) {
            const double angle = s * std::acos(-1.0) / 180;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
        for (int s = 0; s < segments; ++s) {
            const int a = first + 1 + s, b = first + 1 + (s + 1) % segments;
            mesh.triangles.push_back(z > 0 ? std::array<int, 3>{first, a, b}
                                           : std::array<int, 3>{first, b, a});
        }
    }
    for (int s = 0; s < segments; ++s) {
        const int a = 1 + s, b = 1 + (s + 1) % segments, up = segments + 1;
        mesh.triangles.push_back({a, b, b + up});
        mesh.triangles.push_back({a, b + up, a + up});
    }
    return mesh;
}

/// Error on the loaded diameter of a disc that is squeezed by pressure p on two arcs of 2 alpha, against
/// Hondros (1959):
///     sigma_theta, sigma_r = +-(2 p / pi) ((1 - q) sin 2 alpha / (1 - 2 q cos 2 alpha + q^2)
///                                          -+ atan((1 + q) / (1 - q) tan alpha)),  q = (r / R)^2.
double squeezedDiscError(double spacing) {
    const double radius = 1, pressure = 1e6, pi = std::acos(-1.0), alpha = 15 * pi / 180;
    const TriangleMesh mesh = disc(radius, 0.3);
    const auto solid = sampledForSplines(mesh, spacing, Basis::quadratic);
    std::vector<PointForce> loads;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid->parts, 4)) {
        const double along = std::atan2(std::abs(node.position.y()), std::abs(node.position.x()));
        if (std::abs(node.area.normalized().z()) < 0.5 && along > pi / 2 - alpha)
            loads.push_back({node.position, -pressure * node.area});
    }
    std::vector<Vec3> points;
    for (int i = 0; i <= 24; ++i) points.emplace_back(0, 0.025 * i, 0.04);
    // At nu 0 plane stress is the exact state of a thick disc too.
    const StressField field =
        valueOf(build(solid, elasticMaterial(5e9, 0), splines(Basis::quadratic)).solve(loads, points));
    Squares squares;
    for (size_t i = 0; i < points.size(); ++i) {
        const double q = std::pow(points[i].y() / radius, 2);
        const double first = (1 - q) * std::sin(2 * alpha) / (1 - 2 * q * std::cos(2 * alpha) + q * q);
        const double second = std::atan((1 + q) / (1 - q) * std::tan(alpha));
        Mat3 exact = Mat3::Zero();
        exact(0, 0) = 2 * pressure / pi * (first - second);
        exact(1, 1) = -2 * pressure / pi * (first + second);
        squares.add(toMatrix(field.points[i]), exact, 1);
        if (i == 0) {
            EXPECT_GT(largestPrincipal(field.points[i]), 0) << "tension in the middle";
        }
    }
    return squares.ratio();
}

TEST(SqueezedDisc, Converges) {
    const double coarse = squeezedDiscError(0.2), middle = squeezedDiscError(0.14),
                 fine = squeezedDiscError(0.1);
    EXPECT_LT(middle, coarse);
    EXPECT_LT(fine, middle);
    EXPECT_GT(std::log(coarse / fine) / std::log(2.0), expectedRate(Basis::quadratic));
}

/// Largest difference from `exact` at the particles, relative to its largest value there.
double largestErrorAt(const Discretisation& solid, const StressField& field,
                      const std::function<Mat3(const Vec3&)>& exact) {
    double difference = 0, largest = 0;
    for (size_t i = 0; i < solid.particles.size(); ++i) {
        const Mat3 expected = exact(solid.particles[i].position);
        difference = std::max(difference, (toMatrix(field.particles[i]) - expected).norm());
        largest = std::max(largest, expected.norm());
    }
    return difference / largest;
}

// A rod pulled at one end accelerates as a whole: sigma_xx = F / A x / L at nu 0, a quadratic displacement.
TEST(Inertia, PulledRodIsExact) {
    const double length = 2, side = 0.2, force = 100;
    const TriangleMesh mesh = shapes::box({0, 0, 0}, {length, side, side});
    const auto solid = sampledForSplines(mesh, 0.13, Basis::quadratic);
    std::vector<PointForce> loads;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid->parts))
        if (node.area.normalized().x() > 0.9)
            loads.push_back({node.position, node.area.x() / (side * side) * Vec3(force, 0, 0)});
    const Material material = elasticMaterial(5e9, 0);
    const StressField field = valueOf(build(solid, material, splines(Basis::quadratic)).solve(loads));
    const double error = largestErrorAt(*solid, field, [&](const Vec3& x) {
        return Mat3(force / (side * side) * x.x() / length * Vec3::UnitX() * Vec3::UnitX().transpose());
    });
    EXPECT_LT(error, 1e-8);
}

// A block that spins about z at nu 0: sigma_xx = rho w^2 (L_x^2 / 4 - x^2) / 2, sigma_yy likewise; cubic
// displacements.
TEST(Inertia, SpinIsExactForCubicsAndConverges) {
    const Vec3 sides(1, 0.6, 0.3), spin(0, 0, 40);
    const Material material = elasticMaterial(5e9, 0);
    const auto exact = [&](const Vec3& x) {
        const double load = material.density_kg_m3 * spin.squaredNorm() / 2;
        return Mat3(load * Vec3(sides.x() * sides.x() / 4 - x.x() * x.x(),
                                sides.y() * sides.y() / 4 - x.y() * x.y(), 0)
                               .asDiagonal());
    };
    const auto error = [&](double spacing, Basis basis) {
        const auto solid = sampledForSplines(shapes::slab(sides), spacing, basis);
        return largestErrorAt(*solid, valueOf(build(solid, material, splines(basis)).solve({}, {}, spin)),
                              exact);
    };
    EXPECT_LT(error(0.15, Basis::cubic), 1e-7);
    const double rate =
        std::log(error(0.15, Basis::quadratic) / error(0.075, Basis::quadratic)) / std::log(2.0);
    EXPECT_GT(rate, expectedRate(Basis::quadratic));
}

/// Supports over the face x = 0 of a mesh.
std::vector<SupportPoint> heldAtZero(const TriangleMesh& mesh, const Discretisation& solid) {
    std::vector<SupportPoint> supports;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid.parts))
        if (node.area.normalized().x() < -0.9) supports.push_back({node.position, node.area.norm()});
    return supports;
}

// A bar that is held at one end and pulled at the other carries the same stress everywhere, to what the
// penalty gives.
TEST(Supports, HeldBarCarriesItsLoad) {
    const TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 0.2, 0.2});
    const auto solid = sampledForSplines(mesh, 0.07, Basis::quadratic);
    std::vector<PointForce> loads;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid->parts))
        if (node.area.normalized().x() > 0.9) loads.push_back({node.position, 1e6 * node.area});
    const StressSolver solver = valueOf(StressSolver::build(
        solid, elasticMaterial(5e9, 0), splines(Basis::quadratic), heldAtZero(mesh, *solid)));
    const StressField field = valueOf(solver.solve(loads));
    EXPECT_LT(largestError(field.particles, Mat3(1e6 * Vec3::UnitX() * Vec3::UnitX().transpose())), 1e-8);
}

// Clamped instead of left with the shape that Timoshenko's field has there: the same stress a height away
// (Saint-Venant).
TEST(Supports, ClampedCantilever) {
    const double length = 1, height = 0.2, width = 0.1, force = 1e3,
                 inertia = width * std::pow(height, 3) / 12;
    const TriangleMesh mesh = shapes::box({0, -width / 2, -height / 2}, {length, width / 2, height / 2});
    const auto solid = sampledForSplines(mesh, 0.04, Basis::quadratic);
    std::vector<PointForce> loads;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid->parts))
        if (node.area.normalized().x() > 0.9) {
            const double z = node.position.z();
            loads.push_back(
                {node.position,
                 Vec3(0, 0, force / (2 * inertia) * (height * height / 4 - z * z) * node.area.x())});
        }
    const StressSolver solver = valueOf(StressSolver::build(
        solid, elasticMaterial(5e9, 0), splines(Basis::quadratic), heldAtZero(mesh, *solid)));
    const StressField field = valueOf(solver.solve(loads));
    Squares squares;
    for (size_t i = 0; i < solid->particles.size(); ++i) {
        const Vec3& x = solid->particles[i].position;
        if (x.x() < height) continue;
        Mat3 exact = Mat3::Zero();
        exact(0, 0) = -force * (length - x.x()) * x.z() / inertia;
        exact(0, 2) = exact(2, 0) = force / (2 * inertia) * (height * height / 4 - x.z() * x.z());
        squares.add(toMatrix(field.particles[i]), exact, 1);
    }
    EXPECT_LT(squares.ratio(), 0.02);
}

// Held at both ends, a bar that spins about its middle is not determinate: only stiff supports keep its ends
// apart, so that sigma_xx = rho w^2 (L^2 / 12 - (x - L / 2)^2) / 2 away from them at nu 0.
TEST(Supports, AreStiff) {
    const double length = 1;
    const TriangleMesh mesh = shapes::box({0, 0, 0}, {length, 0.2, 0.2});
    const auto solid = sampledForSplines(mesh, 0.1, Basis::quadratic);
    std::vector<SupportPoint> supports;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid->parts))
        if (std::abs(node.area.normalized().x()) > 0.9) supports.push_back({node.position, node.area.norm()});
    const Material material = elasticMaterial(5e9, 0);
    const StressSolver solver =
        valueOf(StressSolver::build(solid, material, splines(Basis::quadratic), supports));
    const Vec3 spin(0, 0, 40);
    std::vector<Vec3> points;
    for (int i = 0; i < 7; ++i) points.emplace_back(0.27 + 0.08 * i, 0.1, 0.1);
    const StressField field = valueOf(solver.solve({}, points, spin));
    const double load = material.density_kg_m3 * spin.squaredNorm() / 2;
    for (size_t i = 0; i < points.size(); ++i) {
        const double exact = load * (length * length / 12 - std::pow(points[i].x() - length / 2, 2));
        EXPECT_NEAR(field.points[i][0], exact, 0.03 * load * length * length / 12);
    }
}

}  // namespace
}  // namespace sherd::validation
