#include "fracture/voxel_owners.h"

#include <limits>
#include <numeric>

namespace sherd {

namespace {

Vec3 centreOf(const Discretisation::Voxel& voxel, const Discretisation& sampling) {
    return sampling.grid_origin +
           (voxel.index.cast<double>().array() + 0.5).matrix().cwiseProduct(sampling.cell_size);
}

/// The candidate with the vertex nearest to a point.
int nearestPiece(const Vec3& point, const std::vector<int>& candidates, const FragmentSurfaces& surfaces) {
    int piece = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int candidate : candidates) {
        for (const Vec3& x : surfaces.pieces[candidate].mesh.vertices) {
            const double distance = (x - point).squaredNorm();
            if (distance < nearest) {
                nearest = distance;
                piece = candidate;
            }
        }
    }
    return piece;
}

}  // namespace

std::vector<int> voxelOwners(const Discretisation& sampling, const FragmentLabels& labels,
                             const FragmentSurfaces& surfaces) {
    std::vector<std::vector<int>> pieces_of_label(labels.count);
    for (std::size_t p = 0; p < surfaces.pieces.size(); ++p) {
        const FragmentSurface& piece = surfaces.pieces[p];
        pieces_of_label[piece.label].push_back(static_cast<int>(p));
        for (const int label : piece.merged_labels) {
            std::vector<int>& pieces = pieces_of_label[label];
            if (pieces.empty() || pieces.back() != static_cast<int>(p)) pieces.push_back(static_cast<int>(p));
        }
    }
    std::vector<int> all(surfaces.pieces.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<int> owner(sampling.voxels.size(), -1);
    for (std::size_t v = 0; v < sampling.voxels.size(); ++v) {
        const int label = labels.of_particle[sampling.cells[sampling.voxels[v].cell].particle];
        // All of a label may have become part of another's piece.
        const std::vector<int>& candidates = pieces_of_label[label].empty() ? all : pieces_of_label[label];
        owner[v] = candidates.size() == 1
                       ? candidates.front()
                       : nearestPiece(centreOf(sampling.voxels[v], sampling), candidates, surfaces);
    }
    return owner;
}

}  // namespace sherd
