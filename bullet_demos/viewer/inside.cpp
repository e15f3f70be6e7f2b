#include "viewer/inside.h"

#include <algorithm>
#include <cmath>

namespace demo {
namespace {

using sherd::Vec2;
using sherd::Vec3;

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether the line upward from a point meets a triangle. Both ends of an edge are seen in the same order by
/// both of its triangles, so that a line through it meets one of them.
bool isBelow(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec2 p = point.head<2>();
    const auto side = [&p](const Vec3& from, const Vec3& to) {
        const bool swapped =
            std::lexicographical_compare(to.data(), to.data() + 3, from.data(), from.data() + 3);
        const Vec3 &first = swapped ? to : from, &second = swapped ? from : to;
        const bool left = cross(second.head<2>() - first.head<2>(), p - first.head<2>()) >= 0;
        return left != swapped;
    };
    const bool first = side(a, b);
    if (first != side(b, c) || first != side(c, a)) return false;
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.z() == 0) return false;
    return point.z() < a.z() - (normal.x() * (p.x() - a.x()) + normal.y() * (p.y() - a.y())) / normal.z();
}

}  // namespace

InsideTest::InsideTest(const sherd::TriangleMesh& surface) : surface_(surface) {
    for (const Vec3& vertex : surface.vertices) box_.extend(vertex);
    width_ = std::clamp(int(std::sqrt(double(surface.triangles.size()) / 4)), 1, 200);
    columns_.resize(std::size_t(width_) * std::size_t(width_));
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        Eigen::AlignedBox3d over;
        for (int v : surface.triangles[t]) over.extend(surface.vertices[std::size_t(v)]);
        const std::size_t low = columnOf(over.min().x(), over.min().y()),
                          high = columnOf(over.max().x(), over.max().y()), width = std::size_t(width_);
        for (std::size_t y = low / width; y <= high / width; ++y)
            for (std::size_t x = low % width; x <= high % width; ++x)
                columns_[y * width + x].push_back(int(t));
    }
}

std::size_t InsideTest::columnOf(double x, double y) const {
    const auto place = [this](double value, int axis) {
        const double part = (value - box_.min()[axis]) / std::max(box_.sizes()[axis], 1e-12);
        return std::size_t(std::clamp(int(part * width_), 0, width_ - 1));
    };
    return place(y, 1) * std::size_t(width_) + place(x, 0);
}

bool InsideTest::contains(const Vec3& point) const {
    if (!box_.contains(point)) return false;
    bool inside = false;
    for (int t : columns_[columnOf(point.x(), point.y())]) {
        const auto& [a, b, c] = surface_.triangles[std::size_t(t)];
        const auto& vertices = surface_.vertices;
        inside ^=
            isBelow(point, vertices[std::size_t(a)], vertices[std::size_t(b)], vertices[std::size_t(c)]);
    }
    return inside;
}

}  // namespace demo
