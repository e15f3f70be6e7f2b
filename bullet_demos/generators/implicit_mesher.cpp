#include "generators/implicit_mesher.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

namespace sherd::generators {
namespace {

/// A vertex or cell of a triangulation that knows its age. The mesher keeps sets of these, sorted by age
/// then, and otherwise by where in memory they happen to be, which is not the same at every call.
template <class Base>
class Stamped : public Base {
  public:
    template <class Structure>
    struct Rebind_TDS {
        using Other = Stamped<typename Base::template Rebind_TDS<Structure>::Other>;
    };
    using Has_timestamp = CGAL::Tag_true;

    using Base::Base;
    std::size_t time_stamp() const { return stamp_; }
    void set_time_stamp(const std::size_t& stamp) { stamp_ = stamp; }

  private:
    std::size_t stamp_ = static_cast<std::size_t>(-1);
};

using Traits = CGAL::Surface_mesh_default_triangulation_3::Geom_traits;
using Vertex = Stamped<CGAL::Surface_mesh_vertex_base_3<Traits>>;
using Cell = Stamped<CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<
    Traits, CGAL::Surface_mesh_cell_base_3<Traits>>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Traits, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Kernel = Triangulation::Geom_traits;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

Eigen::Vector3d toEigen(const Kernel::Point_3& p) {
    return {p.x(), p.y(), p.z()};
}

TriangleMesh delaunayMesh(const ImplicitSolid& solid, const MeshFineness& fineness) {
    const auto value = [&](const Kernel::Point_3& p) { return solid.distance(toEigen(p)); };
    const Eigen::Vector3d& c = solid.inner_point;
    const Kernel::Sphere_3 ball({c.x(), c.y(), c.z()}, solid.bounding_radius * solid.bounding_radius);
    const CGAL::Implicit_surface_3<Kernel, decltype(value)> surface(value, ball, 1e-7);
    const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, fineness.triangle_radius,
                                                                        fineness.surface_distance);
    CGAL::get_default_random() =
        CGAL::Random(1);  // the first points are random; without this, no two files are equal
    Triangulation triangulation;
    Complex complex(triangulation);
    CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());
    CgalMesh oriented;
    CGAL::facets_in_complex_2_to_triangle_mesh(complex, oriented);
    TriangleMesh mesh;
    for (const auto vertex : oriented.vertices()) mesh.vertices.push_back(toEigen(oriented.point(vertex)));
    for (const auto face : oriented.faces()) {
        std::array<int, 3> triangle{};
        int k = 0;
        for (const auto vertex : oriented.vertices_around_face(oriented.halfedge(face)))
            triangle[k++] = static_cast<int>(vertex);
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

Eigen::Vector3d gradient(const ImplicitSolid& solid, const Eigen::Vector3d& point) {
    const double step = 1e-6 * solid.bounding_radius;
    Eigen::Vector3d slope;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d offset = step * Eigen::Vector3d::Unit(axis);
        slope[axis] = (solid.distance(point + offset) - solid.distance(point - offset)) / (2 * step);
    }
    return slope;
}

/// Newton's way along the gradient to the surface.
Eigen::Vector3d project(const ImplicitSolid& solid, Eigen::Vector3d point) {
    for (int round = 0; round < 4; ++round) {
        const Eigen::Vector3d slope = gradient(solid, point);
        if (slope.squaredNorm() < 1e-6) break;
        point -= solid.distance(point) / slope.squaredNorm() * slope;
    }
    return point;
}

/// Every vertex goes half-way to the area-weighted centre of its triangles, and back to the surface: equal
/// areas are its rest.
void smooth(TriangleMesh& mesh, const ImplicitSolid& solid) {
    std::vector<Eigen::Vector3d> sums(mesh.vertices.size(), Eigen::Vector3d::Zero());
    std::vector<double> weights(mesh.vertices.size(), 0);
    for (const auto& [a, b, c] : mesh.triangles) {
        const Eigen::Vector3d &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const double area = (q - p).cross(r - p).norm() / 2;
        for (const int corner : {a, b, c}) {
            sums[corner] += area / 3 * (p + q + r);
            weights[corner] += area;
        }
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v] = project(solid, (mesh.vertices[v] + sums[v] / weights[v]) / 2);
}

/// Every triangle in four, with the new vertices on the surface.
TriangleMesh subdivided(const TriangleMesh& mesh, const ImplicitSolid& solid) {
    TriangleMesh fine;
    fine.vertices = mesh.vertices;
    std::map<std::pair<int, int>, int> middle_of;
    const auto middle = [&](int a, int b) {
        const auto [found, is_new] =
            middle_of.try_emplace(std::minmax(a, b), static_cast<int>(fine.vertices.size()));
        if (is_new) fine.vertices.push_back(project(solid, (mesh.vertices[a] + mesh.vertices[b]) / 2));
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const std::array<int, 3>& part :
             {std::array<int, 3>{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            fine.triangles.push_back(part);
    }
    return fine;
}

/// Both lengths of the fineness for triangles `scale` times as long: the distance to a curved surface grows
/// with the square.
MeshFineness scaled(const MeshFineness& fineness, double scale) {
    return {scale * fineness.triangle_radius, scale * scale * fineness.surface_distance,
            fineness.smoothing_rounds};
}

/// Delaunay refinement takes minutes for what a subdivision does in a second.
constexpr int largest_refined = 30000;
constexpr double count_tolerance = 0.01;

/// Up to `splits` of the longest edges, no two of one triangle, get a new vertex in the middle; each makes
/// two triangles more.
void splitLongestEdges(TriangleMesh& mesh, int splits) {
    struct Edge {
        double length = 0;
        int a = 0, b = 0;
        std::array<int, 2> triangles{};
    };
    std::map<std::pair<int, int>, int> first_triangle;
    std::vector<Edge> edges;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            const auto [found, is_new] = first_triangle.try_emplace(std::minmax(a, b), t);
            if (!is_new)
                edges.push_back({(mesh.vertices[a] - mesh.vertices[b]).norm(), a, b, {found->second, t}});
        }
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& p, const Edge& q) { return p.length > q.length; });
    std::vector<char> touched(mesh.triangles.size());
    for (const Edge& edge : edges) {
        if (splits <= 0) return;
        if (touched[edge.triangles[0]] || touched[edge.triangles[1]]) continue;
        const int middle = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back((mesh.vertices[edge.a] + mesh.vertices[edge.b]) / 2);
        for (const int t : edge.triangles) {
            std::array<int, 3> half = mesh.triangles[t];
            std::replace(half.begin(), half.end(), edge.a, middle);
            std::replace(mesh.triangles[t].begin(), mesh.triangles[t].end(), edge.b, middle);
            mesh.triangles.push_back(half);
            touched[t] = 1;
        }
        --splits;
    }
}

