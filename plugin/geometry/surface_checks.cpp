#include "geometry/surface_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/sentences.h"
#include "geometry/shells.h"
#include "geometry/surface_topology.h"

namespace sherd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;
using Faults = std::vector<std::string>;

Point toPoint(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Vec3 centre(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    return (a + b + c) / 3;
}

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

void checkAreas(const TriangleMesh& mesh, Faults& faults) {
    std::vector<int> flat;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = cornersOf(mesh, t);
        if (CGAL::collinear(toPoint(a), toPoint(b), toPoint(c))) flat.push_back(static_cast<int>(t));
    }
    if (flat.empty()) return;
    const std::string others =
        flat.size() < 2
            ? ""
            : " (" + std::to_string(flat.size()) + " such triangles: " + describeTriangles(mesh, flat) + ")";
    faults.push_back(capitalised(describeTriangle(mesh, flat[0])) + " at " +
                     describePlace(centre(mesh, flat[0])) +
                     " has no area: its corners lie on one line or coincide" + others +
                     "; collapse its short edge, or flip its long one.");
}

void checkVolumes(const TriangleMesh& mesh, const std::vector<Shell>& shells, Faults& faults) {
    const auto isFlat = [](const Shell& shell) { return shell.isFlat(); };
    const auto first = std::find_if(shells.begin(), shells.end(), isFlat);
    if (first == shells.end()) return;
    faults.push_back(describeShell(mesh, *first) + " encloses no volume: its two sides lie on each other" +
                     suchParts(std::count_if(shells.begin(), shells.end(), isFlat)) +
                     "; give it a thickness, or remove it.");
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
    for (const Vec3& corner : cornersOf(mesh, first)) boxes[0].extend(corner);
    for (const Vec3& corner : cornersOf(mesh, second)) boxes[1].extend(corner);
    return boxes[0].intersection(boxes[1]).center();
}

/// Pairs of triangles that cross, the lower number first.
using Crossings = std::vector<std::pair<int, int>>;

