#pragma once

#include "core/vibration/struck_modes.h"

namespace sherd {

/// The modes of a body under a force that is even over each step, for which each swings about its static
/// amplitude: steps of any length are exact. Those of the loads are damped (StruckModes).
class Oscillators {
  public:
    explicit Oscillators(const StruckModes& modes)
        : modes_(modes),
          damping_(Eigen::ArrayXd::Zero(modes.work.size())),
          amplitudes_(damping_),
          velocities_(damping_) {
        damping_.tail(modes.ritz_vectors.cols()) = StruckModes::ritz_damping;
    }

    void setStep(double step_s) {
        const Eigen::ArrayXd slower = (1 - damping_.square()).sqrt();
        const Eigen::ArrayXd angle = modes_.rates_rad_s * step_s;
        const Eigen::ArrayXd left = (-damping_ * angle).exp();
        const Eigen::ArrayXd cosines = left * (slower * angle).cos();
        sines_ = left * (slower * angle).sin() / slower;
        of_amplitude_ = cosines + damping_ * sines_;
        of_velocity_ = cosines - damping_ * sines_;
    }

    /// A step without force.
    void swing() {
        before_ = amplitudes_;
        amplitudes_ = before_ * of_amplitude_ + velocities_ * sines_;
        velocities_ = velocities_ * of_velocity_ - before_ * sines_;
    }
    /// What a force of 1 N does in a step on top of that, to the amplitudes.
    Eigen::ArrayXd perNewton() const { return (1 - of_amplitude_) * modes_.work; }
    /// Adds it, for a force.
    void push(double force_n) {
        amplitudes_ += force_n * (1 - of_amplitude_) * modes_.work;
        velocities_ += force_n * sines_ * modes_.work;
    }

    const Eigen::ArrayXd& amplitudes() const { return amplitudes_; }
    double strainEnergy() const { return 0.5 * amplitudes_.square().sum(); }
    double kineticEnergy() const { return 0.5 * velocities_.square().sum(); }

  private:
    const StruckModes& modes_;
    Eigen::ArrayXd damping_;                  ///< shares of the critical one
    Eigen::ArrayXd amplitudes_, velocities_;  ///< velocities over the rates
    Eigen::ArrayXd of_amplitude_, of_velocity_, sines_, before_;
};

}  // namespace sherd
