#pragma once

#include <Eigen/Dense>

#include "core/mlpg/reduced/proper_modes.h"

namespace sherd {

/// The free vibrations of a solid in the space of its proper modes V. With V^T K V = I, and
///     V^T M V = Q diag(1 / w^2) Q^T,
/// the columns of V Q vibrate at the rates w, and have the energy 1/2 each (Rayleigh and Ritz). V answers
/// static loads all over the surface, and so has all slow vibrations in it.
struct VibrationModes {
    static constexpr int most_hot_places = 64;  ///< rows of `hot_pa`

    Eigen::ArrayXd rates_rad_s;  ///< w, ascending
    Eigen::MatrixXf shapes;      ///< Q, #proper modes x #vibrations
    /// The stress of the slowest ones over their amplitude at some places of the body, Pa / J^(1/2), #places
    /// x #slowest (hotPlaces).
    Eigen::MatrixXf hot_pa = {};

    static VibrationModes make(const SplineProblem& problem, const ProperModes& proper);
};

}  // namespace sherd
