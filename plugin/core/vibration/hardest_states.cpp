#include "core/vibration/hardest_states.h"

#include <algorithm>
#include <cmath>

namespace sherd {

// A flexural wave of rate w has a curvature of w sqrt(m / D) times its deflection. What is not in the modes
// is at least as fast as these.
HardestStates::HardestStates(const StruckModes& modes, double rest_energy_j_n2)
    : bending_(modes.rates_rad_s * modes.work),
      rest_energy_(rest_energy_j_n2),
      rest_bending_(modes.empty() ? 0 : 2 * rest_energy_j_n2 * modes.rates_rad_s.maxCoeff()) {}

void HardestStates::look(double time_s, double force_n, const Oscillators& oscillators) {
    const double energy = oscillators.strainEnergy() + rest_energy_ * force_n * force_n;
    const double bending = (bending_ * oscillators.amplitudes()).sum() + rest_bending_ * force_n;
    const double sizes[measures] = {std::abs(bending), force_n, energy};
    for (int by = 0; by < measures; ++by)
        if (sizes[by] > largest_[by]) {
            largest_[by] = sizes[by];
            states_[by] = {time_s, force_n, oscillators.amplitudes(), energy + oscillators.kineticEnergy()};
        }
}

std::vector<VibrationState> HardestStates::take(double much_the_same_s) const {
    std::vector<VibrationState> states;
    for (int by = 0; by < measures; ++by) {
        const VibrationState& state = states_[by];
        const auto same = [&](const VibrationState& other) {
            return std::abs(state.time_s - other.time_s) < much_the_same_s;
        };
        if (largest_[by] > 0 && std::none_of(states.begin(), states.end(), same)) states.push_back(state);
    }
    return states;
}

}  // namespace sherd
