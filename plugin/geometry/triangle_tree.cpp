#include "geometry/triangle_tree.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sherd {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 toPoint(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Vec3 toVec3(const Kernel::Point_3& p) {
    return {p.x(), p.y(), p.z()};
}

Triangles trianglesOf(const TriangleMesh& mesh) {
    Triangles triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.emplace_back(toPoint(mesh.vertices[a]), toPoint(mesh.vertices[b]),
                               toPoint(mesh.vertices[c]));
    return triangles;
}

}  // namespace

struct TriangleTree::Impl {
    Triangles triangles;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;

    explicit Impl(const TriangleMesh& mesh)
        : triangles(trianglesOf(mesh)), tree(triangles.cbegin(), triangles.cend()) {}

    int indexOf(Triangles::const_iterator triangle) const {
        return static_cast<int>(triangle - triangles.cbegin());
    }
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
TriangleTree::~TriangleTree() = default;

void TriangleTree::prepareNearest() {
    impl_->tree.accelerate_distance_queries();
}

TriangleTree::Foot TriangleTree::nearest(const Vec3& x) const {
    const auto [place, triangle] = impl_->tree.closest_point_and_primitive(toPoint(x));
    return {toVec3(place), impl_->indexOf(triangle)};
}

double TriangleTree::distance(const Vec3& x, int triangle) const {
    return std::sqrt(
        CGAL::squared_distance(toPoint(x), impl_->triangles[static_cast<std::size_t>(triangle)]));
}

std::optional<TriangleTree::Hit> TriangleTree::firstHit(const Vec3& from, const Vec3& through,
                                                        int left_out) const {
    const auto isLeftOut = [&](const auto& triangle) { return impl_->indexOf(triangle) == left_out; };
    const auto hit =
        impl_->tree.first_intersection(Kernel::Ray_3(toPoint(from), toPoint(through)), isLeftOut);
    if (!hit) return std::nullopt;
    Hit met;
    met.triangle = impl_->indexOf(hit->second);
    if (const auto* place = boost::get<Kernel::Point_3>(&hit->first)) met.place = toVec3(*place);
    return met;
}

std::vector<int> TriangleTree::within(double distance, const Vec3& x) const {
    std::vector<Triangles::const_iterator> met;
    impl_->tree.all_intersected_primitives(Kernel::Sphere_3(toPoint(x), distance * distance),
                                           std::back_inserter(met));
    std::vector<int> triangles;
    for (const auto& triangle : met) triangles.push_back(impl_->indexOf(triangle));
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace sherd
