#include "core/clustering/penalty_distance.h"

#include <sstream>
#include <stdexcept>

namespace sherd {

namespace {

/// The offset with its component along the field multiplied by lambda.
Vec3 penalised(const Vec3& offset, const Vec3& field, double lambda) {
    if (field.isZero(0)) return offset;
    const Vec3 v = field.stableNormalized();  // the square of the length may overflow
    return offset - (1 - lambda) * offset.dot(v) * v;
}

/// Throws a sentence about a value that is no direction.
Vec3 customDirection(const Vec3& x, const GuideField& guide, const Vec3& contact) {
    const Vec3 field = guide.custom(x, contact);
    if (field.allFinite()) return field;
    std::ostringstream sentence;
    sentence << "the guide field is (" << field.transpose() << ") at (" << x.transpose()
             << ") m; it has to be finite everywhere in the body";
    throw std::invalid_argument(sentence.str());
}

double radialDistance(const Vec3& seed, const Vec3& x, const BlowAxis& blow, double lambda) {
    const auto fromAxis = [&](const Vec3& point) -> Vec3 {
        const Vec3 away = point - blow.contact;
        return away - away.dot(blow.direction) * blow.direction;
    };
    const Vec3 offset = penalised(x - seed, blow.direction, lambda);
    const Vec3 out = fromAxis(seed);
    if (out.isZero(0)) return offset.norm();
    const Vec3 v = out.normalized();
    const double at_x = fromAxis(x).dot(v), at_seed = out.norm();
    const double along = at_x > 0 ? lambda * (at_x - at_seed) : at_x - lambda * at_seed;
    return (offset + (along - offset.dot(v)) * v).norm();
}

Mat3 shortened(const Vec3& field, double lambda) {
    if (field.isZero(0)) return Mat3::Identity();
    const Vec3 v = field.stableNormalized();
    return Mat3::Identity() - (1 - lambda) * v * v.transpose();
}

}  // namespace

double penaltyDistance(const Vec3& seed, const Vec3& x, const GuideField& guide, const BlowAxis& blow) {
    switch (guide.kind) {
        case GuideField::Kind::none:
            break;
        case GuideField::Kind::constant:
            return penalised(x - seed, guide.direction, guide.cost_along).norm();
        case GuideField::Kind::radial:
            return radialDistance(seed, x, blow, guide.cost_along);
        case GuideField::Kind::custom:
            return penalised(x - seed, customDirection(0.5 * (seed + x), guide, blow.contact),
                             guide.cost_along)
                .norm();
    }
    return (x - seed).norm();
}

Mat3 guideStretch(const Vec3& x, const GuideField& guide, const BlowAxis& blow) {
    const double lambda = guide.cost_along;
    switch (guide.kind) {
        case GuideField::Kind::none:
            break;
        case GuideField::Kind::constant:
            return shortened(guide.direction, lambda);
        case GuideField::Kind::radial: {
            const Vec3 away = x - blow.contact;
            return shortened(blow.direction, lambda) *
                   shortened(away - away.dot(blow.direction) * blow.direction, lambda);
        }
        case GuideField::Kind::custom:
            return shortened(customDirection(x, guide, blow.contact), lambda);
    }
    return Mat3::Identity();
}

}  // namespace sherd
