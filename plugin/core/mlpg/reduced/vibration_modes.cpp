#include "core/mlpg/reduced/vibration_modes.h"

#include "core/linear_algebra/dense_kernels.h"
#include "core/mlpg/splines/spline_mass.h"

namespace sherd {

VibrationModes VibrationModes::make(const SplineProblem& problem, const ProperModes& proper) {
    const int count = proper.count;
    Eigen::MatrixXd modes(3L * problem.space->function_count, count);
    for (int m = 0; m < count; ++m)
        modes.col(m) = proper.displacement(Eigen::VectorXf::Unit(count, m)).cast<double>();
    const Eigen::MatrixXd momenta = massProduct(splineMass(problem.parts(), *problem.space), modes);
    const Eigen::MatrixXd transposed = modes.transpose();
    Eigen::MatrixXd mass(count, count);
    setToProduct(transposed.data(), count, momenta.data(), count, static_cast<int>(modes.rows()),
                 mass.data());
    mass = (0.5 * problem.density_kg_m3 * (mass + mass.transpose())).eval();
    Eigen::VectorXd squares(count);  // 1 / w^2, ascending
    VibrationModes vibrations;
    if (!mass.allFinite() || !symmetricEigenvectors(mass.data(), count, squares.data()) || !(squares[0] > 0))
        return vibrations;
    vibrations.rates_rad_s = squares.reverse().array().rsqrt();
    vibrations.shapes = mass.rowwise().reverse().cast<float>();
    return vibrations;
}

}  // namespace sherd
