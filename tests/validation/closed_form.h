#pragma once

#include <array>
#include <functional>

#include "core/sampling/surface_quadrature.h"
#include "core/stress/surface_traction.h"
#include "validation/support.h"

namespace sherd::validation {

/// A body and a stress field in it that balances without body forces. Loaded with the field's own tractions
/// on every facet, the field is the exact solution in the faceted body too.
struct ClosedForm {
    TriangleMesh surface;
    Material material;
    std::function<Mat3(const Vec3& x)> stress;  // Pa
};

/// The same, carried to another orientation.
inline ClosedForm turned(const ClosedForm& form, const Mat3& rotation) {
    return {shapes::moved(form.surface, rotation), form.material, [form, rotation](const Vec3& x) -> Mat3 {
                return rotation * form.stress(rotation.transpose() * x) * rotation.transpose();
            }};
}

struct Errors {
    double interior = 0;       // at the particles, weighted by their volume
    double surface = 0;        // at the surface points, as the displacement's derivatives give them
    double with_traction = 0;  // the same, made to carry the traction that acts there
};

/// Sums of squares that a relative L2 error is made of.
struct Squares {
    double difference = 0, norm = 0;

    void add(const Mat3& found, const Mat3& exact, double weight) {
        difference += weight * (found - exact).squaredNorm();
        norm += weight * exact.squaredNorm();
    }
    double ratio() const { return std::sqrt(difference / norm); }
};

/// Tractions sigma n of the closed form over the whole surface, by a rule that is exact to rounding for
/// polynomials.
inline std::vector<PointForce> tractions(const ClosedForm& form, const Discretisation& solid) {
    constexpr int gauss_points = 6;
    std::vector<PointForce> loads;
    for (const SurfaceNode& node : surfaceQuadrature(form.surface, solid.parts, gauss_points))
        loads.push_back({node.position, form.stress(node.position) * node.area});
    return loads;
}

inline std::shared_ptr<Discretisation> sampledForSplines(const TriangleMesh& mesh, double spacing,
                                                         Basis basis) {
    SamplingSettings settings;
    settings.moment_order = 2 * splineDegree(basis);
    return std::make_shared<Discretisation>(valueOf(sampleSolid(mesh, spacing, settings)));
}

/// Relative L2 errors of the stress tensor.
inline Errors errorsOf(const ClosedForm& form, double spacing, Basis basis) {
    const auto solid = sampledForSplines(form.surface, spacing, basis);
    const StressField field =
        valueOf(build(solid, form.material, splines(basis)).solve(tractions(form, *solid)));
    EXPECT_LT(field.residual_rel,
              1e-10 / (1 - 2 * form.material.poisson_ratio));  // rounding grows with lambda / mu
    Squares interior, surface, with_traction;
    for (size_t i = 0; i < solid->particles.size(); ++i)
        interior.add(toMatrix(field.particles[i]), form.stress(solid->particles[i].position),
                     solid->particles[i].volume);
    for (size_t q = 0; q < solid->surface_points.size(); ++q) {
        const SurfacePoint& point = solid->surface_points[q];
        if (point.normal.isZero()) continue;
        const Mat3 exact = form.stress(point.position);
        surface.add(toMatrix(field.surface[q]), exact, point.area.norm());
        with_traction.add(toMatrix(withTraction(field.surface[q], point.normal, exact * point.normal,
                                                Elasticity(form.material))),
                          exact, point.area.norm());
    }
    return {interior.ratio(), surface.ratio(), with_traction.ratio()};
}

/// Observed orders of convergence between the first and the last of three resolutions, whose errors have to
/// fall.
struct Convergence {
    Errors coarse, fine;
    double interior_rate = 0, surface_rate = 0, with_traction_rate = 0;
};

inline Convergence converge(const ClosedForm& form, const std::array<double, 3>& spacings, Basis basis) {
    std::array<Errors, 3> errors;
    for (size_t i = 0; i < spacings.size(); ++i) errors[i] = errorsOf(form, spacings[i], basis);
    for (size_t i = 1; i < spacings.size(); ++i) EXPECT_LT(errors[i].interior, errors[i - 1].interior);
    const auto rate = [&](double Errors::*kind) {
        return std::log(errors[0].*kind / errors[2].*kind) / std::log(spacings[0] / spacings[2]);
    };
    return {errors[0], errors[2], rate(&Errors::interior), rate(&Errors::surface),
            rate(&Errors::with_traction)};
}

/// Stress of splines of degree p converges with h^p (C^(p-1) functions, energy norm); a quarter of an order
/// is left to resolutions that are not yet in the asymptotic range.
inline double expectedRate(Basis basis) {
    return splineDegree(basis) - 0.25;
}

inline const std::array<Basis, 3> all_bases = {Basis::linear, Basis::quadratic, Basis::cubic};

}  // namespace sherd::validation
