#include <cmath>
#include <exception>

#include "core/mlpg/inertia_relief.h"
#include "core/mlpg/particle_forms/galerkin_stiffness.h"
#include "core/mlpg/rigid_motions.h"
#include "core/mlpg/splines/spline_stiffness.h"
#include "core/mlpg/splines/zoom.h"
#include "core/mlpg/stress_solver_impl.h"
#include "core/numerics/stopwatch.h"
#include "core/sampling/nearest_owner.h"

namespace sherd {
namespace {

/// Stiffness of supports, in (lambda + 2 mu) / h: high against the body, low against rounding.
constexpr double support_stiffness = 100;

/// A load over a larger part of the body than that is not a contact; the grid resolves it.
constexpr double of_body = 0.2;

constexpr double first_doubtful_poisson_ratio = 0.47;

/// Of the stiffness of damaged material.
constexpr double damaged_share = 1e-4;

/// Per part, what is left of its stiffness; empty if nothing is damaged.
std::vector<double> stiffnessShares(const Discretisation& solid, const std::vector<char>& damaged) {
    std::vector<double> shares;
    if (damaged.empty()) return shares;
    for (const CellPart& part : solid.parts.parts)
        shares.push_back(damaged[nearestOwner(solid, solid.parts.centroid(part))] ? damaged_share : 1);
    return shares;
}

Eigen::Matrix3d spinGradient(const Vec3& w) {
    return w * w.transpose() - w.squaredNorm() * Mat3::Identity();
}

/// Galerkin on splines. Bodies without supports have their rigid motions removed by holding six unknowns a
/// component, which carries no reaction since loads are balanced.
class SplineSolver : public StressSolver::Impl {
  public:
    SplineSolver(std::shared_ptr<const Discretisation> solid, const Material& material, int degree,
                 const StressSettings& settings, const std::vector<SupportPoint>& supports,
                 const std::vector<char>& damaged)
        : solid_(std::move(solid)),
          parts_(solid_->parts),
          elasticity_(material),
          density_(material.density_kg_m3),
          poisson_ratio_(material.poisson_ratio),
          space_pointer_(std::make_shared<SplineSpace>(parts_, degree)),
          space_(*space_pointer_),
          motions_(parts_, space_),
          supported_(space_.component_count, 0),
          shares_(stiffnessShares(*solid_, damaged)),
          // Zooms know whole material only.
          rounds_(damaged.empty() ? settings.resampling_rounds : 0),
          zoom_margin_(settings.resampling_margin),
          body_moments_(gatherMoments()),
          inertia_(InertiaRelief::splines(body_moments_, motions_)) {
        const double stiffness =
            support_stiffness * (elasticity_.lambda_pa + 2 * elasticity_.mu_pa) / parts_.edges.maxCoeff();
        for (const SupportPoint& support : supports) {
            if (parts_.partAt(support.position) < 0)
                throw std::invalid_argument("a support lies beside the solid.");
            supports_.push_back({support.position, stiffness * support.area_m2});
        }
        for (const Particle& particle : solid_->particles)
            located_.push_back(locate(parts_, particle.position));
        for (const SurfacePoint& point : solid_->surface_points)
            located_.push_back(locate(parts_, point.position));
        springs_ = springsOf(parts_, supports_);
        for (const PointSpring& spring : springs_) supported_[space_.component_of_part[spring.part]] = 1;
        checkSupports();
    }

    Status factor() {
        Stopwatch watch;
        stiffness_ = splineStiffness(parts_, space_, elasticity_, springs_, shares_);
        SparseMatrix held = stiffness_;
        for (const int unknown : unknownsToPin(motions_))
            if (!supported_[motions_.componentOfUnknown(unknown)]) pinned_.push_back(unknown);
        pinUnknowns(held, pinned_);
        report.assemble_ms = watch.milliseconds();
        Stopwatch factor_watch;
        Result<std::unique_ptr<SparseSolver>> solver = factorCholesky(held, 3);
        report.factor_ms = factor_watch.milliseconds();
        if (!solver) return Error{solver.error()};
        solver_ = std::move(solver).value();
        if (poisson_ratio_ > first_doubtful_poisson_ratio)
            report.warnings.push_back(
                "Poisson's ratio is near 0.5, where displacements barely tell the pressure: stress may be "
                "off by a "
                "tenth and more; use a higher quality, or 0.47.");
        report.unknowns = stiffness_.size;
        report.factor_entries = solver_->factorEntries();
        report.reciprocal_condition = solver_->reciprocalCondition();
        if (solver_->relativeShift() > 0)
            report.warnings.push_back(
                "The stiffness matrix is singular beyond the rigid motions, and a small stiffness was added "
                "to every "
                "unknown; try another spacing.");
        return success();
    }

