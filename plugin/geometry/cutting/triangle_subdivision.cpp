#include "geometry/cutting/triangle_subdivision.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "core/numerics/union_find.h"

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

/// Joins the parts of one triangle to polygons. They are few, so edges are searched linearly.
class Joining {
  public:
    explicit Joining(std::vector<Triangle> parts) : parts_(std::move(parts)) {}

    /// False if an edge of the loop or a side of a segment has no part.
    bool join(const std::vector<int>& loop, const std::vector<std::pair<int, int>>& segments,
              TrianglePolygons& polygons) const {
        UnionFind sets(parts_.size());
        for (std::size_t p = 0; p < parts_.size(); ++p)
            for (int i = 0; i < 3; ++i) {
                const int a = parts_[p][i], b = parts_[p][(i + 1) % 3], other = partAt(b, a);
                const bool is_segment = std::any_of(segments.begin(), segments.end(), [&](const auto& s) {
                    return s == std::make_pair(a, b) || s == std::make_pair(b, a);
                });
                if (other >= 0 && !is_segment) sets.unite(static_cast<int>(p), other);
            }
        const std::vector<int> roots = sets.roots();
        const auto polygonAt = [&](int a, int b) {
            const int part = partAt(a, b);
            return part < 0 ? -1 : roots[part];
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
        polygons.of_part = roots;
        polygons.count = static_cast<int>(parts_.size());
        return complete;
    }

  private:
    /// Where an edge runs from a to b, or -1.
    int partAt(int a, int b) const {
        for (std::size_t p = 0; p < parts_.size(); ++p)
            for (int i = 0; i < 3; ++i)
                if (parts_[p][i] == a && parts_[p][(i + 1) % 3] == b) return static_cast<int>(p);
        return -1;
    }

    std::vector<Triangle> parts_;
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
        Joining({out.begin() + static_cast<long>(before), out.end()}).join(loop, segments, polygons))
        return true;
    out.resize(before);
    return false;
}

}  // namespace sherd
