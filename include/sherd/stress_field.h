#pragma once

#include <sherd/types.h>

#include <string>
#include <vector>

namespace sherd {

/// The stress in a struck body, as one blow left it. Asset frame, Pa. Tension is positive.
struct StressField {
    std::vector<Voigt> particles;         ///< #particles, at the particles
    std::vector<Voigt> surface;           ///< #surface points of the sampling
    std::vector<Voigt> points;            ///< at the points that were asked for, in their order
    std::vector<double> point_spacing_m;  ///< #points: of the particles there, finer around loads
    double strain_energy_j = 0;
    double residual_rel = 0;   ///< |K u - f| / |f| of the linear solve
    double imbalance_rel = 0;  ///< net force and moment left after inertia relief, over those of the loads
    long long resampling_entries = 0;   ///< numbers stored for the finer grids around the loads
    double solve_ms = 0;                ///< load vector, triangular solves and residual
    double recovery_ms = 0;             ///< stress from displacements
    std::vector<std::string> warnings;  ///< what limits trust in these figures, with the remedy
};

/// Largest eigenvalue of a symmetric tensor.
double largestPrincipal(const Voigt& stress);

}  // namespace sherd
