#pragma once

#include <vector>

#include "core/loads/contact_pulse.h"
#include "core/vibration/struck_modes.h"

namespace sherd {

/// A body at one moment of a blow.
struct VibrationState {
    double time_s = 0;     ///< after the first touch
    double force_n = 0;    ///< of the contact
    Eigen::ArrayXd modes;  ///< amplitudes, J^(1/2)
    double energy_j = 0;   ///< of strain, and of the vibrations' motion, which becomes strain in turn
    /// It rings with less than a tenth of the strain of the contact.
    bool is_faint = false;
};

/// What a contact that vibrations answer comes to.
struct ModalImpact {
    /// The largest force, and how long half a sine wave takes that has it and the same momentum.
    ContactPulse pulse;
    /// The states that strain the body most (HardestStates): while something presses on it, and in the first
    /// swing of its slowest mode after that.
    std::vector<VibrationState> pressed, ringing;
};

/// What a contact feels of a body.
struct StruckBody {
    StruckModes modes;
    double strain_energy_j_n2 = 0;  ///< of the body at 1 N, statically
    double patch_energy_j_n2 = 0;   ///< part of it that the Hertz contact stores
    double others_energy_j_n2 = 0;  ///< of other bodies that the force goes through
};

/// Whether a contact of that duration is so long that a body follows it statically: its slowest mode then
/// does to within a twentieth. A period of 0: nothing is known of its vibrations.
bool isQuasiStatic(double slowest_period_s, double duration_s);

/// A mass that strikes a body through a Hertz contact. The body gives way by its modes, each an oscillator
/// under the force of the contact, and statically by what is stiffer than these. So a wall that is struck for
/// a short time takes up as much as the flexural wave has set going by then (compare C. Zener, Phys. Rev. 59
/// (1941) 669), and under a long contact it bends as a whole. `shortest_s`: a contact between bodies that are
/// otherwise rigid takes as long at least, which softens it.
ModalImpact modalImpact(const Impact& impact, const StruckBody& body, double shortest_s);

}  // namespace sherd