/// About `triangles` by refinement to a few less, whose number is taken to fall with the square of the edges'
/// length, and split edges for the rest.
TriangleMesh refinedToCount(const ImplicitSolid& solid, int triangles) {
    constexpr int most_tries = 8;
    constexpr double least = 0.85, aim = 0.93;
    double scale = 1;
    TriangleMesh mesh;
    for (int tries = 0; tries < most_tries; ++tries) {
        mesh = delaunayMesh(solid, scaled(solid.fineness, scale));
        const double ratio = static_cast<double>(mesh.triangles.size()) / triangles;
        if (ratio >= least && ratio <= 1) break;
        scale *= std::sqrt(ratio / aim);
    }
    splitLongestEdges(mesh, (triangles - static_cast<int>(mesh.triangles.size())) / 2);
    for (int round = 0; round < solid.fineness.smoothing_rounds; ++round) smooth(mesh, solid);
    return mesh;
}

void roundCoordinates(TriangleMesh& mesh) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        for (double& coordinate : vertex) coordinate = std::round(coordinate * 1e8) / 1e8 + 0.0;
}

}  // namespace

Result<TriangleMesh> meshImplicitSolid(const ImplicitSolid& solid, const MeshFineness& fineness) {
    try {
        TriangleMesh mesh = delaunayMesh(solid, fineness);
        for (int round = 0; round < fineness.smoothing_rounds; ++round) smooth(mesh, solid);
        roundCoordinates(mesh);
        return mesh;
    } catch (const std::exception& fault) {
        return Error{std::string("The solid could not be meshed: ") + fault.what() + "."};
    }
}

Result<TriangleMesh> meshWithCount(const ImplicitSolid& solid, int triangles) {
    constexpr int fewest = 2000, most = 1000000, rounds_after_subdivision = 3;
    if (triangles < fewest || triangles > most)
        return Error{"A generated mesh has from 2000 to 1000000 triangles, not " + std::to_string(triangles) +
                     "."};
    try {
        int halvings = 0, coarse = triangles;
        for (; coarse > largest_refined; coarse /= 4) ++halvings;
        TriangleMesh mesh = refinedToCount(solid, coarse);
        for (int i = 0; i < halvings; ++i) mesh = subdivided(mesh, solid);
        if (halvings > 0)
            for (int round = 0; round < rounds_after_subdivision; ++round) smooth(mesh, solid);
        roundCoordinates(mesh);
        const double reached = static_cast<double>(mesh.triangles.size());
        if (std::abs(reached / triangles - 1) > count_tolerance)
            return Error{"The nearest to " + std::to_string(triangles) + " triangles that was reached is " +
                         std::to_string(mesh.triangles.size()) + "; ask for that many."};
        return mesh;
    } catch (const std::exception& fault) {
        return Error{std::string("The solid could not be meshed: ") + fault.what() + "."};
    }
}

}  // namespace sherd::generators
