#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes the empty callback of CGAL's self-intersection test for an unset value.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/repair/cgal_mesh.h"
#include "geometry/repair/mend_surface.h"
#include "geometry/repair/part_touching.h"
#include "geometry/repair/surface_distance.h"
#include "geometry/shells.h"

namespace sherd {
namespace {

using Face = RepairMesh::Face_index;
using Crossings = std::vector<std::pair<Face, Face>>;

constexpr int most_rings = 4;            // of triangles around what crosses
constexpr double few_crossings = 0.02;   // of the triangles, or a hundred
constexpr double largest_change = 0.01;  // of the size

Crossings crossingsOf(const TriangleMesh& mesh) {
    Crossings crossings;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(toRepairMesh(mesh),
                                                                            std::back_inserter(crossings));
    return crossings;
}

/// Chooses all triangles, too, that have a vertex in common with a chosen one.
void grow(const TriangleMesh& mesh, std::vector<char>& chosen) {
    std::vector<char> touched(mesh.vertices.size(), 0);
    for (std::size_t t = 0; t < chosen.size(); ++t)
        for (const int corner : mesh.triangles[t]) touched[corner] |= chosen[t];
    for (std::size_t t = 0; t < chosen.size(); ++t)
        for (const int corner : mesh.triangles[t]) chosen[t] |= touched[corner];
}

/// What is left without the chosen triangles: of pieces that no longer hang together, the largest.
TriangleMesh without(const TriangleMesh& part, const std::vector<char>& chosen) {
    std::vector<int> kept;
    for (std::size_t t = 0; t < chosen.size(); ++t)
        if (!chosen[t]) kept.push_back(static_cast<int>(t));
    if (kept.empty()) return {};
    const TriangleMesh rest = partOf(part, kept);
    const std::vector<Shell> pieces = shellsOf(rest, surfaceTopology(rest).edges);
    const auto largest = std::max_element(
        pieces.begin(), pieces.end(), [](const Shell& a, const Shell& b) { return a.area_m2 < b.area_m2; });
    return partOf(rest, largest->triangles);
}

bool isNear(const TriangleMesh& mesh, const TriangleMesh& other) {
    const double most = largest_change * boundingBox(mesh).diagonal().norm();
    return largestDistance(mesh, other, most / 10) <= most && largestDistance(other, mesh, most / 10) <= most;
}

/// One connected part in which triangles cross; returns whether they do no longer.
bool undoWithin(TriangleMesh& part, std::vector<char> crossing) {
    for (int rings = 0; rings <= most_rings; ++rings) {
        if (rings > 0) grow(part, crossing);
        TriangleMesh undone = without(part, crossing);
        if (undone.triangles.empty()) return false;
        RepairReport of_the_cut;  // its holes and touching corners are not the mesh's
        partTouching(undone, of_the_cut);
        fillHoles(undone, std::numeric_limits<double>::infinity(), of_the_cut);
        if (!surfaceTopology(undone).faults.empty() || !crossingsOf(undone).empty()) continue;
        if (!isNear(part, undone)) continue;
        part = std::move(undone);
        return true;
    }
    return false;
}

/// The crossings within each connected part.
std::map<int, Crossings> crossingsWithinParts(const TriangleMesh& mesh, const std::vector<int>& part_of) {
    std::map<int, Crossings> within;
    for (const auto& pair : crossingsOf(mesh))
        if (part_of[pair.first] == part_of[pair.second]) within[part_of[pair.first]].push_back(pair);
    return within;
}

}  // namespace

void undoCrossings(TriangleMesh& mesh, RepairReport& report) {
    const std::vector<int> part_of = shellOfTriangle(mesh, surfaceTopology(mesh).edges);
    const std::map<int, Crossings> within = crossingsWithinParts(mesh, part_of);
    if (within.empty()) return;
    std::vector<std::vector<int>> parts(*std::max_element(part_of.begin(), part_of.end()) + 1);
    std::vector<int> place(part_of.size());  // of a triangle in its part
    for (std::size_t t = 0; t < part_of.size(); ++t) {
        place[t] = static_cast<int>(parts[part_of[t]].size());
        parts[part_of[t]].push_back(static_cast<int>(t));
    }
    TriangleMesh result;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        TriangleMesh part = partOf(mesh, parts[p]);
        const auto found = within.find(static_cast<int>(p));
        const std::size_t count = found == within.end() ? 0 : found->second.size();
        const double most = std::max(100., few_crossings * static_cast<double>(part.triangles.size()));
        if (count > 0 && static_cast<double>(count) <= most) {
            std::vector<char> crossing(part.triangles.size(), 0);
            for (const auto& [a, b] : found->second) crossing[place[a]] = crossing[place[b]] = 1;
            if (undoWithin(part, std::move(crossing))) report.crossings += static_cast<int>(count);
        }
        append(part, result);
    }
    mesh = std::move(result);
}

}  // namespace sherd
