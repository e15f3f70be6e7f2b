#pragma once

#include "core/vibration/struck_modes.h"

namespace sherd {

/// The modes of a body under a force that is even over each step, for which each swings about its static
/// amplitude: steps of any length are exact.
class Oscillators {
  public:
    explicit Oscillators(const StruckModes& modes)
        : modes_(modes), amplitudes_(Eigen::ArrayXd::Zero(modes.work.size())), velocities_(amplitudes_) {}

    void setStep(double step_s) {
        cosines_ = (modes_.rates_rad_s * step_s).cos();
        sines_ = (modes_.rates_rad_s * step_s).sin();
    }

    /// A step without force.
    void swing() {
        before_ = amplitudes_;
        amplitudes_ = before_ * cosines_ + velocities_ * sines_;
        velocities_ = velocities_ * cosines_ - before_ * sines_;
    }
    /// What a force of 1 N does in a step on top of that, to the amplitudes.
    Eigen::ArrayXd perNewton() const { return (1 - cosines_) * modes_.work; }
    /// Adds it, for a force.
    void push(double force_n) {
        amplitudes_ += force_n * (1 - cosines_) * modes_.work;
        velocities_ += force_n * sines_ * modes_.work;
    }

    const Eigen::ArrayXd& amplitudes() const { return amplitudes_; }
    double strainEnergy() const { return 0.5 * amplitudes_.square().sum(); }
    double kineticEnergy() const { return 0.5 * velocities_.square().sum(); }

  private:
    const StruckModes& modes_;
    Eigen::ArrayXd amplitudes_, velocities_;  ///< velocities over the rates
    Eigen::ArrayXd cosines_, sines_, before_;
};

}  // namespace sherd
