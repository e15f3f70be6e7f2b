// Time to cut a body into 37 fragments: Sherd against CGAL's corefinement, which intersects the same mesh
// with the Voronoi cell of every fragment. Processor time of one thread. Usage: fragment_surfaces_benchmark
// [plate | cup]
//   plate: 1 x 1 x 0.09 m, 154,660 triangles, 968 particles, as the paper's walls; cup: 200,000 triangles

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_with_constructions_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <ctime>
#include <string>

#include "geometry/cutting/cut_fragments.h"
#include "geometry/cutting/fragment_support.h"
#include "geometry/mass_properties.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

double seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Mesh toCgal(const TriangleMesh& mesh) {
    Mesh result;
    for (const Vec3& v : mesh.vertices) result.add_vertex({v.x(), v.y(), v.z()});
    for (const auto& [a, b, c] : mesh.triangles)
        result.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
    return result;
}

std::vector<Vec3> clusterCentres(const Discretisation& solid, const FragmentLabels& labels) {
    std::vector<Vec3> sum(labels.count, Vec3::Zero());
    std::vector<int> count(labels.count, 0);
    for (std::size_t i = 0; i < solid.particles.size(); ++i) {
        sum[labels.of_particle[i]] += solid.particles[i].position;
        ++count[labels.of_particle[i]];
    }
    for (int l = 0; l < labels.count; ++l) sum[l] /= count[l];
    return sum;
}

Mesh voronoiCell(const std::vector<Vec3>& centres, std::size_t own) {
    std::vector<Kernel::Plane_3> planes;
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {-1, 1}) {
            const Vec3 n = side * Vec3::Unit(axis);
            planes.emplace_back(n.x(), n.y(), n.z(), -1);
        }
    for (std::size_t other = 0; other < centres.size(); ++other) {
        if (other == own) continue;
        const Vec3 n = centres[other] - centres[own];
        planes.emplace_back(n.x(), n.y(), n.z(), -n.dot(centres[other] + centres[own]) / 2);
    }
    Mesh cell;
    const Vec3& c = centres[own];
    CGAL::halfspace_intersection_with_constructions_3(planes.begin(), planes.end(), cell,
                                                      Kernel::Point_3(c.x(), c.y(), c.z()));
    pmp::triangulate_faces(cell);
    return cell;
}

}  // namespace

int main(int argc, char** argv) {
    const bool is_cup = argc > 1 && std::string(argv[1]) == "cup";
    const TriangleMesh body =
        is_cup ? shapes::cup(0.04, 0.09, 0.004, 250, 100) : shapes::slab({1, 1, 0.09}, 185, 185, 12);
    const Discretisation solid = fragment_support::particlesOnly(body, is_cup ? 0.004 : 1 / 22.0);
    const FragmentLabels labels = fragment_support::randomClusters(solid, 37, 1);

    double start = seconds();
    const auto fragments = cutFragments(body, solid, labels, {});
    const double ours = seconds() - start;
    if (!fragments) return std::printf("%s\n", fragments.error().c_str()), 1;

    const Mesh whole = toCgal(body);
    const std::vector<Vec3> centres = clusterCentres(solid, labels);
    double theirs = 0, volume = 0;
    for (std::size_t c = 0; c < centres.size(); ++c) {
        Mesh cell = voronoiCell(centres, c), copy = whole, piece;
        start = seconds();
        if (!pmp::corefine_and_compute_intersection(copy, cell, piece))
            std::printf("CGAL gave no piece %zu\n", c);
        theirs += seconds() - start;
        volume += pmp::volume(piece);
    }
    std::printf("%zu triangles, %zu particles\n", body.triangles.size(), solid.particles.size());
    std::printf("Sherd %7.3f s, %zu pieces\nCGAL  %7.3f s, %zu pieces, volume %.6g of %.6g\nratio %.0f\n",
                ours, fragments.value().pieces.size(), theirs, centres.size(), volume,
                solidMoments(body).volume, theirs / ours);
}
