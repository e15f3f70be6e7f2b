#include "core/clustering/wall_axes.h"

#include <Eigen/Eigenvalues>

namespace sherd {

namespace {

constexpr double most = 0.7;  // least part of the surface around a particle that faces along the axis
constexpr int rounds = 3;     // in which particles without surface take that of their neighbours

}  // namespace

std::vector<Vec3> wallAxes(const Discretisation& solid) {
    const std::size_t count = solid.particles.size();
    std::vector<Mat3> facing = solid.facing;
    facing.resize(count, Mat3::Zero());  // a solid without surface has none
    for (int round = 0; round < rounds; ++round) {
        std::vector<Mat3> filled = facing;
        for (std::size_t i = 0; i < count; ++i)
            if (facing[i].isZero(0))
                for (const int j : solid.neighbours[i]) filled[i] += facing[j];
        facing = std::move(filled);
    }
    std::vector<Vec3> axes(count, Vec3::Zero());
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(facing[i]);
        if (solver.eigenvalues()[2] > most * solver.eigenvalues().sum())
            axes[i] = solver.eigenvectors().col(2);
    }
    return axes;
}

}  // namespace sherd
