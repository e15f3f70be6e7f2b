#include "core/mlpg/particle_forms/particle_inertia.h"

namespace sherd {
namespace {

/// Integrals over a cell of the six rigid motions v: of v, and of v (x - x_P)^T.
struct CellLoads {
    Eigen::Matrix<double, 3, 6> total;
    Mat3 first_moment[6];
};

CellLoads integrate(const Discretisation& solid, int cell, const RigidMotions& motions) {
    const IntegrationCell& piece = solid.cells[cell];
    const int component = motions.component_of_node[piece.particle];
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

InertiaRelief galerkinInertia(const StressProblem& problem) {
    const Discretisation& solid = problem.solid;
    const CellGradients& cells = problem.cells;
    InertiaRelief::Forces forces = InertiaRelief::Forces::Zero(problem.unknowns(), 6);
    ShapeEvaluator evaluator(solid, problem.supports, problem.space);
    ShapeFunctions shapes;
    const int functions = problem.space.functionsPerParticle();
    for (int particle = 0; particle < static_cast<int>(solid.particles.size()); ++particle) {
        Eigen::Matrix<double, 3, 6> total = Eigen::Matrix<double, 3, 6>::Zero();
        for (int cell : solid.particle_cells[particle]) {
            const CellLoads loads = integrate(solid, cell, problem.motions);
            total += loads.total;
            const auto gradients = cells.ofCell(cell);
            for (int n = cells.starts[cell]; n < cells.starts[cell + 1]; ++n)
                for (int k = 0; k < functions; ++k) {
                    const Vec3 gradient =
                        gradients.col(static_cast<long>(n - cells.starts[cell]) * functions + k);
                    const long row = 3L * (static_cast<long>(cells.particles[n]) * functions + k);
                    for (int motion = 0; motion < 6; ++motion)
                        forces.block<3, 1>(row, motion) += loads.first_moment[motion] * gradient;
                }
        }
        evaluator.evaluate(solid.particles[particle].position, particle, false, shapes);
        for (size_t n = 0; n < shapes.values.size(); ++n) {
            const long function =
                static_cast<long>(shapes.particles[n / functions]) * functions + n % functions;
            forces.middleRows<3>(3 * function) += shapes.values[n] * total;
        }
    }
    return InertiaRelief(std::move(forces), problem.motions);
}

InertiaRelief heavisideInertia(const StressProblem& problem) {
    const Discretisation& solid = problem.solid;
    const RigidMotions& motions = problem.motions;
    InertiaRelief::Forces forces = InertiaRelief::Forces::Zero(problem.unknowns(), 6);
    std::vector<InertiaRelief::Mat6> masses(motions.componentCount(), InertiaRelief::Mat6::Zero());
    for (size_t cell = 0; cell < solid.cells.size(); ++cell) {
        const IntegrationCell& piece = solid.cells[cell];
        const int component = motions.component_of_node[piece.particle];
        const CellLoads loads = integrate(solid, static_cast<int>(cell), motions);
        forces.middleRows<3>(3L * piece.particle) += loads.total;
        // int v_k . v_l = v_k(x_P) . int v_l + grad v_k : int v_l (x - x_P)^T, exact since v_k is linear
        const Vec3& position = solid.particles[piece.particle].position;
        const Eigen::Matrix<double, 3, 6> here = motions.at(position, component);
        masses[component] += here.transpose() * loads.total;
        for (int j = 0; j < 3; ++j) {
            const Eigen::Matrix<double, 3, 6> slope = motions.at(position + Vec3::Unit(j), component) - here;
            for (int motion = 0; motion < 6; ++motion)
                masses[component].col(motion) += slope.transpose() * loads.first_moment[motion].col(j);
        }
    }
    return InertiaRelief(std::move(forces), std::move(masses));
}

}  // namespace sherd
