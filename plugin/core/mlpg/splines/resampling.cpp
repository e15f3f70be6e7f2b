#include "core/mlpg/splines/resampling.h"

#include <iterator>

#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

Result<std::vector<Zoom>> resample(const TriangleMesh& surface, const SplineField& whole,
                                   const BodyLoads& loads, const Elasticity& elasticity,
                                   const std::vector<SupportSpring>& supports, const Resampling& resampling) {
    // A load over a larger fraction of the body is not a contact, and the grid resolves it.
    constexpr double largest_patch_of_body = 0.2;
    const double largest_patch =
        largest_patch_of_body * whole.parts->count.cast<double>().cwiseProduct(whole.parts->edges).norm();
    // Macro cells of the finer grids fill those of the coarser: what these hold at the border keeps its
    // volume.
    const int multiple = isNearlyIncompressible(elasticity) ? whole.space->degree : 1;
    const auto zoomsInto = [&](const SplineField& coarse,
                               const BodyLoads& acting) -> Result<std::vector<Zoom>> {
        std::vector<Zoom> finer;
        for (const CellBox& box :
             boxesAroundLoads(*coarse.parts, acting.forces, largest_patch, resampling.margin, multiple)) {
            Result<Zoom> zoom = zoomIn(surface, coarse, box, elasticity, acting, supports);
            if (!zoom) return Error{zoom.error()};
            finer.push_back(std::move(zoom).value());
        }
        return finer;
    };
    std::vector<Zoom> zooms;
    if (resampling.rounds < 1) return zooms;
    Result<std::vector<Zoom>> first = zoomsInto(whole, loads);
    if (!first) return first;
    zooms = std::move(first).value();
    size_t parent = 0;
    for (int round = 1; round < resampling.rounds; ++round)
        for (const size_t end = zooms.size(); parent < end; ++parent) {
            Result<std::vector<Zoom>> finer = zoomsInto(zooms[parent].field, zooms[parent].loads);
            if (!finer) return finer;
            std::move(finer.value().begin(), finer.value().end(), std::back_inserter(zooms));
        }
    return zooms;
}

}  // namespace sherd
