#include "geometry/cutting/triangle_subdivision.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "core/numerics/union_find.h"
#include "geometry/cutting/chain_subdivision.h"

namespace sherd {

namespace {

using Kernel = PlaneKernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<bool, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure, CGAL::No_constraint_intersection_tag>;

using Edge = std::pair<int, int>;

/// Joins the parts of one triangle, which may be many, to polygons.
class Joining {
  public:
    /// The parts begin at `first`.
    Joining(const std::vector<Triangle>& triangles, std::size_t first)
        : count_(static_cast<int>(triangles.size() - first)) {
        sides_.reserve(3 * static_cast<std::size_t>(count_));
        for (int part = 0; part < count_; ++part)
            for (int i = 0; i < 3; ++i) {
                const Triangle& t = triangles[first + static_cast<std::size_t>(part)];
                sides_.push_back({{t[i], t[(i + 1) % 3]}, part});
            }
        std::sort(sides_.begin(), sides_.end());
    }

    /// False if an edge of the loop or a side of a segment has no part.
    bool join(const std::vector<int>& loop, const std::vector<Edge>& segments,
              TrianglePolygons& polygons) const {
        polygons.of_part = joined(segments);
        polygons.count = count_;
        const auto polygonAt = [&](int a, int b) {
            const int part = partAt({a, b});
            return part < 0 ? -1 : polygons.of_part[part];
        };
        bool complete = true;
        polygons.at_edge.clear();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            polygons.at_edge.push_back(polygonAt(loop[k], loop[(k + 1) % loop.size()]));
            complete = complete && polygons.at_edge.back() >= 0;
        }
        polygons.beside_segments.clear();
        for (const auto& [a, b] : segments) {
            polygons.beside_segments.push_back({polygonAt(a, b), polygonAt(b, a)});
            const auto& [left, right] = polygons.beside_segments.back();
            complete = complete && left >= 0 && right >= 0;
        }
        return complete;
    }

  private:
    /// For each part the lowest one that is connected to it without crossing a segment.
    std::vector<int> joined(std::vector<Edge> segments) const {
        const auto turned = [](const Edge& edge) { return Edge{edge.second, edge.first}; };
        for (std::size_t s = 0, given = segments.size(); s < given; ++s)
            segments.push_back(turned(segments[s]));
        std::sort(segments.begin(), segments.end());
        UnionFind sets(static_cast<std::size_t>(count_));
        for (const auto& [edge, part] : sides_) {
            const int other = partAt(turned(edge));
            if (other >= 0 && !std::binary_search(segments.begin(), segments.end(), edge))
                sets.unite(part, other);
        }
        return sets.roots();
    }

    /// Along which an edge runs, or -1.
    int partAt(const Edge& edge) const {
        const auto side = std::lower_bound(sides_.begin(), sides_.end(), std::make_pair(edge, -1));
        return side == sides_.end() || side->first != edge ? -1 : side->second;
    }

    int count_;
    std::vector<std::pair<Edge, int>> sides_;  // directed edges and the parts that run along them
};

}  // namespace

struct TriangleSubdivision::Impl {
    ChainSubdivision chains;
    Triangulation cdt;
    std::vector<std::pair<int, Triangulation::Vertex_handle>> vertices;  // few: searched linearly

    Triangulation::Vertex_handle vertex(const std::vector<Vec3>& points, const Vec3& normal, int point) {
        for (const auto& [id, handle] : vertices)
            if (id == point) return handle;
        const auto handle = cdt.insert(project(points[point], normal));
        handle->info() = point;
        vertices.emplace_back(point, handle);
        return handle;
    }

    // A constraint through a third vertex would be split there: not the edge that the neighbour has.
    bool constrain(Triangulation::Vertex_handle a, Triangulation::Vertex_handle b) {
        if (a == b) return false;
        cdt.insert_constraint(a, b);
        return cdt.is_edge(a, b);
    }

    // Marks the faces outside of the loop: rounding moves points off the edge that they lie on, which leaves
    // slivers between the loop and its convex hull.
    void markOutside() {
        for (auto f : cdt.all_face_handles()) f->info() = true;
        std::vector<Triangulation::Face_handle> front = {cdt.infinite_face()};
        front.back()->info() = false;
        while (!front.empty()) {
            const auto face = front.back();
            front.pop_back();
            for (int i = 0; i < 3; ++i) {
                const auto next = face->neighbor(i);
                if (!next->info() || face->is_constrained(i)) continue;
                next->info() = false;
                front.push_back(next);
            }
        }
    }
};

TriangleSubdivision::TriangleSubdivision() : impl_(new Impl) {}
TriangleSubdivision::~TriangleSubdivision() = default;

bool TriangleSubdivision::split(const std::vector<Vec3>& points, const Vec3& normal,
                                const std::vector<int>& loop,
                                const std::vector<std::pair<int, int>>& segments, std::vector<Triangle>& out,
                                TrianglePolygons& polygons) {
    if (impl_->chains.split(points, normal, loop, segments, out, polygons)) return true;
    Triangulation& cdt = impl_->cdt;
    cdt.clear();
    impl_->vertices.clear();
    try {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto a = impl_->vertex(points, normal, loop[i]);
            if (!impl_->constrain(a, impl_->vertex(points, normal, loop[(i + 1) % loop.size()])))
                return false;
        }
        for (const auto& [a, b] : segments)
            if (!impl_->constrain(impl_->vertex(points, normal, a), impl_->vertex(points, normal, b)))
                return false;
    } catch (const std::exception&) {  // CGAL throws when constraints cross
        return false;
    }
    // Two points that fall together share a vertex.
    if (cdt.number_of_vertices() != impl_->vertices.size()) return false;
    impl_->markOutside();
    const std::size_t before = out.size();
    for (auto f : cdt.finite_face_handles())
        if (f->info()) out.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    // Euler: a polygon with n points on its loop and m inside has n + 2 m - 2 triangles.
    const std::size_t inner = impl_->vertices.size() - loop.size();
    if (out.size() - before == loop.size() + 2 * inner - 2 &&
        Joining(out, before).join(loop, segments, polygons))
        return true;
    out.resize(before);
    return false;
}

}  // namespace sherd
