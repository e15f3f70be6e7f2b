#include "geometry/cutting/cap_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <exception>

#include "geometry/cutting/plane_projection.h"

namespace sherd {

namespace {

using Kernel = PlaneKernel;
constexpr int unknown = -1;

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure, CGAL::No_constraint_intersection_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

using Outlines = std::vector<std::pair<int, int>>;

/// The points that edges start at, ascending; none if not every point has one that starts there and one that
/// ends there.
std::optional<std::vector<int>> pointsOf(const Outlines& edges) {
    std::vector<int> starts, ends;
    for (const auto& [from, to] : edges) {
        starts.push_back(from);
        ends.push_back(to);
    }
    std::sort(starts.begin(), starts.end());
    std::sort(ends.begin(), ends.end());
    if (starts != ends || std::adjacent_find(starts.begin(), starts.end()) != starts.end())
        return std::nullopt;
    return starts;
}

class CapTriangulation {
  public:
    /// `own`: the numbers of the points of the outlines. False if rounding makes these touch or cross.
    bool fill(const std::vector<Vec3>& points, const Vec3& normal, const std::vector<int>& own,
              const Outlines& outlines) {
        if (!insertPoints(points, normal, own) || !insertOutlines(outlines)) return false;
        markInside();
        return true;
    }

    std::vector<Triangle> inside() const {
        std::vector<Triangle> triangles;
        for (const Face face : cdt_.finite_face_handles())
            if (face->info() == 1)
                triangles.push_back(
                    {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
        return triangles;
    }

  private:
    Triangulation cdt_;
    std::vector<std::pair<int, Vertex>> vertices_;  // by point

    Vertex vertexOf(int point) const {
        return std::lower_bound(vertices_.begin(), vertices_.end(), std::make_pair(point, Vertex{}),
                                [](const auto& a, const auto& b) { return a.first < b.first; })
            ->second;
    }

    /// All at once, which CGAL does in an order that is fast. False if two points fall together, or all lie
    /// on a line.
    bool insertPoints(const std::vector<Vec3>& points, const Vec3& normal, const std::vector<int>& own) {
        std::vector<std::pair<Kernel::Point_2, int>> places;
        for (const int point : own) places.emplace_back(project(points[point], normal), point);
        cdt_.insert(places.begin(), places.end());
        for (const Vertex vertex : cdt_.finite_vertex_handles())
            vertices_.emplace_back(vertex->info(), vertex);
        std::sort(vertices_.begin(), vertices_.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        constexpr int plane = 2;  // less where all of them lie on one line
        return vertices_.size() == own.size() && cdt_.dimension() == plane;
    }

    /// An edge that lies on another point would be split there. False if outlines touch or cross.
    bool insertOutlines(const Outlines& outlines) {
        for (const auto& [from, to] : outlines) {
            const Vertex a = vertexOf(from), b = vertexOf(to);
            cdt_.insert_constraint(a, b);
            if (!cdt_.is_edge(a, b)) return false;
        }
        return true;
    }

    /// 1 in faces inside of the outlines, 0 outside: each outline on the way from the outside changes it.
    void markInside() {
        for (const Face face : cdt_.all_face_handles()) face->info() = unknown;
        std::vector<Face> front = {cdt_.infinite_face()};
        front.back()->info() = 0;
        while (!front.empty()) {
            const Face face = front.back();
            front.pop_back();
            for (int i = 0; i < 3; ++i) {
                const Face other = face->neighbor(i);
                if (other->info() != unknown) continue;
                other->info() = face->is_constrained(i) ? 1 - face->info() : face->info();
                front.push_back(other);
            }
        }
    }
};

}  // namespace

std::optional<std::vector<Triangle>> triangulateCap(const std::vector<Vec3>& points, const Vec3& normal,
                                                    const std::vector<std::pair<int, int>>& outlines) {
    if (outlines.empty()) return std::vector<Triangle>();
    const auto own = pointsOf(outlines);
    if (!own) return std::nullopt;
    CapTriangulation cap;
    try {
        if (!cap.fill(points, normal, *own, outlines)) return std::nullopt;
    } catch (const std::exception&) {  // CGAL throws when constraints cross
        return std::nullopt;
    }
    return cap.inside();
}

}  // namespace sherd
