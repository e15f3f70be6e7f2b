#include "core/damage/damaged_material.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sherd {

bool DamagedMaterial::Voxels::contains(const Vec3& x) const {
    std::array<int, 3> index;
    for (int d = 0; d < 3; ++d) index[d] = static_cast<int>(std::floor((x[d] - origin[d]) / size[d]));
    return std::binary_search(of_damaged.begin(), of_damaged.end(), index);
}

void DamagedMaterial::add(const Voxels& more) {
    if (more.of_damaged.empty()) return;
    const auto same =
        std::find_if(grids_.begin(), grids_.end(), [&](const Voxels& own) { return own.isOn(more); });
    if (same == grids_.end()) return grids_.push_back(more);
    std::vector<std::array<int, 3>> all;
    std::set_union(same->of_damaged.begin(), same->of_damaged.end(), more.of_damaged.begin(),
                   more.of_damaged.end(), std::back_inserter(all));
    same->of_damaged = std::move(all);
}

std::shared_ptr<const DamagedMaterial> DamagedMaterial::with(
    const std::shared_ptr<const DamagedMaterial>& earlier, const Discretisation& sampling,
    const std::vector<char>& damaged) {
    Voxels own{sampling.grid_origin, sampling.cell_size, {}};
    for (const Discretisation::Voxel& voxel : sampling.voxels)
        if (damaged[sampling.cells[voxel.cell].particle])
            own.of_damaged.push_back({voxel.index.x(), voxel.index.y(), voxel.index.z()});
    std::sort(own.of_damaged.begin(), own.of_damaged.end());
    auto all = std::make_shared<DamagedMaterial>();
    if (earlier) *all = *earlier;
    all->add(own);
    return all;
}

std::shared_ptr<const DamagedMaterial> DamagedMaterial::united(
    const std::shared_ptr<const DamagedMaterial>& a, const std::shared_ptr<const DamagedMaterial>& b) {
    if (!a || !b || a == b) return a ? a : b;
    auto all = std::make_shared<DamagedMaterial>(*a);
    for (const Voxels& voxels : b->grids_) all->add(voxels);
    return all;
}

bool DamagedMaterial::contains(const Vec3& x) const {
    return std::any_of(grids_.begin(), grids_.end(), [&](const Voxels& grid) { return grid.contains(x); });
}

std::vector<char> DamagedMaterial::particles(const Discretisation& sampling) const {
    std::vector<double> all(sampling.particles.size()), damaged = all;
    for (const Discretisation::Voxel& voxel : sampling.voxels) {
        const Vec3 middle =
            sampling.grid_origin +
            (voxel.index.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(sampling.cell_size);
        const int particle = sampling.cells[voxel.cell].particle;
        all[particle] += voxel.fill;
        if (contains(middle)) damaged[particle] += voxel.fill;
    }
    std::vector<char> found(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) found[i] = damaged[i] > 0 && 2 * damaged[i] >= all[i];
    return found;
}

}  // namespace sherd
