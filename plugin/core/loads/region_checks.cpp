#include "core/loads/region_checks.h"

#include <sstream>

#include "core/numerics/range_checks.h"

namespace sherd {

namespace {

std::string text(const Vec3& v) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
    return out.str();
}

std::string text(double value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << value;
    return out.str();
}

std::string sentencePart(const SphereRegion& sphere) {
    return "the sphere about " + text(sphere.centre) + " m of radius " + text(sphere.radius_m) + " m";
}

std::string sentencePart(const BoxRegion& box) {
    return "the box from " + text(box.lo) + " m to " + text(box.hi) + " m";
}

std::string sentencePart(const CylinderRegion& cylinder) {
    return "the cylinder through " + text(cylinder.point) + " m along " + text(cylinder.axis) +
           " of radius " + text(cylinder.radius_m) + " m";
}

Status checkShape(const SphereRegion& sphere) {
    return RangeChecks(describe(sphere))
        .require(sphere.centre.allFinite(), "centre", "not finite", "three numbers, in m")
        .require(isPositive(sphere.radius_m), "radius", sphere.radius_m, "positive, in m")
        .status();
}

Status checkShape(const BoxRegion& box) {
    return RangeChecks(describe(box))
        .require(box.lo.allFinite() && box.hi.allFinite(), "corner", "not finite", "three numbers, in m")
        .require((box.lo.array() <= box.hi.array()).all(), "lo", "above hi", "at most hi in each coordinate")
        .status();
}

Status checkShape(const CylinderRegion& cylinder) {
    return RangeChecks(describe(cylinder))
        .require(cylinder.point.allFinite(), "point", "not finite", "three numbers, in m")
        .require(isPositive(cylinder.axis.norm()), "axis", "zero or not finite", "a direction")
        .require(isPositive(cylinder.radius_m), "radius", cylinder.radius_m, "positive, in m")
        .status();
}

}  // namespace

std::string describe(const SurfaceRegion& region) {
    return std::visit([](const auto& r) { return sentencePart(r); }, region);
}

Status checkRegion(const SurfaceRegion& region) {
    return std::visit([](const auto& r) { return checkShape(r); }, region);
}

}  // namespace sherd