    Result<StressField> solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points,
                              const Vec3& spin_rad_s) const override {
        const Stopwatch watch;
        Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, space_.raw_count);
        std::vector<double> values;
        double magnitude = 0;
        for (const PointForce& load : loads) {
            if (!load.force.allFinite() || !load.position.allFinite())
                return Error{"A load on the body is not finite; check the contact that it came from."};
            const int part = parts_.partAt(load.position);
            if (part < 0)
                return Error{
                    "A load acts more than a particle spacing outside the body; give it in the asset's "
                    "frame."};
            splineValues(space_.degree, parts_.toCell(load.position, parts_.parts[part].cell), values);
            const std::vector<int>& functions = space_.raw_of[part];
            for (size_t a = 0; a < functions.size(); ++a) raw.col(functions[a]) += values[a] * load.force;
            magnitude += load.force.norm();
        }
        Eigen::VectorXd forces = space_.gather(raw);
        if (spin_rad_s.norm() > 0) magnitude += addSpin(spin_rad_s, forces);
        return solveForces(std::move(forces), magnitude, points, watch, loads, spin_rad_s);
    }

    Result<StressField> solveTraction(
        const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
        const std::vector<Vec3>& points) const override {
        std::vector<PointForce> loads;
        for (const SurfacePoint& point : solid_->surface_points) {
            const double area = point.area.norm();
            if (area > 0)
                loads.push_back({point.position, area * traction(point.position, point.area / area)});
        }
        return solve(loads, points, Vec3::Zero());
    }

