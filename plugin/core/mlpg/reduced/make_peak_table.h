#pragma once

#include <sherd/material.h>

#include "core/linear_algebra/sparse_solver.h"
#include "core/mlpg/reduced/peak_table.h"
#include "core/mlpg/reduced/proper_modes.h"

namespace sherd {

/// The solid under loads, and what its modes were made of.
struct SolvedPatches {
    const SplineProblem& problem;
    const SparseSolver& factor;
    const std::vector<int>& pinned;  ///< unknowns that the factor holds
    const std::vector<UnitPatch>& patches;
    const UnitResponses& responses;  ///< to loads on these
    const ProperModes& modes;
};

/// Bounds from those responses, and from more: to loads that are narrower than the grid, and to loads on the
/// edges of the solid. Edges bear least, and patches of a grid's points would miss them. An error if the
/// factor cannot be used.
Result<PeakTable> makePeakTable(const SolvedPatches& solved, const std::vector<GridPoint>& samples,
                                const Material& material);

}  // namespace sherd
