#include "core/stress/near_field.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/parallel_chunks.h"

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

void NearField::visitStress(Eigen::Index count, const std::function<Vec3(Eigen::Index)>& place,
                            const std::function<void(Eigen::Index, const SymmetricTensor&)>& visit) const {
    constexpr int lanes = PlaceLanes::count;
    constexpr std::size_t worth_sharing = 256;  // discs times groups of places: some 40 us
    constexpr int most_chunks = 16;
    const int groups = static_cast<int>((count + lanes - 1) / lanes);
    const bool is_shared = static_cast<std::size_t>(groups) * fields_.size() >= worth_sharing;
    const int chunks = is_shared ? std::min(groups, most_chunks) : 1;
    forEachChunk(chunks, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunks, groups);
        for (int group = chunkBegin(chunk, chunks, groups); group < end; ++group) {
            const Eigen::Index first = Eigen::Index(lanes) * group;
            PlaceLanes at;
            for (int l = 0; l < lanes; ++l) {
                const Vec3 x = place(std::min(first + l, count - 1));
                for (int d = 0; d < 3; ++d) at.x[d][l] = x[d];
            }
            StressLanes stress = {};
            addStressAt(at, stress);
            for (int l = 0; l < std::min<Eigen::Index>(lanes, count - first); ++l)
                visit(first + l, stress.at(l));
        }
    });
}

RowsOf3 NearField::forcesOn(const SurfacePieces& pieces) const {
    RowsOf3 forces(pieces.places.rows(), 3);
    visitStress(
        forces.rows(), [&](Eigen::Index i) { return Vec3(pieces.places.row(i)); },
        [&](Eigen::Index i, const SymmetricTensor& stress) {
            forces.row(i) = pieces.areas.row(i) * toMatrix(stress);
        });
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