    StressField stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                         const std::function<Mat3(const Vec3& x)>&) const override {
        Eigen::VectorXd unknowns(stiffness_.size);
        for (int f = 0; f < space_.function_count; ++f)
            unknowns.segment<3>(3L * f) = displacement(space_.centres[f]);
        StressField field;
        evaluate(fieldOf(unknowns), {}, {}, field);
        return field;
    }

  private:
    SplineField fieldOf(const Eigen::VectorXd& unknowns) const {
        return {std::shared_ptr<const CellParts>(solid_, &parts_), space_pointer_, space_.expand(unknowns)};
    }

    /// Supports have to hold all six rigid motions of what they hold at all: those of a point or a line leave
    /// it free to turn.
    void checkSupports() const {
        constexpr double smallest_hold = 1e-6;  // of the weakest held motion over the strongest
        std::vector<Eigen::Matrix<double, 6, 6>> holds(static_cast<size_t>(space_.component_count),
                                                       Eigen::Matrix<double, 6, 6>::Zero());
        for (size_t i = 0; i < springs_.size(); ++i) {
            const int component = space_.component_of_part[springs_[i].part];
            const Eigen::Matrix<double, 3, 6> motion = motions_.at(supports_[i].position, component);
            holds[static_cast<size_t>(component)] += springs_[i].stiffness_n_m * motion.transpose() * motion;
        }
        for (int component = 0; component < space_.component_count; ++component) {
            if (!supported_[component]) continue;
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(holds[component],
                                                                                    Eigen::EigenvaluesOnly);
            if (solver.eigenvalues()[0] < smallest_hold * solver.eigenvalues()[5])
                throw std::invalid_argument(
                    "the supports lie in a point or on a line, so that the body is free to turn about it; "
                    "hold a larger part.");
        }
    }

    Eigen::Matrix4Xd gatherMoments() const {
        std::vector<Vec3> origins;
        for (const int component : space_.component_of_part)
            origins.push_back(motions_.moments[component].centroid);
        const Eigen::Matrix4Xd raw = splineBodyMoments(parts_, space_, origins);
        Eigen::Matrix4Xd sums = Eigen::Matrix4Xd::Zero(4, space_.function_count);
        for (int r = 0; r < space_.raw_count; ++r)
            for (int k = space_.term_starts[r]; k < space_.term_starts[r + 1]; ++k)
                sums.col(space_.terms[k].function) += space_.terms[k].factor * raw.col(r);
        return sums;
    }

    /// The forces of rigid acceleration and spin, per part.
    std::vector<AffineForce> bodyForces(const Eigen::Matrix<double, 6, Eigen::Dynamic>& acceleration,
                                        const Vec3& spin) const {
        std::vector<AffineForce> forces;
        for (const int component : space_.component_of_part) {
            AffineForce force;
            const Vec3 angular = acceleration.col(component).tail<3>() / motions_.size[component];
            force.value = acceleration.col(component).head<3>();
            for (int j = 0; j < 3; ++j) force.gradient.col(j) = angular.cross(Vec3::Unit(j));
            force.gradient -= density_ * spinGradient(spin);
            force.about = motions_.moments[component].centroid;
            forces.push_back(force);
        }
        return forces;
    }

    /// Finer and finer grids around the loads, coarser ones first.
    Result<std::vector<Zoom>> resample(const SplineField& whole, const BodyLoads& loads) const {
        const double largest_patch = of_body * parts_.count.cast<double>().cwiseProduct(parts_.edges).norm();
        std::vector<Zoom> zooms;
        size_t begin = 0;  // of the zooms of the round before
        for (int round = 0; round < rounds_; ++round) {
            const size_t end = zooms.size();
            for (size_t parent = begin; parent < (round == 0 ? 1 : end); ++parent) {
                const BodyLoads acting = round == 0 ? loads : zooms[parent].loads;
                const CellParts& grid = round == 0 ? parts_ : *zooms[parent].field.parts;
                for (const CellBox& box :
                     boxesAroundLoads(grid, acting.forces, largest_patch, zoom_margin_)) {
                    Result<Zoom> zoom = zoomIn(*solid_->surface, round == 0 ? whole : zooms[parent].field,
                                               box, elasticity_, acting, supports_);
                    if (!zoom) return Error{zoom.error()};
                    zooms.push_back(std::move(zoom).value());
                }
            }
            begin = end;
        }
        return zooms;
    }

    /// Adds the inertia loads of a steady rotation, -rho w x (w x r).
    double addSpin(const Vec3& spin, Eigen::VectorXd& forces) const {
        const Mat3 gradient = -density_ * spinGradient(spin);
        double magnitude = 0;
        for (long f = 0; f < body_moments_.cols(); ++f) {
            const Vec3 force = gradient * body_moments_.col(f).tail<3>();
            forces.segment<3>(3 * f) += force;
            magnitude += force.norm();
        }
        return magnitude;
    }

    Result<StressField> solveForces(Eigen::VectorXd forces, double magnitude, const std::vector<Vec3>& points,
                                    const Stopwatch& watch, const std::vector<PointForce>& loads,
                                    const Vec3& spin) const {
        Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = motions_.resultants(forces);
        for (int component = 0; component < space_.component_count; ++component)
            if (supported_[component]) resultants.col(component).setZero();
        const auto acceleration = inertia_.balance(forces, resultants, motions_);

        StressField field;
        Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(forces.size());
        const double scale = forces.norm();
        if (scale > 0) {
            const Status solved = solveRefined(forces, scale, unknowns, field.residual_rel);
            if (!solved) return Error{solved.error()};
        }
        const SplineField whole = fieldOf(unknowns);
        const Result<std::vector<Zoom>> zooms = resample(whole, {loads, bodyForces(acceleration, spin)});
        if (!zooms) return Error{zooms.error()};
        for (const Zoom& zoom : zooms.value()) field.resampling_entries += zoom.stiffness_entries;
        field.solve_ms = watch.milliseconds();
        const Stopwatch recovery_watch;
        evaluate(whole, points, zooms.value(), field);
        field.recovery_ms = recovery_watch.milliseconds();
        field.strain_energy_j = 0.5 * unknowns.dot(forces);
        if (magnitude > 0) {
            Eigen::Matrix<double, 6, Eigen::Dynamic> left = motions_.resultants(forces);
            for (int component = 0; component < space_.component_count; ++component)
                if (supported_[component]) left.col(component).setZero();
            field.imbalance_rel = left.cwiseAbs().maxCoeff() / magnitude;
        }
        field.warnings = report.warnings;
        constexpr double largest_good_residual = 1e-6;
        if (!(field.residual_rel < largest_good_residual))
            field.warnings.push_back("The linear solve left a residual of " +
                                     std::to_string(field.residual_rel) +
                                     " of the load; do the supports hold the body well?");
        return finiteOrError(std::move(field));
    }

    /// Refinement mends what the factorisation lost to a shifted diagonal or a bad condition; mostly it never
    /// runs.
    Status solveRefined(const Eigen::VectorXd& forces, double scale, Eigen::VectorXd& unknowns,
                        double& residual_rel) const {
        constexpr double good_residual = 1e-10;
        constexpr int largest_refinements = 5;
        residual_rel = 1;
        Eigen::VectorXd residual = forces, correction;
        for (int step = 0; step <= largest_refinements && residual_rel > good_residual; ++step) {
            for (const int unknown : pinned_) residual[unknown] = 0;
            if (!solver_->solve(residual, correction))
                return Error{"The stress solve failed in the linear solver."};
            const Eigen::VectorXd next = unknowns + correction;
            residual = forces - symmetricProduct(stiffness_, next);
            const double next_rel = residual.norm() / scale;
            if (step > 0 && !(next_rel < residual_rel)) break;
            unknowns = next;
            residual_rel = next_rel;
        }
        return success();
    }

    void evaluate(const SplineField& whole, const std::vector<Vec3>& points, const std::vector<Zoom>& zooms,
                  StressField& field) const {
        double spacing = 0;  // of the grid that was read last
        const auto stress_at = [&](const Vec3& x, const GridPoint& on_whole) -> Voigt {
            Mat3 gradient;
            for (size_t z = zooms.size(); z-- > 0;)
                if (displacementGradient(zooms[z], x, gradient)) {
                    spacing = zooms[z].field.parts->edges.maxCoeff();
                    return toVoigt(elasticity_.stress(gradient));
                }
            spacing = parts_.edges.maxCoeff();
            if (on_whole.part < 0) return Voigt::Zero();
            const Voigt stress = toVoigt(elasticity_.stress(gradientOn(whole, on_whole.part, on_whole.xi)));
            return shares_.empty() ? stress : Voigt(shares_[on_whole.part] * stress);
        };
        field.particles.reserve(solid_->particles.size());
        field.surface.reserve(solid_->surface_points.size());
        size_t located = 0;
        for (const Particle& particle : solid_->particles)
            field.particles.push_back(stress_at(particle.position, located_[located++]));
        for (const SurfacePoint& point : solid_->surface_points)
            field.surface.push_back(stress_at(point.position, located_[located++]));
        for (const Vec3& point : points) {
            field.points.push_back(stress_at(point, locate(parts_, point)));
            field.point_spacing_m.push_back(spacing);
        }
    }

    std::shared_ptr<const Discretisation> solid_;
    const CellParts& parts_;
    Elasticity elasticity_;
    double density_;
    double poisson_ratio_;
    std::shared_ptr<const SplineSpace> space_pointer_;
    const SplineSpace& space_;
    RigidMotions motions_;
    std::vector<char> supported_;  // per component
    std::vector<SupportSpring> supports_;
    std::vector<PointSpring> springs_;
    std::vector<double> shares_;  // of the stiffness, per part; empty: all of it
    int rounds_;
    double zoom_margin_;
    std::vector<GridPoint> located_;  // particles, then surface points
    Eigen::Matrix4Xd body_moments_;
    InertiaRelief inertia_;
    SparseMatrix stiffness_;
    std::vector<int> pinned_;
    std::unique_ptr<SparseSolver> solver_;
};

}  // namespace

Result<std::unique_ptr<StressSolver::Impl>> StressSolver::Impl::overSplines(
    std::shared_ptr<const Discretisation> solid, const Material& material, const StressSettings& settings,
    const std::vector<SupportPoint>& supports, const std::vector<char>& damaged) {
    const int degree = splineDegree(settings.basis);
    if (solid->parts.order < 2 * degree)
        return Error{"The solid was sampled with moments of order " + std::to_string(solid->parts.order) +
                     "; splines of degree " + std::to_string(degree) + " need " + std::to_string(2 * degree) +
                     "."};
    auto solver =
        std::make_unique<SplineSolver>(std::move(solid), material, degree, settings, supports, damaged);
    if (const Status factored = solver->factor(); !factored) return Error{factored.error()};
    return std::unique_ptr<Impl>(std::move(solver));
}

}  // namespace sherd
