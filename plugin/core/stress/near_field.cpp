#include "core/stress/near_field.h"

#include <algorithm>
#include <cmath>

namespace sherd {

NearField::NearField(const std::vector<ContactDisc>& discs, double poisson_ratio)
    : discs_(discs), poisson_ratio_(poisson_ratio) {
    for (const ContactDisc& disc : discs) fields_.emplace_back(disc, poisson_ratio);
}

NearField NearField::times(double factor) const {
    if (factor == 0) return {};
    std::vector<ContactDisc> discs = discs_;
    for (ContactDisc& disc : discs) disc.traction_pa *= factor;
    return NearField(discs, poisson_ratio_);
}

Mat3 NearField::stressAt(const Vec3& x) const {
    Mat3 sum = Mat3::Zero();
    for (const DiscField& field : fields_) sum += field.stressAt(x);
    return sum;
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
        const double distance = std::max(0.0, (x - disc.centre).norm() - radius) / disc.radius;
        sum += disc.traction_pa.norm() * std::min(most, beyond / (distance * distance));
    }
    return sum;
}

}  // namespace sherd
