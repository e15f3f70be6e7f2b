#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "core/mlpg/stress_solver.h"
#include "core/sampling/sample_solid.h"
#include "core/stress/elasticity.h"
#include "support/shapes.h"

namespace sherd::validation {

inline Material elasticMaterial(double youngs_modulus_pa = 5e9, double poisson_ratio = 0.3) {
    Material material;
    material.youngs_modulus_pa = youngs_modulus_pa;
    material.poisson_ratio = poisson_ratio;
    material.density_kg_m3 = 2500;
    return material;
}

inline StressSettings form(TestFunction test, TrialFunction trial, Basis basis = Basis::linear) {
    StressSettings settings;
    settings.test_function = test;
    settings.trial_function = trial;
    settings.basis = basis;
    return settings;
}

inline const StressSettings galerkin_gmls = form(TestFunction::galerkin, TrialFunction::gmls);
inline const StressSettings galerkin_mls = form(TestFunction::galerkin, TrialFunction::mls);
inline const StressSettings heaviside_mls = form(TestFunction::heaviside, TrialFunction::mls);
inline const StressSettings heaviside_paper = form(TestFunction::heaviside_paper, TrialFunction::mls);

inline StressSettings splines(Basis basis) {
    StressSettings settings = form(TestFunction::galerkin, TrialFunction::spline, basis);
    settings.resampling_rounds = 0;
    return settings;
}

/// Whether the library under test has the forms on particles.
inline constexpr bool has_particle_forms = SHERD_PARTICLE_FORMS;

/// Those of the forms that the library under test has.
inline std::vector<StressSettings> built(std::vector<StressSettings> forms) {
    const auto missing = [](const StressSettings& s) {
        return !has_particle_forms && s.trial_function != TrialFunction::spline;
    };
    forms.erase(std::remove_if(forms.begin(), forms.end(), missing), forms.end());
    return forms;
}

inline std::shared_ptr<Discretisation> sampled(const TriangleMesh& mesh, double spacing,
                                               int cells_per_spacing = 2) {
    SamplingSettings settings;
    settings.cells_per_spacing = cells_per_spacing;
    Result<Discretisation> result = sampleSolid(mesh, spacing, settings);
    EXPECT_TRUE(result.ok()) << result.error();
    return std::make_shared<Discretisation>(result.ok() ? std::move(result).value() : Discretisation{});
}

/// Moves the particles (not the cells, whose geometry stays exact) by up to `amplitude` spacings a direction.
inline void jitter(Discretisation& solid, double amplitude, unsigned seed = 7) {
    std::mt19937 random(seed);
    const auto offset = [&] { return (random() / 4294967296.0 * 2 - 1) * amplitude; };
    for (Particle& particle : solid.particles)
        for (int j = 0; j < 3; ++j) particle.position[j] += particle.spacing * offset();
}

inline Mat3 someRotation() {
    return (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3::UnitY()) *
            Eigen::AngleAxisd(-0.3, Vec3::UnitZ()))
        .toRotationMatrix();
}

inline StressSolver build(std::shared_ptr<const Discretisation> solid, const Material& material,
                          const StressSettings& settings) {
    Result<StressSolver> solver = StressSolver::build(std::move(solid), material, settings);
    if (!solver) throw std::runtime_error(solver.error());  // gtest reports it as the test's failure
    return std::move(solver).value();
}

template <class T>
T valueOf(Result<T> result) {
    if (!result) throw std::runtime_error(result.error());
    return std::move(result).value();
}

/// Largest difference of any of the stresses from one tensor, relative to it.
inline double largestError(const std::vector<SymmetricTensor>& stresses, const Mat3& expected) {
    double error = 0;
    for (const SymmetricTensor& stress : stresses)
        error = std::max(error, (toMatrix(stress) - expected).norm() / expected.norm());
    return error;
}

/// Loads that spread a force evenly over the surface points that `chosen` admits, by their area.
inline std::vector<PointForce> spreadOverSurface(
    const Discretisation& solid, const Vec3& force,
    const std::function<bool(const Vec3&, const Vec3& normal)>& chosen) {
    std::vector<PointForce> loads;
    double total = 0;
    for (const SurfacePoint& point : solid.surface_points) {
        const double area = point.area.norm();
        if (area == 0 || !chosen(point.position, point.area / area)) continue;
        loads.push_back({point.position, area * force});
        total += area;
    }
    for (PointForce& load : loads) load.force /= total;
    return loads;
}

}  // namespace sherd::validation
