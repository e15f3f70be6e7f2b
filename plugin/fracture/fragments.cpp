#include "fracture/fragments.h"

#include <utility>

#include "core/numerics/mesh_measures.h"
#include "fracture/debris.h"
#include "fracture/voxel_owners.h"
#include "geometry/cutting/cut_fragments.h"

namespace sherd {

Result<FragmentSurfaces> cutPieces(const StrikeContext& struck, const FragmentLabels& labels) {
    CutSettings settings;
    settings.seed = struck.seed;
    settings.roughness = struck.fracture.crack_roughness;
    settings.pieces.most = struck.fracture.largest_fragment_count;
    if (struck.fracture.debris == Debris::merged)
        settings.pieces.smallest_m3 = smallestFragment(struck.solid, struck.fracture);
    return cutFragments(struck.solid.cuttable(struck.sampling), struck.sampling, labels, settings);
}

double crackArea(const FragmentSurfaces& surfaces) {
    double both_sides = 0;
    for (const FragmentSurface& piece : surfaces.pieces)
        for (std::size_t t = 0; t < piece.parents.size(); ++t)
            if (piece.parents[t] < 0) both_sides += areaVector(cornersOf(piece.mesh, t)).norm();
    return both_sides / 2;
}

std::vector<Fragment> makeFragments(const StrikeContext& struck, const FragmentLabels& labels,
                                    FragmentSurfaces surfaces) {
    const Discretisation& sampling = struck.sampling;
    const int count = static_cast<int>(surfaces.pieces.size());
    std::vector<std::vector<Box>> boxes(count);
    if (struck.fracture.collision_shape == CollisionShape::boxes)
        boxes = boxesOfPieces(sampling, voxelOwners(sampling, labels, surfaces), count);
    std::vector<Fragment> fragments(count);
    for (int p = 0; p < count; ++p)
        fragments[p] = {struck.solid.makeFragment(std::move(surfaces.pieces[p].mesh)), std::move(boxes[p])};
    return fragments;
}

Result<std::vector<Box>> collisionBoxes(const BreakableSolid& solid) {
    const auto sampling = solid.discretisation();
    if (!sampling) return Error{sampling.error()};
    return mergedBoxes(*sampling.value(), std::vector<char>(sampling.value()->voxels.size(), 1));
}

}  // namespace sherd
