#include "implicit_mesher.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <cmath>
#include <exception>

namespace sherd::generators {
namespace {

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
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

}  // namespace sherd::generators
