#include "core/mlpg/reduced/contact_reading.h"

#include "core/stress/elasticity.h"

namespace sherd {

ContactReading::ContactReading(const SplineProblem& problem, const ReadingPoints& points,
                               const ContactField& contact)
    : near_(contact.near),
      loaded_(contact.others, problem.solid->spacing),
      point_count_(static_cast<int>(points.points.size())) {
    const CellParts& solid = problem.parts();
    for (const SurfacePlace& place : contact.places) {
        const GridPoint where = locate(solid, place.position);
        const int nearest = where.part < 0 ? -1 : points.nearestTo(where);
        if (nearest >= 0)
            places_.push_back({place.position, place.near_at, place.normal.cast<float>(), where, nearest});
    }
    if (near_.empty()) return;
    near_bounds_.reserve(solid.parts.size());
    for (const CellPart& part : solid.parts) {
        const Vec3 middle = part.cell.cast<double>() + Vec3::Constant(0.5);
        near_bounds_.push_back(
            near_.largestAbout(solid.origin + middle.cwiseProduct(solid.edges), solid.edges.norm() / 2));
    }
    const std::size_t count = point_count_ + places_.size();
    states_ = std::make_unique<std::atomic<unsigned char>[]>(count);
    near_stress_.reset(new SymmetricTensor[count]);
}

Mat3 ContactReading::nearStress(int number, const Vec3& x) const {
    std::atomic<unsigned char>& state = states_[number];
    if (state.load(std::memory_order_acquire) == known) return toMatrix(near_stress_[number]);
    const SymmetricTensor found = toSymmetricTensor(near_.stressAt(x));
    unsigned char expected = unknown;  // two threads find the same bits, one keeps them
    if (state.compare_exchange_strong(expected, being_written, std::memory_order_relaxed)) {
        near_stress_[number] = found;
        state.store(known, std::memory_order_release);
    }
    return toMatrix(found);
}

}  // namespace sherd
