#include "core/sampling/discretisation.h"

namespace sherd {

Moments totalMoments(const Discretisation& solid) {
    // About the first cell: far from the origin nothing is lost.
    const Vec3 reference = solid.cells.empty() ? Vec3(Vec3::Zero()) : solid.cells.front().moments.centroid;
    Moments total;
    Vec3 first = Vec3::Zero();
    for (const IntegrationCell& cell : solid.cells) {
        total.volume += cell.moments.volume;
        first += cell.moments.volume * (cell.moments.centroid - reference);
    }
    if (total.volume <= 0) return total;
    total.centroid = reference + first / total.volume;
    for (const IntegrationCell& cell : solid.cells) {
        const Vec3 d = cell.moments.centroid - total.centroid;
        total.second += cell.moments.second + cell.moments.volume * d * d.transpose();
    }
    return total;
}

}  // namespace sherd
