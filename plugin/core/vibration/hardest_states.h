#pragma once

#include <vector>

#include "core/vibration/modal_impact.h"
#include "core/vibration/oscillators.h"

namespace sherd {

/// Of the states of a blow those that strain the body most: by what bends it at the contact, by the force and
/// by the strain energy.
class HardestStates {
  public:
    /// `rest_energy_j_n2`: static energy at 1 N that is not in the modes.
    HardestStates(const StruckModes& modes, double rest_energy_j_n2);

    void look(double time_s, double force_n, const Oscillators& oscillators);

    /// In the order of what they were found by, without those that are much the same as an earlier one.
    std::vector<VibrationState> take(double much_the_same_s) const;

  private:
    static constexpr int measures = 3;

    Eigen::ArrayXd bending_;  ///< of the modes: the stress at the contact goes with their rates
    double rest_energy_, rest_bending_;
    double largest_[measures] = {};
    VibrationState states_[measures];
};

}  // namespace sherd
