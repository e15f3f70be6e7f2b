#pragma once

#include <optional>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/cut_faces.h"
#include "geometry/cutting/cuttable_surface.h"

namespace sherd {

/// Whether planes tell everywhere where the cracks run, so that `cutByPlanes` may be asked.
bool arePlanesEnough(const FragmentLabels& labels);

/// Splits a surface along the planes of a crack tree, one after the other, and closes each cut with a flat
/// crack face. Where triangles are split follows from the side of their corners alone, and no corner is very
/// near to a plane, since planes are moved a little: so the faces fit whatever is rounded. Pieces that gaps
/// part go to the part of the tree whose particles are nearest; where the solid is joined though its
/// particles are not, to the one with most of them, and the others' labels have no piece. None if a cut
/// cannot be closed, which a plane that touches two walls at once may do.
std::optional<CutFaces> cutByPlanes(const CuttableSurface& surface, const Discretisation& solid,
                                    const FragmentLabels& labels);

}  // namespace sherd