Crossings crossingsOf(const TriangleMesh& mesh) {
    std::vector<int> all(mesh.triangles.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
    const CgalMesh whole = toCgalMesh(mesh, all);
    std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(whole, std::back_inserter(found));
    Crossings crossings;
    for (const auto& [a, b] : found)
        crossings.push_back(std::minmax(static_cast<int>(a), static_cast<int>(b)));
    return crossings;
}

void describeCrossings(const TriangleMesh& mesh, const Crossings& crossings, Faults& faults) {
    if (crossings.empty()) return;
    const auto [a, b] = *std::min_element(crossings.begin(), crossings.end());
    const bool is_one_face = !mesh.file_faces.empty() && mesh.file_faces[a] == mesh.file_faces[b];
    faults.push_back("The surface intersects itself: " + describeTriangles(mesh, {a, b}) +
                     (is_one_face ? " folds over itself near " : " cross near ") +
                     describePlace(overlapCentre(mesh, a, b)) + " (" +
                     counted(crossings.size(), "such pair", "such pairs") +
                     "); unite overlapping parts into one surface, or pull them apart.");
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

using ShellPairs = std::set<std::pair<int, int>>;

ShellPairs crossingShells(const std::vector<Shell>& shells, const Crossings& crossings) {
    std::map<int, int> shell_of;
    for (std::size_t s = 0; s < shells.size(); ++s)
        for (const int t : shells[s].triangles) shell_of[t] = static_cast<int>(s);
    ShellPairs pairs;
    for (const auto& [a, b] : crossings) pairs.insert(std::minmax(shell_of.at(a), shell_of.at(b)));
    return pairs;
}

/// How many other shells each shell lies in: solid begins at even depths, a cavity at odd ones. Shells that
/// cross do not lie in each other.
std::vector<int> nestingDepths(const TriangleMesh& mesh, const std::vector<Shell>& shells,
                               const ShellPairs& crossing) {
    std::vector<int> depths(shells.size(), 0);
    if (shells.size() == 1) return depths;
    std::vector<ShellInterior> interiors(shells.size());
    for (std::size_t inner = 0; inner < shells.size(); ++inner)
        for (std::size_t outer = 0; outer < shells.size(); ++outer)
            if (inner != outer && !crossing.count(std::minmax(int(inner), int(outer))) &&
                interiors[outer].contains(mesh, shells[outer], mesh.vertices[shells[inner].first_vertex]))
                ++depths[inner];
    return depths;
}

void checkOrientation(const TriangleMesh& mesh, const std::vector<Shell>& shells, const Crossings& crossings,
                      Faults& faults) {
    const std::vector<int> depths = nestingDepths(mesh, shells, crossingShells(shells, crossings));
    const auto isInverted = [&](std::size_t s) { return (shells[s].volume_m3 > 0) != (depths[s] % 2 == 0); };
    std::size_t inverted = 0, first = shells.size();
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (shells[s].isFlat() || !isInverted(s)) continue;
        ++inverted;
        first = std::min(first, s);
    }
    if (inverted == 0) return;
    if (inverted == shells.size())
        return faults.push_back(
            "The surface is inside out: its triangles face inward, so its volume is negative; reverse the "
            "order of the corners in every face.");
    const std::string part = describeShell(mesh, shells[first]);
    if (depths[first] % 2 == 0)
        return faults.push_back(part + " is inside out" + suchParts(inverted) +
                                "; reverse the order of the corners in its faces.");
    faults.push_back(part + " lies inside another part and faces outward" + suchParts(inverted) +
                     "; if it is a cavity, reverse the order of the corners in its faces, otherwise remove "
                     "it.");
}

/// Of an open surface the volume about its own middle says which way most of it faces.
void checkOpenOrientation(const TriangleMesh& mesh, Faults& faults) {
    const Vec3 middle = boundingBox(mesh).center();
    constexpr double clearly = 0.02;  // of area^1.5; a whole ball has 0.094
    if (enclosedVolume(mesh.vertices, mesh.triangles, middle) < -clearly * std::pow(surfaceArea(mesh), 1.5))
        faults.push_back(
            "Most of the surface is inside out: its triangles face inward; reverse the order of the corners "
            "in every face.");
}

Faults faultsOf(const TriangleMesh& mesh) {
    if (Status numbers = checkNumbers(mesh); !numbers) return {numbers.error()};
    Faults faults;
    checkAreas(mesh, faults);
    const bool no_flat_ones = faults.empty();
    SurfaceTopology topology = surfaceTopology(mesh);
    const bool closed = topology.faults.empty();
    faults.insert(faults.end(), topology.faults.begin(), topology.faults.end());
    // Only a manifold, with or without borders, can be searched for crossings.
    const Crossings crossings = topology.manifold && no_flat_ones ? crossingsOf(mesh) : Crossings{};
    if (!closed) {
        checkOpenOrientation(mesh, faults);
    } else {
        const std::vector<Shell> shells = shellsOf(mesh, topology.edges);
        checkVolumes(mesh, shells, faults);
        if (no_flat_ones || shells.size() == 1) checkOrientation(mesh, shells, crossings, faults);
    }
    describeCrossings(mesh, crossings, faults);
    return faults;
}

std::string joined(const Faults& faults) {
    if (faults.size() == 1) return faults[0];
    std::string text = "The surface has " + std::to_string(faults.size()) + " kinds of faults:";
    for (std::size_t i = 0; i < faults.size(); ++i) text += " (" + std::to_string(i + 1) + ") " + faults[i];
    return text;
}

}  // namespace

Status checkSurface(const TriangleMesh& mesh) {
    try {
        const Faults faults = faultsOf(mesh);
        if (!faults.empty()) return Error{joined(faults)};
        return success();
    } catch (const std::exception& fault) {
        return Error{std::string("The surface could not be checked: ") + fault.what() +
                     "; simplify or repair the mesh."};
    }
}

}  // namespace sherd
