#pragma once

#include <sherd/material.h>

#include <memory>

#include "core/mlpg/reduced/reduced_stress.h"

namespace sherd {

/// What answers blows on a solid without a factor, and the sampling that goes with it.
struct KeptModel {
    std::shared_ptr<const Discretisation> sampling;
    std::shared_ptr<const ReducedStress> reduced;
};

/// The same model as a file would give it back, in half the memory: it answers with the same bits. The one
/// that it is given where a file could not hold it.
KeptModel asKept(const KeptModel& made, const Material& material);

}  // namespace sherd
