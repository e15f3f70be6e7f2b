#include "geometry/surface_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include "geometry/surface_topology.h"

namespace sherd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;

Point toPoint(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

std::array<Vec3, 3> corners(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

Vec3 centre(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = corners(mesh, triangle);
    return (a + b + c) / 3;
}

Status checkNumbers(const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        return Error{"The surface is empty: it has no triangles; give the closed surface of a solid."};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (!mesh.vertices[v].allFinite())
            return Error{"Vertex " + std::to_string(v) + " of the surface is at " +
                         describePlace(mesh.vertices[v]) + ", which is not finite; correct its coordinates."};
    const int count = static_cast<int>(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int corner : mesh.triangles[t])
            if (corner < 0 || corner >= count)
                return Error{"Triangle " + std::to_string(t) + " of the surface names vertex " +
                             std::to_string(corner) + ", but vertices are numbered 0 to " +
                             std::to_string(count - 1) + "; correct the number."};
    return success();
}

Status checkAreas(const TriangleMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = corners(mesh, t);
        if (CGAL::collinear(toPoint(a), toPoint(b), toPoint(c)))
            return Error{"Triangle " + std::to_string(t) + " at " + describePlace(centre(mesh, t)) +
                         " has no area: its corners lie on one line or coincide; collapse its short edge, or "
                         "flip its long one."};
    }
    return success();
}

/// A connected part of the surface.
struct Shell {
    std::vector<int> triangles;
    Eigen::AlignedBox3d box;
    double volume = 0;  ///< signed: negative when the triangles face inward
    double area = 0;
    int first_vertex = -1;
};

std::vector<Shell> splitShells(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges) {
    const std::vector<int> shell_of = shellOfTriangle(mesh, edges);
    std::vector<Shell> shells(*std::max_element(shell_of.begin(), shell_of.end()) + 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Shell& shell = shells[shell_of[t]];
        if (shell.triangles.empty()) shell.first_vertex = mesh.triangles[t][0];
        shell.triangles.push_back(static_cast<int>(t));
        const Vec3 origin = mesh.vertices[shell.first_vertex];
        const auto [a, b, c] = corners(mesh, t);
        shell.box.extend(a).extend(b).extend(c);
        shell.volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
        shell.area += (b - a).cross(c - a).norm() / 2;
    }
    return shells;
}

Status checkVolumes(const TriangleMesh& mesh, const std::vector<Shell>& shells) {
    // A sheet of side L and thickness 1e-8 L is still a solid; rounding is far below that.
    for (const Shell& shell : shells)
        if (std::abs(shell.volume) < 1e-9 * std::pow(shell.area, 1.5))
            return Error{
                "The part of the surface at " + describePlace(mesh.vertices[shell.first_vertex]) +
                " (triangle " + std::to_string(shell.triangles.front()) +
                ") encloses no volume: its two sides lie on each other; give it a thickness, or remove it."};
    return success();
}

CgalMesh toCgalMesh(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    CgalMesh result;
    std::vector<CgalMesh::Vertex_index> vertex_of(mesh.vertices.size());
    for (const int t : triangles) {
        std::array<CgalMesh::Vertex_index, 3> face;
        for (int k = 0; k < 3; ++k) {
            auto& vertex = vertex_of[mesh.triangles[t][k]];
            if (!vertex.is_valid()) vertex = result.add_vertex(toPoint(mesh.vertices[mesh.triangles[t][k]]));
            face[k] = vertex;
        }
        result.add_face(face);
    }
    return result;
}

Vec3 overlapCentre(const TriangleMesh& mesh, std::size_t first, std::size_t second) {
    Eigen::AlignedBox3d boxes[2];
    for (const Vec3& corner : corners(mesh, first)) boxes[0].extend(corner);
    for (const Vec3& corner : corners(mesh, second)) boxes[1].extend(corner);
    return boxes[0].intersection(boxes[1]).center();
}

Status checkCrossings(const TriangleMesh& mesh) {
    std::vector<int> all(mesh.triangles.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
    const CgalMesh whole = toCgalMesh(mesh, all);
    std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> crossings;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(whole,
                                                                            std::back_inserter(crossings));
    if (crossings.empty()) return success();
    for (auto& [a, b] : crossings)
        if (b < a) std::swap(a, b);
    const auto [a, b] = *std::min_element(crossings.begin(), crossings.end());
    return Error{"The surface intersects itself: triangles " + std::to_string(std::size_t(a)) + " and " +
                 std::to_string(std::size_t(b)) + " cross near " + describePlace(overlapCentre(mesh, a, b)) +
                 " (" + std::to_string(crossings.size()) +
                 " such pairs); unite overlapping parts into one surface, or pull them apart."};
}

/// Tells whether points lie inside one shell; the search tree is made when first asked.
class ShellInterior {
  public:
    bool contains(const TriangleMesh& mesh, const Shell& shell, const Vec3& point) {
        if (!shell.box.contains(point)) return false;
        if (!side_) {
            surface_ = toCgalMesh(mesh, shell.triangles);
            side_.emplace(surface_);
        }
        return (*side_)(toPoint(point)) == CGAL::ON_BOUNDED_SIDE;
    }

  private:
    CgalMesh surface_;
    std::optional<CGAL::Side_of_triangle_mesh<CgalMesh, Kernel>> side_;
};

/// How many other shells each shell lies in: solid begins at even depths, a cavity at odd ones.
std::vector<int> nestingDepths(const TriangleMesh& mesh, const std::vector<Shell>& shells) {
    std::vector<int> depths(shells.size(), 0);
    if (shells.size() == 1) return depths;
    std::vector<ShellInterior> interiors(shells.size());
    for (std::size_t inner = 0; inner < shells.size(); ++inner)
        for (std::size_t outer = 0; outer < shells.size(); ++outer)
            if (inner != outer &&
                interiors[outer].contains(mesh, shells[outer], mesh.vertices[shells[inner].first_vertex]))
                ++depths[inner];
    return depths;
}

Status checkOrientation(const TriangleMesh& mesh, const std::vector<Shell>& shells) {
    const std::vector<int> depths = nestingDepths(mesh, shells);
    const auto isInverted = [&](std::size_t s) { return (shells[s].volume > 0) != (depths[s] % 2 == 0); };
    std::size_t inverted = 0, first = shells.size();
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (!isInverted(s)) continue;
        ++inverted;
        first = std::min(first, s);
    }
    if (inverted == 0) return success();
    if (inverted == shells.size())
        return Error{
            "The surface is inside out: its triangles face inward, so its volume is negative; reverse the "
            "order of the corners in every face."};
    const std::string part = "The part of the surface at " +
                             describePlace(mesh.vertices[shells[first].first_vertex]) + " (triangle " +
                             std::to_string(shells[first].triangles.front()) + ")";
    if (depths[first] % 2 == 0)
        return Error{part + " is inside out; reverse the order of the corners in its faces."};
    return Error{part +
                 " lies inside another part and faces outward; if it is a cavity, reverse the order of the "
                 "corners in its faces, otherwise remove it."};
}

Status checkEverything(const TriangleMesh& mesh) {
    if (Status numbers = checkNumbers(mesh); !numbers) return numbers;
    if (Status areas = checkAreas(mesh); !areas) return areas;
    const Result<std::vector<SharedEdge>> edges = closedManifoldEdges(mesh);
    if (!edges) return Error{edges.error()};
    const std::vector<Shell> shells = splitShells(mesh, edges.value());
    if (Status volumes = checkVolumes(mesh, shells); !volumes) return volumes;
    if (Status crossings = checkCrossings(mesh); !crossings) return crossings;
    return checkOrientation(mesh, shells);
}

}  // namespace

Status checkSurface(const TriangleMesh& mesh) {
    try {
        return checkEverything(mesh);
    } catch (const std::exception& fault) {
        return Error{std::string("The surface could not be checked: ") + fault.what() +
                     "; simplify or repair the mesh."};
    }
}

}  // namespace sherd
