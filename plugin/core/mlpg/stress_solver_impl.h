#pragma once

#include "core/mlpg/stress_solver.h"

namespace sherd {

/// What stands behind a StressSolver: one class for each kind of trial space.
struct StressSolver::Impl {
    StressSolverReport report;

    virtual ~Impl() = default;
    virtual Result<StressField> solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points,
                                      const Vec3& spin_rad_s) const = 0;
    virtual Result<double> strainEnergy(const std::vector<PointForce>& loads) const {
        const Result<StressField> stress = solve(loads, {}, Vec3::Zero());
        if (!stress) return Error{stress.error()};
        return stress.value().strain_energy_j;
    }
    virtual Result<StressField> solveContact(const ContactField&) const {
        return Error{"Near fields are there for spline trial functions only."};
    }
    virtual Result<StressField> stressOfUnknowns(const Eigen::VectorXd&, const ContactField&) const {
        return Error{"Unknowns are read for spline trial functions only."};
    }
    virtual Result<StressField> solveTraction(
        const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
        const std::vector<Vec3>& points) const = 0;
    virtual StressField stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                                 const std::function<Mat3(const Vec3& x)>& gradient) const = 0;
    virtual Result<std::shared_ptr<const ReducedStress>> reduced(const Progress&) const {
        return Error{"A reduced model is there for spline trial functions only."};
    }

    static Result<std::unique_ptr<Impl>> overParticles(std::shared_ptr<const Discretisation> solid,
                                                       const Material& material,
                                                       const StressSettings& settings);
    static Result<std::unique_ptr<Impl>> overSplines(std::shared_ptr<const Discretisation> solid,
                                                     const Material& material, const StressSettings& settings,
                                                     const std::vector<SupportPoint>& supports,
                                                     const std::vector<char>& damaged, Precision precision);
};

/// The error of a field that is not finite, or the field.
Result<StressField> finiteOrError(StressField field);

}  // namespace sherd
