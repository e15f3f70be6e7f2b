#pragma once

#include <sherd/types.h>

#include <string>
#include <vector>

namespace sherd {

/// The stress in a body under one set of loads, in Pa, in the asset frame. Tension is positive.
struct StressField {
    std::vector<SymmetricTensor> particles;  ///< one each, in the order of StressModel::particlePositions
    std::vector<SymmetricTensor> surface;    ///< one each, in the order of StressModel::surfacePositions
    std::vector<SymmetricTensor> points;     ///< one a point that was asked for, in their order
    std::vector<double> point_spacing_m;     ///< one a point: between the particles there; finer if resampled
    double strain_energy_j = 0;
    /// |K u - f| / |f| of the linear solve: stiffness matrix K, displacements u, load vector f.
    double residual_rel = 0;
    /// Net force and moment that are left after rigid acceleration has balanced the loads, over those of the
    /// loads.
    double imbalance_rel = 0;
    long long resampling_entries = 0;   ///< numbers stored for finer grids (resampling)
    double solve_ms = 0;                ///< load vector, triangular solves and residual
    double recovery_ms = 0;             ///< stress from displacements
    std::vector<std::string> warnings;  ///< what limits trust in these figures, with the remedy
};

/// The largest principal stress: the largest eigenvalue of a symmetric tensor.
double largestPrincipal(const SymmetricTensor& stress);

}  // namespace sherd
