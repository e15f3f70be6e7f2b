#pragma once

#include <sherd/stress_field.h>

#include <functional>

#include "core/mlpg/reduced/reduced_model.h"

namespace sherd {

/// The stress of a displacement, #unknowns.
using StressOfUnknowns = std::function<Result<StressField>(const Eigen::VectorXd& unknowns)>;

/// Where the slowest vibrations strain a body, alone and together: at the root of what stands out, all along
/// a rod. Up to `VibrationModes::most_hot_places` places, which differ most in how the vibrations strain
/// them. Returns the stress that each of them (columns) has there (rows), along the direction in which one of
/// them pulls or presses most, over its amplitude, Pa / J^(1/2). Empty if nothing is known of them.
Eigen::MatrixXf hotPlaces(const ReducedModel& model, const StressOfUnknowns& stress_of);

}  // namespace sherd
