#include "core/mlpg/splines/load_boxes.h"

#include <algorithm>
#include <array>
#include <map>

namespace sherd {
namespace {

/// In cells of the grid.
struct PatchBounds {
    Vec3 lower, upper;
};

/// Loads that act in the same or in touching cells belong to one patch.
std::vector<PatchBounds> loadPatches(const CellParts& grid, const std::vector<PointForce>& loads) {
    std::map<std::array<int, 3>, std::pair<int, PatchBounds>>
        cells;  // patch and bounds of the loads in a cell
    for (const PointForce& load : loads) {
        const Vec3 u = (load.position - grid.origin).cwiseQuotient(grid.edges);
        const Eigen::Vector3i cell = u.array().floor().cast<int>();
        const auto [place, fresh] = cells.try_emplace({cell.z(), cell.y(), cell.x()}, -1, PatchBounds{u, u});
        PatchBounds& bounds = place->second.second;
        bounds.lower = bounds.lower.cwiseMin(u);
        bounds.upper = bounds.upper.cwiseMax(u);
    }
    std::vector<PatchBounds> patches;
    for (auto& [start, entry] : cells) {
        if (entry.first >= 0) continue;
        entry.first = static_cast<int>(patches.size());
        patches.push_back(entry.second);
        std::vector<std::array<int, 3>> queue{start};
        while (!queue.empty()) {
            const std::array<int, 3> cell = queue.back();
            queue.pop_back();
            for (int n = 0; n < 27; ++n) {
                const auto other =
                    cells.find({cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1});
                if (other == cells.end() || other->second.first >= 0) continue;
                other->second.first = entry.first;
                PatchBounds& sum = patches.back();
                sum.lower = sum.lower.cwiseMin(other->second.second.lower);
                sum.upper = sum.upper.cwiseMax(other->second.second.upper);
                queue.push_back(other->first);
            }
        }
    }
    return patches;
}

bool overlap(const CellBox& a, const CellBox& b) {
    return (a.lower.array() < b.upper.array()).all() && (b.lower.array() < a.upper.array()).all();
}

}  // namespace

std::vector<CellBox> boxesAroundLoads(const CellParts& grid, const std::vector<PointForce>& loads,
                                      double largest_patch, const ResamplingReach& reach, int multiple) {
    std::vector<CellBox> boxes;
    for (const PatchBounds& patch : loadPatches(grid, loads)) {
        const Vec3 extent = patch.upper - patch.lower;
        if (extent.maxCoeff() >= reach.cells || extent.cwiseProduct(grid.edges).norm() > largest_patch)
            continue;
        const Vec3 border = Vec3::Constant(reach.margin);
        boxes.push_back({((patch.lower - border) / multiple).array().floor().cast<int>() * multiple,
                         ((patch.upper + border) / multiple).array().ceil().cast<int>() * multiple});
    }
    // Boxes that overlap would correct the same error twice.
    for (size_t i = 0; i < boxes.size(); ++i)
        for (size_t j = i + 1; j < boxes.size();) {
            if (!overlap(boxes[i], boxes[j])) {
                ++j;
                continue;
            }
            boxes[i] = {boxes[i].lower.cwiseMin(boxes[j].lower), boxes[i].upper.cwiseMax(boxes[j].upper)};
            boxes.erase(boxes.begin() + static_cast<long>(j));
            j = i + 1;
        }
    return boxes;
}

}  // namespace sherd
