#pragma once

#include <sherd/events.h>

#include <string>
#include <vector>

#include "fracture/fragments.h"

namespace sherd {

/// What came of a blow. The figures are members of BreakEvent, which explains them.
struct BlowOutcome {
    BreakEvent::Outcome outcome = BreakEvent::Outcome::held;
    std::vector<Fragment> fragments;  ///< empty unless it broke
    double impulse_n_s = 0, peak_force_n = 0, contact_time_s = 0, largest_stress_pa = 0;
    double mass_error_rel = 0, volume_error_rel = 0, residual_rel = 0;
    int damaged_particles = 0;
    StageTimes ms;
    std::string message;
};

}  // namespace sherd
