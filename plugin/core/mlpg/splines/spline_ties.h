#pragma once

#include "core/mlpg/splines/raw_functions.h"

namespace sherd {

/// The coefficients of raw functions as combinations of unknown ones. A function that only slivers of the
/// solid see, or that is next to zero where it sees more, would make the equations singular. Its coefficient
/// is tied to those around the nearest well-filled part, by the extrapolation that is exact for polynomials
/// of degree p (extended B-splines; Hoellig, Reif, Wipper 2001).
struct SplineTies {
    struct Term {
        int function;  ///< that carries unknowns
        double factor;
    };
    std::vector<int> raw_of_function;  ///< per function that carries unknowns
    std::vector<int> starts;           ///< per raw function and one more, into `terms`
    std::vector<Term> terms;

    SplineTies() = default;
    SplineTies(const CellParts& solid, const RawFunctions& raw);
};

}  // namespace sherd
