#include "core/mlpg/particle_forms/cell_strains.h"

#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int chunk_count = 32;

}  // namespace

std::vector<Mat3> displacementGradients(const CellGradients& cells, const Eigen::VectorXd& u) {
    const int cell_count = static_cast<int>(cells.starts.size()) - 1;
    std::vector<Mat3> result(cell_count);
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, cell_count);
        for (int cell = chunkBegin(chunk, chunk_count, cell_count); cell < end; ++cell) {
            const int functions = cells.functions_per_particle;
            Mat3 sum = Mat3::Zero();
            for (int n = cells.starts[cell]; n < cells.starts[cell + 1]; ++n) {
                const double* unknown = u.data() + 3L * functions * cells.particles[n];
                const double* gradient = cells.gradients.data() + 3L * functions * n;
                for (int k = 0; k < 3 * functions; k += 3)
                    sum += Eigen::Map<const Vec3>(unknown + k) *
                           Eigen::Map<const Vec3>(gradient + k).transpose();
            }
            result[cell] = sum;
        }
    });
    return result;
}

Eigen::VectorXd internalForces(const Discretisation& solid, const CellGradients& cells,
                               const std::vector<Mat3>& stresses, long unknowns) {
    constexpr int parts = 4;  // fixed, so that sums do not depend on the number of threads
    const int cell_count = static_cast<int>(cells.starts.size()) - 1;
    std::vector<Eigen::VectorXd> forces(parts);
    forEachChunk(parts, [&](int part) {
        forces[part].setZero(unknowns);
        const int end = chunkBegin(part + 1, parts, cell_count);
        for (int cell = chunkBegin(part, parts, cell_count); cell < end; ++cell) {
            const int functions = cells.functions_per_particle;
            const Mat3 weighted = solid.cells[cell].moments.volume * stresses[cell];
            for (int n = cells.starts[cell]; n < cells.starts[cell + 1]; ++n) {
                double* force = forces[part].data() + 3L * functions * cells.particles[n];
                const double* gradient = cells.gradients.data() + 3L * functions * n;
                for (int k = 0; k < 3 * functions; k += 3)
                    Eigen::Map<Vec3>(force + k) += weighted * Eigen::Map<const Vec3>(gradient + k);
            }
        }
    });
    for (int part = 1; part < parts; ++part) forces[0] += forces[part];
    return forces[0];
}

}  // namespace sherd
