#include "core/stress/near_field.h"

#include <algorithm>
#include <cmath>

namespace sherd {

NearField::NearField(const std::vector<ContactDisc>& discs, double poisson_ratio) : discs_(discs) {
    for (const ContactDisc& disc : discs) fields_.emplace_back(disc, poisson_ratio);
}

Mat3 NearField::stressAt(const Vec3& x) const {
    Mat3 sum = Mat3::Zero();
    for (const DiscField& field : fields_) sum += field.stressAt(x);
    return sum;
}

void NearField::addStressAt(const PlaceLanes& at, StressLanes& sum) const {
    for (const DiscField& field : fields_) field.addStressAt(at, sum);
}

RowsOf3 NearField::forcesOn(const SurfacePieces& pieces) const {
    constexpr int lanes = PlaceLanes::count;
    const Eigen::Index count = pieces.places.rows();
    RowsOf3 forces(count, 3);
    for (Eigen::Index first = 0; first < count; first += lanes) {
        PlaceLanes at;
        for (int l = 0; l < lanes; ++l)
            for (int d = 0; d < 3; ++d) at.x[d][l] = pieces.places(std::min(first + l, count - 1), d);
        StressLanes stress = {};
        addStressAt(at, stress);
        for (int l = 0; l < std::min<Eigen::Index>(lanes, count - first); ++l)
            forces.row(first + l) = pieces.areas.row(first + l) * toMatrix(stress.at(l));
    }
    return forces;
}

namespace {

/// 1 close to the disc, 0 from `close_reach` on.
double closeness(const ContactDisc& disc, const Vec3& x) {
    constexpr double all = 0.5;  // of the reach
    const double reach = close_reach * disc.radius, squared = (x - disc.centre).squaredNorm();
    if (squared >= reach * reach) return 0;
    const double s = std::min((1 - std::sqrt(squared) / reach) / (1 - all), 1.0);
    return s * s * (3 - 2 * s);
}

}  // namespace

double NearField::closeShare(const Vec3& x, std::size_t disc) const {
    double most = 0, sum = 0;
    for (const ContactDisc& other : discs_) {
        const double one = closeness(other, x);
        most = std::max(most, one);
        sum += one;
    }
    return sum > 0 ? closeness(discs_[disc], x) / sum * most : 0;
}

double NearField::closeShare(const Vec3& x) const {
    double most = 0;
    for (const ContactDisc& disc : discs_) most = std::max(most, closeness(disc, x));
    return most;
}

Vec3 NearField::tractionAt(const Vec3& x, const Vec3& outward) const {
    Vec3 sum = Vec3::Zero();
    for (const ContactDisc& disc : discs_)
        if (outward.dot(disc.inward) < -least_facing &&
            std::abs((x - disc.centre).dot(disc.inward)) < largest_sag * disc.radius)
            sum += disc.tractionAt(x);
    return sum;
}

double NearField::largestAbout(const Vec3& x, double radius) const {
    double sum = 0;
    for (const ContactDisc& disc : discs_) {
        // Of all directions of the traction, at every Poisson's ratio (tests/core/stress/near_field_test).
        constexpr double most = 1.65, beyond = 0.85;
        const Vec3 offset = x - disc.centre;
        const double distance = std::max(0.0, offset.norm() - radius) / disc.radius;
        const bool is_behind = offset.dot(disc.inward) >= radius;
        const double times = disc.hollow ? most_if_hollow : is_behind ? 1 : most_before_plane;
        sum += times * disc.traction_pa.norm() * std::min(most, beyond / (distance * distance));
    }
    return sum;
}

}  // namespace sherd
