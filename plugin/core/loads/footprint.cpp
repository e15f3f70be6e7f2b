#include "core/loads/footprint.h"

#include <algorithm>
#include <limits>

#include "core/loads/convex_hull_2d.h"
#include "core/numerics/mesh_measures.h"

namespace sherd {

namespace {

/// At right angles to the push, towards the contact that is furthest from the first one.
Vec3 longestAxis(const std::vector<Vec3>& contacts, const Vec3& push) {
    Vec3 axis = push.unitOrthogonal();
    double length = 0;
    for (const Vec3& contact : contacts) {
        const Vec3 to = contact - contacts.front(), along = to - push * push.dot(to);
        if (along.norm() <= length) continue;
        length = along.norm();
        axis = along / length;
    }
    return axis;
}

/// Parts of a triangle that lie over the footprint.
void collectParts(const TriangleCorners& t, const Footprint& footprint, const LengthOfParts& longest_of,
                  std::vector<FootprintPart>& parts) {
    const Vec3 centre = (t[0] + t[1] + t[2]) / 3;
    int longest = 0;
    const auto length = [&](int edge) { return (t[(edge + 1) % 3] - t[edge]).norm(); };
    for (int edge = 1; edge < 3; ++edge)
        if (length(edge) > length(longest)) longest = edge;
    if (footprint.outside(centre) > length(longest)) return;
    if (length(longest) <= longest_of(footprint.project(centre), length(longest))) {
        const double area = -areaVector(t).dot(footprint.push());
        if (area > 0 && footprint.outside(centre) == 0) parts.push_back({centre, area});
        return;
    }
    const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
    const Vec3 half = 0.5 * (a + b);
    collectParts({a, half, c}, footprint, longest_of, parts);
    collectParts({half, b, c}, footprint, longest_of, parts);
}

}  // namespace

Footprint::Footprint(const std::vector<Vec3>& contacts, const Vec3& push, double margin_m)
    : push_(push), margin_(margin_m) {
    const Vec3 longest = longestAxis(contacts, push);
    axes_ << longest.transpose(), push.cross(longest).transpose();
    std::vector<Vec2> points;
    Eigen::AlignedBox2d box;
    for (const Vec3& contact : contacts) {
        points.push_back(project(contact));
        box.extend(points.back());
    }
    size_ = box.sizes() + Vec2::Constant(2 * margin_m);
    hull_ = convexHull(std::move(points));
}

double Footprint::outside(const Vec3& x) const {
    return std::max(0.0, distanceFromHull(hull_, project(x)) - margin_);
}

double Footprint::area() const {
    return hullArea(hull_) + 2 * (length() + width()) * margin_;
}

std::vector<FootprintPart> partsOver(const SurfaceTree& tree, const Footprint& footprint,
                                     const LengthOfParts& longest, double depth) {
    const auto reaches = [&](const Eigen::AlignedBox3d& box) {
        return footprint.outside(box.center()) <= box.diagonal().norm() / 2;
    };
    std::vector<FootprintPart> parts;
    for (const int i : tree.trianglesWhere(reaches)) {
        const TriangleCorners t = cornersOf(tree.surface(), i);
        if (areaVector(t).dot(footprint.push()) < 0) collectParts(t, footprint, longest, parts);
    }
    double outermost = std::numeric_limits<double>::infinity();
    for (const FootprintPart& part : parts)
        outermost = std::min(outermost, part.centre.dot(footprint.push()));
    const auto deeper = [&](const FootprintPart& part) {
        return part.centre.dot(footprint.push()) > outermost + depth;
    };
    parts.erase(std::remove_if(parts.begin(), parts.end(), deeper), parts.end());
    return parts;
}

}  // namespace sherd
