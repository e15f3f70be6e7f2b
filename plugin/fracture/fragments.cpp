#include "fracture/fragments.h"

#include "fracture/voxel_owners.h"

namespace sherd {

std::vector<Fragment> makeFragments(const StrikeContext& struck, const FragmentLabels& labels,
                                    const FragmentSurfaces& surfaces) {
    const Discretisation& sampling = struck.sampling;
    std::vector<Fragment> fragments(surfaces.pieces.size());
    for (std::size_t p = 0; p < fragments.size(); ++p)
        fragments[p].solid = struck.solid.makeFragment(surfaces.pieces[p].mesh);
    if (struck.fracture.collision_shape != CollisionShape::boxes) return fragments;
    const std::vector<int> owner = voxelOwners(sampling, labels, surfaces);
    std::vector<char> wanted(sampling.voxels.size());
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        for (std::size_t v = 0; v < wanted.size(); ++v) wanted[v] = owner[v] == static_cast<int>(p);
        fragments[p].boxes = mergedBoxes(sampling, wanted);
    }
    return fragments;
}

Result<std::vector<Box>> collisionBoxes(const BreakableSolid& solid) {
    const auto sampling = solid.discretisation();
    if (!sampling) return Error{sampling.error()};
    return mergedBoxes(*sampling.value(), std::vector<char>(sampling.value()->voxels.size(), 1));
}

}  // namespace sherd
