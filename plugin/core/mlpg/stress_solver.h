#pragma once

#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/stress_field.h>

#include <functional>
#include <memory>
#include <vector>

#include "core/linear_algebra/cholesky_solver.h"
#include "core/sampling/discretisation.h"

namespace sherd {

struct ReducedStress;
struct ContactField;

/// Is told the share that is done, 0 to 1.
using Progress = std::function<void(double done)>;

/// What building the solver took and gave.
struct StressSolverReport {
    double assemble_ms = 0;
    double factor_ms = 0;
    int unknowns = 0;
    long long factor_entries = 0, factor_bytes = 0;
    double reciprocal_condition = 0;  ///< estimate from the factor's diagonal; 1e-16 is as good as singular
    std::vector<std::string> warnings;
};

/// One quadrature point of an anchored part of the surface: there the displacement is held at zero (paper,
/// Eq. 3 and 15).
struct SupportPoint {
    Vec3 position = Vec3::Zero();  ///< m
    double area_m2 = 0;
};

/// Quasi-static stress in a free body (paper, section 4): K assembled and factored once, then two triangular
/// solves a blow. Loads are balanced by rigid acceleration (inertia relief) with the same quadrature that
/// builds K.
class StressSolver {
  public:
    /// `damaged` (#particles, or empty: none) marks particles that carry no stress: a ten-thousandth of their
    /// stiffness keeps what they hold together from drifting. Splines only, as `precision`: full is for what
    /// solves a thousand loads (`reduced`).
    static Result<StressSolver> build(std::shared_ptr<const Discretisation> solid, const Material& material,
                                      const StressSettings& settings,
                                      const std::vector<SupportPoint>& supports = {},
                                      const std::vector<char>& damaged = {},
                                      Precision precision = Precision::refined);

    StressSolver(StressSolver&&) noexcept;
    StressSolver& operator=(StressSolver&&) noexcept;
    ~StressSolver();

    /// Stress under point forces (quadrature points of tractions) and the rigid acceleration that balances
    /// them; also at `points` in or on the solid, if any are given.
    /// A spin adds the inertia loads of a steady rotation about the centre of mass.
    Result<StressField> solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points = {},
                              const Vec3& spin_rad_s = Vec3::Zero()) const;

    /// The strain energy alone under point forces, J.
    Result<double> strainEnergy(const std::vector<PointForce>& loads) const;

    /// Stress under contacts whose near field is known in closed form: the grid has to find the rest only.
    /// Its `points` are the places of the contacts. Surfaces have the traction that acts on them, but for
    /// those near the loads that no disc stands for. The strain energy is not found. Splines only.
    Result<StressField> solveContact(const ContactField& contact) const;
    /// The stress of a displacement (#unknowns, m) as solve and solveContact read it, with no load acting: at
    /// the particles, at the surface, free of traction but near the loads of `contact`, and at its places.
    Result<StressField> stressOfUnknowns(const Eigen::VectorXd& unknowns, const ContactField& contact) const;

    /// Stress under tractions t(x, n) on the whole surface, integrated with the cells' own surface points.
    Result<StressField> solveTraction(
        const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
        const std::vector<Vec3>& points = {}) const;

    /// Stress that the displacement field u(x) makes when sampled at the particles, without a solve.
    StressField stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                         const std::function<Mat3(const Vec3& x)>& gradient) const;

    /// What answers blows without this solver, see ReducedStress. Spline trial functions without damaged
    /// particles only.
    Result<std::shared_ptr<const ReducedStress>> reduced(const Progress& progress = {}) const;

    const StressSolverReport& report() const;

    struct Impl;

  private:
    explicit StressSolver(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace sherd
