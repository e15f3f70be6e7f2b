#include "core/loads/footprint.h"

#include <algorithm>
#include <array>
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
    const std::array<double, 3> lengths = {(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()};
    int longest = 0;
    for (int edge = 1; edge < 3; ++edge)
        if (lengths[edge] > lengths[longest]) longest = edge;
    const double length = lengths[longest], outside = footprint.outside(centre);
    if (outside > length) return;
    if (length <= longest_of(footprint.project(centre), length)) {
        const double area = -areaVector(t).dot(footprint.push());
        if (area > 0 && outside == 0) parts.push_back({centre, area});
        return;
    }
    const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
    const Vec3 half = 0.5 * (a + b);
    collectParts({a, half, c}, footprint, longest_of, parts);
    collectParts({half, b, c}, footprint, longest_of, parts);
}

/// A triangle that faces a push, and where it lies along it.
struct Facing {
    int triangle;
    double lowest;
};

/// The surface over a footprint that faces its push, but what lies deeper than `depth` inside of a triangle
/// that is all over it: none of its parts is wanted. What is a quarter as long as `longest` is taken
/// together: it counts by where its middle is.
SurfaceParts outerParts(const SurfaceTree& tree, const Footprint& footprint, const LengthOfParts& longest,
                        double depth) {
    constexpr double grazing = 0.1;  // cosine
    const Vec3& push = footprint.push();
    const SurfaceParts over = tree.partsWhere(
        [&](const Eigen::AlignedBox3d& box) {
            return footprint.isNear(box.center(), box.diagonal().norm() / 2);
        },
        [&](const Eigen::AlignedBox3d& box) {
            const double length = box.diagonal().norm();
            return 4 * length <= longest(footprint.project(box.center()), length);
        });
    double outermost = std::numeric_limits<double>::infinity();  // at most
    std::vector<Facing> facing;
    for (const int i : over.triangles) {
        const TriangleCorners t = cornersOf(tree.surface(), i);
        const Vec3 area = areaVector(t);
        if (!(area.dot(push) < 0)) continue;
        const Vec3 heights(t[0].dot(push), t[1].dot(push), t[2].dot(push));
        const double lowest = heights.minCoeff(), highest = heights.maxCoeff();
        if (lowest > outermost + depth) continue;
        facing.push_back({i, lowest});
        const auto isOver = [&](const Vec3& corner) { return footprint.outside(corner) == 0; };
        if (highest < outermost && area.dot(push) < -grazing * area.norm() &&
            std::all_of(t.begin(), t.end(), isOver))
            outermost = highest;
    }
    SurfaceParts outer;
    for (const Facing& one : facing)
        if (!(one.lowest > outermost + depth)) outer.triangles.push_back(one.triangle);
    for (const FlatPart& part : over.flat)
        if (part.area.dot(push) < 0 && footprint.outside(part.centre) == 0 &&
            !(part.centre.dot(push) > outermost + depth))
            outer.flat.push_back(part);
    return outer;
}

}  // namespace

Footprint::Footprint(const std::vector<Vec3>& contacts, const Vec3& push, double margin_m)
    : push_(push), margin_(margin_m) {
    const Vec3 longest = longestAxis(contacts, push);
    axes_ << longest.transpose(), push.cross(longest).transpose();
    std::vector<Vec2> points;
    for (const Vec3& contact : contacts) {
        points.push_back(project(contact));
        box_.extend(points.back());
    }
    size_ = box_.sizes() + Vec2::Constant(2 * margin_m);
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
    std::vector<FootprintPart> parts;
    const SurfaceParts outer = outerParts(tree, footprint, longest, depth);
    for (const int i : outer.triangles) collectParts(cornersOf(tree.surface(), i), footprint, longest, parts);
    for (const FlatPart& part : outer.flat) parts.push_back({part.centre, -part.area.dot(footprint.push())});
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
