#include "core/mlpg/reduced/contact_reading.h"

#include <algorithm>

namespace sherd {

ContactReading::ContactReading(const SplineProblem& problem, const ReadingPoints& points,
                               const ContactField& contact)
    : near_(contact.near), loaded_(contact.others, problem.solid->spacing) {
    const CellParts& solid = problem.parts();
    for (const SurfacePlace& place : contact.places) {
        const GridPoint where = locate(solid, place.position);
        const int nearest = where.part < 0 ? -1 : points.nearestTo(where);
        if (nearest >= 0)
            places_.push_back({place.position, place.normal.cast<float>(), where, nearest, place.unresolved});
    }
    std::stable_sort(places_.begin(), places_.end(),
                     [](const Place& a, const Place& b) { return a.where.part < b.where.part; });
    if (near_.empty()) return;
    near_bounds_.reserve(solid.parts.size());
    for (const CellPart& part : solid.parts) {
        const Vec3 middle = part.cell.cast<double>() + Vec3::Constant(0.5);
        near_bounds_.push_back(
            near_.largestAbout(solid.origin + middle.cwiseProduct(solid.edges), solid.edges.norm() / 2));
    }
}

}  // namespace sherd
