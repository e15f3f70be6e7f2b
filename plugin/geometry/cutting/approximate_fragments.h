#pragma once

#include <string>

#include "geometry/cutting/cut_fragments.h"

namespace sherd {

/// The fallback of `cutFragments`: the faces between labels on a lattice, with the outside as one more label.
/// Nothing is cut, so it cannot fail as cutting does, but small details and walls thinner than the lattice
/// spacing are lost; an error if they are a quarter of the body. `why` cutting failed goes into the note.
Result<FragmentSurfaces> approximateFragments(const TriangleMesh& surface, const ParticleReach& reach,
                                              const Discretisation& solid, const FragmentLabels& labels,
                                              const CutSettings& settings, const std::string& why);

}  // namespace sherd
