#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "core/numerics/union_find.h"
#include "geometry/exact_union.h"
#include "geometry/repair/cgal_mesh.h"
#include "geometry/repair/mend_surface.h"
#include "geometry/shells.h"
#include "geometry/surface_mesh_conversion.h"

namespace sherd {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

struct Part {
    TriangleMesh mesh;
    Eigen::AlignedBox3d box;
    double volume = 0;
    int cluster = 0;  // parts that cross each other, directly or through others
    bool crosses_itself = false;
    std::vector<int> within;  // the parts that it lies in
};

void invert(Part& part) {
    for (auto& t : part.mesh.triangles) std::swap(t[1], t[2]);
    part.volume = -part.volume;
}

std::vector<Part> partsOf(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges,
                          RepairReport& report) {
    std::vector<Part> parts;
    for (const Shell& shell : shellsOf(mesh, edges)) {
        if (shell.isFlat()) {
            ++report.empty_parts;
            continue;
        }
        Part part;
        part.mesh = partOf(mesh, shell.triangles);
        part.box = shell.box;
        part.volume = shell.volume_m3;
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Which parts cross which.
void findClusters(std::vector<Part>& parts) {
    TriangleMesh all;
    std::vector<int> part_of;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        append(parts[p].mesh, all);
        part_of.resize(all.triangles.size(), static_cast<int>(p));
    }
    const RepairMesh surface = toRepairMesh(all);
    std::vector<std::pair<RepairMesh::Face_index, RepairMesh::Face_index>> crossings;
    pmp::self_intersections<CGAL::Sequential_tag>(surface, std::back_inserter(crossings));
    UnionFind clusters(static_cast<int>(parts.size()));
    for (const auto& [a, b] : crossings) {
        const int p = part_of[a], q = part_of[b];
        clusters.unite(p, q);
        parts[p].crosses_itself = parts[p].crosses_itself || p == q;
    }
    for (std::size_t p = 0; p < parts.size(); ++p) parts[p].cluster = clusters.root(static_cast<int>(p));
}

/// Only for parts of different clusters: those of one do not lie inside each other as a whole.
void findDepths(std::vector<Part>& parts) {
    for (std::size_t outer = 0; outer < parts.size(); ++outer) {
        std::unique_ptr<CGAL::Side_of_triangle_mesh<RepairMesh, RepairKernel>> side;
        const RepairMesh surface = toRepairMesh(parts[outer].mesh);
        for (Part& inner : parts) {
            if (&inner == &parts[outer] || !parts[outer].box.contains(inner.box)) continue;
            if (inner.cluster == parts[outer].cluster) continue;
            if (!side)
                side = std::make_unique<CGAL::Side_of_triangle_mesh<RepairMesh, RepairKernel>>(surface);
            const Vec3& v = inner.mesh.vertices[0];
            if ((*side)({v.x(), v.y(), v.z()}) != CGAL::ON_BOUNDED_SIDE) continue;
            inner.within.push_back(static_cast<int>(outer));
        }
    }
}

/// All outermost parts inside out: so is the whole mesh. Otherwise only those that are.
void turnOutward(std::vector<Part>& parts, RepairReport& report) {
    const bool all = std::none_of(parts.begin(), parts.end(),
                                  [](const Part& p) { return p.within.empty() && p.volume > 0; });
    for (Part& part : parts) {
        if (!all && (!part.within.empty() || part.volume > 0)) continue;
        invert(part);
        report.turned_triangles += static_cast<int>(part.mesh.triangles.size());
    }
}

/// How deep in material a part lies: 1 in a solid, 0 in the open or in a solid's cavity.
int materialAround(const Part& part, const std::vector<Part>& parts) {
    int around = 0;
    for (const int outer : part.within) around += parts[outer].volume > 0 ? 1 : -1;
    return around;
}

Result<TriangleMesh> unionOfCluster(const std::vector<const Part*>& cluster) {
    std::vector<ExactMesh> wholes;
    for (const Part* part : cluster) {
        if (part->crosses_itself) return Error{"A part crosses itself, so it cannot be united with others."};
        wholes.push_back(toSurfaceMesh<ExactMesh>(part->mesh));
    }
    // Neighbours first, then pairs of pairs: each triangle goes through few unions.
    for (std::size_t step = 1; step < wholes.size(); step *= 2)
        for (std::size_t p = 0; p + step < wholes.size(); p += 2 * step) {
            std::optional<ExactMesh> both = unionOf(std::move(wholes[p]), std::move(wholes[p + step]));
            if (!both) return Error{"Parts touch in an edge or a point only, so their union is no solid."};
            wholes[p] = std::move(*both);
        }
    return roundedMesh(wholes[0]);
}

}  // namespace

Status uniteParts(TriangleMesh& mesh, RepairReport& report) {
    const auto edges = closedManifoldEdges(mesh);
    if (!edges) return Error{edges.error()};
    std::vector<Part> parts = partsOf(mesh, edges.value(), report);
    if (parts.empty()) return Error{"No part of the surface encloses a volume."};
    if (parts.size() > 1) {
        findClusters(parts);
        findDepths(parts);
    }
    turnOutward(parts, report);
    TriangleMesh result;
    for (std::size_t root = 0; root < parts.size(); ++root) {
        std::vector<const Part*> cluster;
        for (const Part& part : parts)
            if (part.cluster == static_cast<int>(root)) cluster.push_back(&part);
        if (parts.size() == 1) cluster = {&parts[0]};
        if (cluster.empty()) continue;
        const Part& first = *cluster[0];
        if (cluster.size() == 1) {
            const bool cavity = first.volume < 0;
            const bool in_material = materialAround(first, parts) > 0;
            if (cavity == in_material)
                append(first.mesh, result);
            else
                ++report.united_parts;
            continue;
        }
        const Result<TriangleMesh> united = unionOfCluster(cluster);
        if (!united) return Error{united.error()};
        append(united.value(), result);
        report.united_parts += static_cast<int>(cluster.size()) - 1;
    }
    mesh = std::move(result);
    return success();
}

}  // namespace sherd
