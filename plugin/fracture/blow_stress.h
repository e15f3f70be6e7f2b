#pragma once

#include <sherd/outcome.h>
#include <sherd/result.h>
#include <sherd/stress_field.h>

#include <vector>

#include "core/loads/contact_loads.h"
#include "core/loads/contact_pulse.h"
#include "core/mlpg/stress_solver.h"
#include "fracture/strike_context.h"

namespace sherd {

/// The stress of a blow at the peak of its pulse: `unit` times `pulse.peak_force_n`.
struct BlowStress {
    StressField unit;  ///< under loads of 1 N in total
    ContactPulse pulse;
    double strain_energy_j = 0;  ///< at the peak
};

/// Stress under loads of 1 N in total, with free surfaces free of traction. Adds the times to `ms`.
Result<StressField> unitStress(const StrikeContext& struck, const StressSolver& solver,
                               const std::vector<PointForce>& unit_loads, StageTimes& ms);

/// The same, and the pulse that body and contact make of the blow together.
Result<BlowStress> blowStress(const StrikeContext& struck, const StressSolver& solver,
                              const ContactLoads& loads, StageTimes& ms);

}  // namespace sherd
