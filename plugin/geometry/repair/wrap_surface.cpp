#include "geometry/repair/wrap_surface.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes iterators of CGAL's triangulation for unset values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/union_find.h"
#include "geometry/repair/cgal_mesh.h"
#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

struct Soup {
    std::vector<RepairKernel::Point_3> points;
    std::vector<std::array<std::size_t, 3>> faces;

    explicit Soup(const TriangleMesh& mesh) {
        for (const Vec3& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
        for (const auto& [a, b, c] : mesh.triangles)
            faces.push_back({std::size_t(a), std::size_t(b), std::size_t(c)});
    }
};

/// Of each connected region of a lattice that lies deeper than `depth` the deepest point.
std::vector<RepairKernel::Point_3> deepestPoints(const TriangleMesh& solid, double depth) {
    const Eigen::AlignedBox3d box = boundingBox(solid);
    constexpr double most = 60;  // lattice points along the longest side
    const double step = std::max(depth, box.sizes().maxCoeff() / most);
    Eigen::Vector3i count;
    for (int d = 0; d < 3; ++d) count[d] = static_cast<int>(box.sizes()[d] / step) + 1;
    const RepairMesh surface = toRepairMesh(solid);
    const CGAL::Side_of_triangle_mesh<RepairMesh, RepairKernel> side(surface);
    const TriangleTree tree(solid);
    const auto index = [&](int i, int j, int k) { return (k * count.y() + j) * count.x() + i; };
    const int total = count.prod();
    std::vector<double> depths(total, 0);
    std::vector<RepairKernel::Point_3> points(total);
    const Vec3 start = box.center() - step / 2 * (count - Eigen::Vector3i::Ones()).cast<double>();
    for (int k = 0; k < count.z(); ++k)
        for (int j = 0; j < count.y(); ++j)
            for (int i = 0; i < count.x(); ++i) {
                const Vec3 x = start + step * Vec3(i, j, k);
                const RepairKernel::Point_3 point(x.x(), x.y(), x.z());
                points[index(i, j, k)] = point;
                const double distance = (tree.nearest(x).position - x).norm();
                if (distance > depth && side(point) == CGAL::ON_BOUNDED_SIDE)
                    depths[index(i, j, k)] = distance;
            }
    UnionFind regions(total);
    for (int k = 0; k < count.z(); ++k)
        for (int j = 0; j < count.y(); ++j)
            for (int i = 0; i < count.x(); ++i)
                for (const auto& [di, dj, dk] : {std::array<int, 3>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
                    if (i + di >= count.x() || j + dj >= count.y() || k + dk >= count.z()) continue;
                    const int here = index(i, j, k), there = index(i + di, j + dj, k + dk);
                    if (depths[here] > 0 && depths[there] > 0) regions.unite(here, there);
                }
    std::vector<int> deepest(total, -1);
    for (int p = 0; p < total; ++p) {
        int& best = deepest[regions.root(p)];
        if (depths[p] > 0 && (best < 0 || depths[p] > depths[best])) best = p;
    }
    std::vector<RepairKernel::Point_3> seeds;
    for (const int p : deepest)
        if (p >= 0) seeds.push_back(points[p]);
    return seeds;
}

}  // namespace

TriangleMesh wrapped(const TriangleMesh& mesh, double alpha, double offset) {
    const Soup soup(mesh);
    RepairMesh wrap;
    CGAL::alpha_wrap_3(soup.points, soup.faces, alpha, offset, wrap);
    return toTriangleMesh(wrap);
}

TriangleMesh cavityOf(const TriangleMesh& solid, double thickness, double alpha) {
    const std::vector<RepairKernel::Point_3> seeds = deepestPoints(solid, thickness + alpha);
    if (seeds.empty()) return {};
    const Soup soup(solid);
    using Oracle = CGAL::Alpha_wraps_3::internal::Triangle_soup_oracle<RepairKernel>;
    Oracle oracle(alpha, RepairKernel());
    oracle.add_triangle_soup(soup.points, soup.faces, CGAL::parameters::default_values());
    CGAL::Alpha_wraps_3::internal::Alpha_wrap_3<Oracle> builder(oracle);
    RepairMesh cavity;
    builder(alpha, thickness, cavity, CGAL::parameters::seed_points(std::cref(seeds)));
    return toTriangleMesh(cavity);
}

}  // namespace sherd
