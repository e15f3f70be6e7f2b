#include "geometry/cutting/approximate_fragments.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/union_find.h"
#include "geometry/cutting/crack_roughness.h"
#include "geometry/cutting/crack_smoothing.h"
#include "geometry/cutting/lattice_building.h"
#include "geometry/cutting/lattice_spacing.h"
#include "geometry/cutting/marching_tetrahedra.h"
#include "geometry/cutting/pieces.h"
#include "geometry/cutting/surface_fitting.h"
#include "geometry/mass_properties.h"
#include "geometry/surface_checks.h"
#include "geometry/surface_mesh_conversion.h"
#include "geometry/triangle_tree.h"

namespace sherd {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double largest_lattice = 2e5;  // nodes
constexpr double nodes_across_wall = 3;
constexpr double smallest_crumb = 0.05;         // of a particle's mean volume
constexpr double largest_volume_change = 1.25;  // more means that walls are missing

// Gives the nodes outside of the body a label of their own.
void labelOutside(const TriangleMesh& surface, int outside, LabelLattice& lattice) {
    const auto mesh = toSurfaceMesh<CgalMesh>(surface);
    const CGAL::Side_of_triangle_mesh<CgalMesh, Kernel> side(mesh);
    for (std::size_t node = 0; node < lattice.nodes.size(); ++node) {
        const Vec3& x = lattice.nodes[node];
        if (lattice.labels[node] >= 0 && side(Kernel::Point_3(x.x(), x.y(), x.z())) != CGAL::ON_BOUNDED_SIDE)
            lattice.labels[node] = outside;
    }
}

// For each triangle the number of the connected set within one label that it belongs to.
std::vector<int> connectLabels(const CutFaces& faces) {
    const EdgeTable edges = buildEdgeTable(faces.body, static_cast<int>(faces.points.size()));
    UnionFind sets(faces.body.size());
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        const int first = edges.uses[edges.first_use[e]] / 3;
        for (int u = edges.first_use[e] + 1; u < edges.first_use[e + 1]; ++u)
            if (faces.body_label[edges.uses[u] / 3] == faces.body_label[first])
                sets.unite(first, edges.uses[u] / 3);
    }
    return sets.roots();
}

// The complex as the surface of a body (where it bounds the outside) and the cracks within.
CutFaces toFaces(const CrackComplex& complex, const std::vector<int>& triangle_at, int outside) {
    CutFaces faces;
    faces.points = complex.points;
    for (std::size_t k = 0; k < complex.triangles.size(); ++k) {
        Triangle t = complex.triangles[k];
        auto [below, above] = complex.sides[k];
        if (below != outside && above != outside) {
            faces.crack.push_back(t);
            faces.crack_sides.push_back(complex.sides[k]);
            continue;
        }
        if (below == outside) std::swap(t[1], t[2]), std::swap(below, above);
        faces.body.push_back(t);
        faces.body_label.push_back(below);
        // One corner at least is on an edge between inside and outside.
        faces.body_parent.push_back(std::max({triangle_at[t[0]], triangle_at[t[1]], triangle_at[t[2]]}));
    }
    faces.body_set = connectLabels(faces);
    faces.body_set_count = static_cast<int>(faces.body.size());
    return faces;
}

// Drops pieces of next to no volume that touch no other piece.
void dropCrumbs(const Discretisation& solid, std::vector<FragmentSurface>& pieces) {
    const double smallest_volume = smallest_crumb * meanParticleVolume(solid);
    const auto is_crumb = [&](const FragmentSurface& piece) {
        return std::all_of(piece.across.begin(), piece.across.end(), [](int other) { return other < 0; }) &&
               enclosedVolume(piece.mesh.vertices, piece.mesh.triangles, piece.mesh.vertices.front()) <
                   smallest_volume;
    };
    std::vector<int> new_index;
    int kept = 0;
    for (const FragmentSurface& piece : pieces) new_index.push_back(is_crumb(piece) ? -1 : kept++);
    for (FragmentSurface& piece : pieces)
        for (int& other : piece.across) other = other < 0 ? -1 : new_index[other];
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_crumb), pieces.end());
}

// Scales all pieces by the same factor about one point, so that they still fit together.
void scaleToVolume(const TriangleMesh& surface, double ratio, std::vector<FragmentSurface>& pieces) {
    const Vec3 centre = solidMoments(surface).centroid;
    const double scale = 1 / std::cbrt(ratio);
    for (FragmentSurface& piece : pieces)
        for (Vec3& v : piece.mesh.vertices) v = centre + scale * (v - centre);
}

std::string describe(const std::string& why, double spacing, double ratio) {
    char text[300];
    std::snprintf(
        text, sizeof text,
        "The surface could not be cut cleanly (%s): the fragments follow it to within %.3g mm only, and "
        "were scaled to make up for %.2g %% of the volume.",
        why.c_str(), 1000 * spacing, 100 * std::abs(ratio - 1));
    return text;
}

}  // namespace

Result<FragmentSurfaces> approximateFragments(const TriangleMesh& surface, const ParticleReach& reach,
                                              const Discretisation& solid, const FragmentLabels& labels,
                                              const CutSettings& settings, const std::string& why) {
    const double spacing = latticeSpacing(surface, spacingAtBorders(solid, labels), largest_lattice,
                                          wallThickness(surface) / nodes_across_wall);
    const int outside = labels.count;
    LabelLattice lattice =
        buildLabelLattice(std::make_shared<const LatticeLayout>(layLattice(surface, solid, spacing)), solid,
                          reach, labels, settings.seed);
    labelOutside(surface, outside, lattice);
    CrackComplex complex = buildCrackComplex(lattice);
    const TriangleTree tree(surface);
    const std::vector<int> triangle_at = fitToSurface(tree, lattice, outside, complex);
    smoothCracks(complex, lattice, smoothing_steps);
    if (settings.roughness > 0)
        roughenCracks(complex, lattice, settings.roughness * solid.spacing, settings.seed);
    auto assembled =
        assemblePieces(surface, toFaces(complex, triangle_at, outside), solid, labels, settings.pieces);
    if (!assembled)
        return Error{"The fragments' surfaces could not be cut (" + why + "; on the lattice " +
                     assembled.error() +
                     "); the body stays whole. Try another seed or another particle spacing, and check the "
                     "surface for "
                     "very thin or very small triangles."};
    FragmentSurfaces result = {std::move(assembled).value(), {}};
    dropCrumbs(solid, result.pieces);
    const double ratio = volumeRatio(surface, result.pieces);
    if (!(ratio > 1 / largest_volume_change && ratio < largest_volume_change))
        return Error{"The fragments' surfaces could not be cut (" + why +
                     "), and the body's walls are too thin for the lattice that replaces cutting; the body "
                     "stays whole. "
                     "Try another seed, or give the walls more thickness."};
    scaleToVolume(surface, ratio, result.pieces);
    result.notes.push_back(describe(why, spacing, ratio));
    return result;
}

}  // namespace sherd
