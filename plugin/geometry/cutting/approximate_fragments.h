#pragma once

#include <string>

#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// The fallback of `cutFragments`: the faces between labels on a lattice, with the outside as one more label.
/// Nothing is cut, so nothing can go wrong but small details and walls thinner than the lattice spacing,
/// which are lost; an error if these were a quarter of the body. `why` is the reason that goes into the note.
Result<FragmentSurfaces> approximateFragments(const TriangleMesh& surface, const Discretisation& solid,
                                              const FragmentLabels& labels, const CutSettings& settings,
                                              const std::string& why);

}  // namespace sherd
