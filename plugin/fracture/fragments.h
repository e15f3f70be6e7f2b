#pragma once

#include <sherd/result.h>

#include <memory>
#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/voxel_boxes.h"
#include "fracture/strike_context.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// A piece of a broken solid, ready to become a rigid body. Frame of the parent's asset.
struct Fragment {
    std::shared_ptr<const BreakableSolid> solid;
    std::vector<Box> boxes;  ///< for CollisionShape::boxes; empty: the hull of the surface stands in
    bool dropped = false;    ///< takes its share of the momentum, and leaves the world
};

/// Cuts the surface between particles of different labels. The particles of one label may come apart in the
/// cut, at a neck of few particles; where that makes more pieces than the settings allow, the smallest stay
/// part of a neighbour.
Result<FragmentSurfaces> cutPieces(const StrikeContext& struck, const FragmentLabels& labels);

/// Of one side of the new cracks, m^2.
double crackArea(const FragmentSurfaces& surfaces);

/// Makes a solid of every cut surface, and the boxes that stand for it in collisions if they are asked for.
std::vector<Fragment> makeFragments(const StrikeContext& struck, const FragmentLabels& labels,
                                    FragmentSurfaces surfaces);

/// Boxes that stand for the whole solid in collisions: filled voxels, merged.
Result<std::vector<Box>> collisionBoxes(const BreakableSolid& solid);

}  // namespace sherd
