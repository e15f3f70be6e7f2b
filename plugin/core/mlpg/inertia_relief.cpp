#include "core/mlpg/inertia_relief.h"

#include <Eigen/QR>

namespace sherd {
namespace {

/// Integrals over a cell of the six rigid motions v: of v, and of v (x - x_P)^T.
struct CellLoads {
    Eigen::Matrix<double, 3, 6> total;
    Mat3 first_moment[6];
};

CellLoads integrate(const Discretisation& solid, int cell, const RigidMotions& motions) {
    const IntegrationCell& piece = solid.cells[cell];
    const int component = motions.components.of_particle[piece.particle];
    const Vec3 offset = piece.moments.centroid - solid.particles[piece.particle].position;
    CellLoads loads;
    loads.total = piece.moments.volume * motions.at(piece.moments.centroid, component);
    for (int k = 0; k < 6; ++k) {
        loads.first_moment[k] = loads.total.col(k) * offset.transpose();
        if (k < 3) continue;
        // int (e x (x - c)) (x - c)^T = [e x] times the second moment
        const Vec3 axis = Vec3::Unit(k - 3) / motions.size[component];
        for (int j = 0; j < 3; ++j) loads.first_moment[k].col(j) += axis.cross(piece.moments.second.col(j));
    }
    return loads;
}

}  // namespace

InertiaRelief InertiaRelief::galerkin(const Discretisation& solid, const SupportGraph& supports,
                                      const TrialSpace& space, const CellGradients& cells,
                                      const RigidMotions& motions) {
    InertiaRelief relief;
    relief.forces_.setZero(motions.coefficients.rows(), 6);
    ShapeEvaluator evaluator(solid, supports, space);
    ShapeFunctions shapes;
    const int functions = space.functionsPerParticle();
    for (int particle = 0; particle < static_cast<int>(solid.particles.size()); ++particle) {
        Eigen::Matrix<double, 3, 6> total = Eigen::Matrix<double, 3, 6>::Zero();
        for (int cell : solid.particle_cells[particle]) {
            const CellLoads loads = integrate(solid, cell, motions);
            total += loads.total;
            const auto gradients = cells.ofCell(cell);
            for (int n = cells.starts[cell]; n < cells.starts[cell + 1]; ++n)
                for (int k = 0; k < functions; ++k) {
                    const Vec3 gradient =
                        gradients.col(static_cast<long>(n - cells.starts[cell]) * functions + k);
                    const long row = 3L * (static_cast<long>(cells.particles[n]) * functions + k);
                    for (int motion = 0; motion < 6; ++motion)
                        relief.forces_.block<3, 1>(row, motion) += loads.first_moment[motion] * gradient;
                }
        }
        evaluator.evaluate(solid.particles[particle].position, particle, false, shapes);
        for (size_t n = 0; n < shapes.values.size(); ++n) {
            const long function =
                static_cast<long>(shapes.particles[n / functions]) * functions + n % functions;
            relief.forces_.middleRows<3>(3 * function) += shapes.values[n] * total;
        }
    }
    relief.sumResultants(motions);
    return relief;
}

void InertiaRelief::sumResultants(const RigidMotions& motions) {
    masses_.resize(motions.components.count);
    for (int motion = 0; motion < 6; ++motion) {
        const auto sums = motions.resultants(forces_.col(motion));
        for (int component = 0; component < motions.components.count; ++component)
            masses_[component].col(motion) = sums.col(component);
    }
}

InertiaRelief InertiaRelief::splines(const Eigen::Matrix4Xd& body_moments, const RigidMotions& motions) {
    InertiaRelief relief;
    relief.forces_.setZero(motions.coefficients.rows(), 6);
    for (long function = 0; function < body_moments.cols(); ++function) {
        const double size = motions.size[motions.componentOfUnknown(3 * function)];
        const Vec3 first = body_moments.col(function).tail<3>();
        for (int k = 0; k < 3; ++k) {
            relief.forces_(3 * function + k, k) = body_moments(0, function);
            relief.forces_.block<3, 1>(3 * function, 3 + k) = Vec3::Unit(k).cross(first) / size;
        }
    }
    relief.sumResultants(motions);
    return relief;
}

InertiaRelief InertiaRelief::heaviside(const Discretisation& solid, const RigidMotions& motions) {
    InertiaRelief relief;
    relief.forces_.setZero(motions.coefficients.rows(), 6);
    relief.masses_.assign(motions.components.count, Mat6::Zero());
    for (size_t cell = 0; cell < solid.cells.size(); ++cell) {
        const IntegrationCell& piece = solid.cells[cell];
        const int component = motions.components.of_particle[piece.particle];
        const CellLoads loads = integrate(solid, static_cast<int>(cell), motions);
        relief.forces_.middleRows<3>(3L * piece.particle) += loads.total;
        // int v_k . v_l = v_k(x_P) . int v_l + grad v_k : int v_l (x - x_P)^T, exact since v_k is linear
        const Vec3& position = solid.particles[piece.particle].position;
        const Eigen::Matrix<double, 3, 6> here = motions.at(position, component);
        relief.masses_[component] += here.transpose() * loads.total;
        for (int j = 0; j < 3; ++j) {
            const Eigen::Matrix<double, 3, 6> slope = motions.at(position + Vec3::Unit(j), component) - here;
            for (int motion = 0; motion < 6; ++motion)
                relief.masses_[component].col(motion) +=
                    slope.transpose() * loads.first_moment[motion].col(j);
        }
    }
    return relief;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> InertiaRelief::balance(
    Eigen::VectorXd& forces, const Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants,
    const RigidMotions& motions) const {
    Eigen::Matrix<double, 6, Eigen::Dynamic> acceleration(6, resultants.cols());
    for (long component = 0; component < resultants.cols(); ++component)
        acceleration.col(component) =
            masses_[static_cast<size_t>(component)].completeOrthogonalDecomposition().solve(
                -resultants.col(component));
    for (long unknown = 0; unknown < forces.size(); ++unknown)
        forces[unknown] += forces_.row(unknown).dot(acceleration.col(motions.componentOfUnknown(unknown)));
    return acceleration;
}

}  // namespace sherd
