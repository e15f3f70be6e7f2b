#pragma once

#include <string>
#include <vector>

#include "core/mlpg/reduced/damage_reading.h"
#include "core/mlpg/reduced/peak_table.h"
#include "core/mlpg/reduced/reduced_model.h"

namespace sherd {

/// What an asset keeps to answer blows without a factor.
struct ReducedStress {
    ReducedModel model;
    DamageReading reading;
    PeakTable peaks;
    std::vector<std::string> warnings;  ///< what limits trust in the stress, with the remedy
};

}  // namespace sherd
