#pragma once

#include <vector>

#include "core/vibration/modal_impact.h"
#include "core/vibration/oscillators.h"

namespace sherd {

/// Of the states of a blow those that strain the body most: by what bends it at the contact, by the force and
/// by the strain energy, and those of a body that rings also by the stress at places that vibrations strain,
/// as at the root of what stands out.
class HardestStates {
  public:
    /// `rest_energy_j_n2`: static energy at 1 N that is not in the modes.
    /// `at_places`: whether by the stress there, too.
    HardestStates(const StruckModes& modes, double rest_energy_j_n2, bool at_places);

    void look(double time_s, double force_n, const Oscillators& oscillators);

    /// In the order of what they were found by, without those that are much the same as an earlier one. At
    /// places that is the hottest of all, unless another has nearly its stress, and then those that have much
    /// more than others somewhere.
    std::vector<VibrationState> take(double much_the_same_s) const;

  private:
    static constexpr int measures = 3;

    Eigen::VectorXd stressOf(const Eigen::ArrayXd& amplitudes) const;

    const StruckModes& modes_;
    Eigen::ArrayXd bending_;  ///< of the modes: the stress at the contact goes with their rates
    double rest_energy_, rest_bending_;
    double largest_[measures] = {};
    VibrationState states_[measures];
    Eigen::VectorXd hottest_pa_;              ///< the largest stress at each place
    std::vector<std::size_t> hottest_state_;  ///< numbers of the states that have it
    std::vector<VibrationState> hot_states_;
};

}  // namespace sherd
