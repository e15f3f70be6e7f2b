#include "core/sampling/discretisation.h"

namespace sherd {
namespace {

/// Compensated (Kahan) sum: many cells are equal, and the rounding of equal terms adds up instead of
/// cancelling.
template <class Value>
class Sum {
  public:
    explicit Sum(const Value& zero) : total_(zero), lost_(zero) {}
    void add(const Value& term) {
        const Value corrected = term - lost_;
        const Value next = total_ + corrected;
        lost_ = (next - total_) - corrected;
        total_ = next;
    }
    const Value& total() const { return total_; }

  private:
    Value total_, lost_;
};

}  // namespace

double meanParticleVolume(const Discretisation& solid) {
    double mean = 0;
    for (const Particle& p : solid.particles) mean += p.volume / static_cast<double>(solid.particles.size());
    return mean;
}

Moments totalMoments(const Discretisation& solid) {
    // About the first cell: far from the origin nothing is lost.
    const Vec3 reference = solid.cells.empty() ? Vec3(Vec3::Zero()) : solid.cells.front().moments.centroid;
    Sum<double> volume(0);
    Sum<Vec3> first(Vec3::Zero());
    for (const IntegrationCell& cell : solid.cells) {
        volume.add(cell.moments.volume);
        first.add(cell.moments.volume * (cell.moments.centroid - reference));
    }
    Moments total;
    total.volume = volume.total();
    if (total.volume <= 0) return total;
    total.centroid = reference + first.total() / total.volume;
    Sum<Mat3> second(Mat3::Zero());
    for (const IntegrationCell& cell : solid.cells) {
        const Vec3 d = cell.moments.centroid - total.centroid;
        second.add(cell.moments.second + cell.moments.volume * d * d.transpose());
    }
    total.second = second.total();
    return total;
}

}  // namespace sherd
