#include "core/vibration/hardest_states.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sherd {

// A flexural wave of rate w has a curvature of w sqrt(m / D) times its deflection. What is not in the modes
// is at least as fast as these.
HardestStates::HardestStates(const StruckModes& modes, double rest_energy_j_n2, bool at_places)
    : modes_(modes),
      bending_(modes.rates_rad_s * modes.work),
      rest_energy_(rest_energy_j_n2),
      rest_bending_(modes.empty() ? 0 : 2 * rest_energy_j_n2 * modes.rates_rad_s.maxCoeff()),
      hottest_pa_(Eigen::VectorXd::Zero(at_places ? modes.hot_pa.rows() : 0)),
      hottest_state_(static_cast<std::size_t>(hottest_pa_.size())) {}

Eigen::VectorXd HardestStates::stressOf(const Eigen::ArrayXd& amplitudes) const {
    return (modes_.hot_pa * amplitudes.head(modes_.hot_pa.cols()).matrix()).cwiseAbs();
}

void HardestStates::look(double time_s, double force_n, const Oscillators& oscillators) {
    const double energy = oscillators.strainEnergy() + rest_energy_ * force_n * force_n;
    const double bending = (bending_ * oscillators.amplitudes()).sum() + rest_bending_ * force_n;
    const double sizes[measures] = {std::abs(bending), force_n, energy};
    const auto now = [&] {
        return VibrationState{time_s, force_n, oscillators.amplitudes(),
                              energy + oscillators.kineticEnergy()};
    };
    for (int by = 0; by < measures; ++by)
        if (sizes[by] > largest_[by]) {
            largest_[by] = sizes[by];
            states_[by] = now();
        }
    if (hottest_pa_.size() == 0) return;
    const Eigen::VectorXd stress = stressOf(oscillators.amplitudes());
    if ((stress.array() <= hottest_pa_.array()).all()) return;
    for (Eigen::Index place = 0; place < stress.size(); ++place)
        if (stress[place] > hottest_pa_[place]) {
            hottest_pa_[place] = stress[place];
            hottest_state_[place] = hot_states_.size();
        }
    hot_states_.push_back(now());
}

std::vector<VibrationState> HardestStates::take(double much_the_same_s) const {
    constexpr double slightly_more = 1.03, little_more = 1.2;  // times the stress that others have
    constexpr double matters = 0.5;                            // of the largest
    constexpr std::size_t most = measures + 1;
    std::vector<VibrationState> states;
    for (int by = 0; by < measures; ++by) {
        const VibrationState& state = states_[by];
        const auto same = [&](const VibrationState& other) {
            return std::abs(state.time_s - other.time_s) < much_the_same_s;
        };
        if (largest_[by] > 0 && std::none_of(states.begin(), states.end(), same)) states.push_back(state);
    }
    if (hot_states_.empty()) return states;
    Eigen::VectorXd taken = Eigen::VectorXd::Zero(hottest_pa_.size());
    for (const VibrationState& state : states) taken = taken.cwiseMax(stressOf(state.modes));
    const auto takeHottestAt = [&](Eigen::Index place) {
        states.push_back(hot_states_[hottest_state_[place]]);
        taken = taken.cwiseMax(stressOf(states.back().modes));
    };
    Eigen::Index place = 0;
    const double hottest = hottest_pa_.maxCoeff(&place);
    if (hottest > slightly_more * taken.maxCoeff()) takeHottestAt(place);
    while (states.size() < most) {
        const double more = (hottest_pa_.array() > little_more * taken.array())
                                .select(hottest_pa_, Eigen::VectorXd::Zero(taken.size()))
                                .maxCoeff(&place);
        if (!(more > matters * hottest)) break;
        takeHottestAt(place);
    }
    return states;
}

}  // namespace sherd
