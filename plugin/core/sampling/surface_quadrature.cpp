#include "core/sampling/surface_quadrature.h"

#include "core/numerics/gauss_legendre.h"
#include "core/sampling/polygon_clipping.h"

namespace sherd {

std::vector<SurfaceNode> surfaceQuadrature(const TriangleMesh& surface, const CellParts& grid, int points) {
    const GaussRule rule = gaussLegendre(points);
    std::vector<SurfaceNode> result;
    const auto toWorld = [&](const Vec3& u) { return Vec3(grid.origin + u.cwiseProduct(grid.edges)); };
    const auto addTriangle = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 area = (b - a).cross(c - a);
        // x = a + u (b - a) + u v (c - b), dA = |area| u du dv
        for (int i = 0; i < points; ++i)
            for (int j = 0; j < points; ++j) {
                const double u = rule.points[i] + 0.5, v = rule.points[j] + 0.5;
                result.push_back(
                    {a + u * (b - a) + u * v * (c - b), u * rule.weights[i] * rule.weights[j] * area});
            }
    };
    const auto addPiece = [&](const Eigen::Vector3i&, const Polygon& polygon) {
        for (int i = 1; i + 1 < polygon.count; ++i)
            addTriangle(toWorld(polygon.points[0]), toWorld(polygon.points[i]),
                        toWorld(polygon.points[i + 1]));
    };
    for (const auto& [a, b, c] : surface.triangles) {
        Polygon triangle;
        for (const int v : {a, b, c})
            triangle.add((surface.vertices[v] - grid.origin).cwiseQuotient(grid.edges));
        triangle.close();
        forEachCellPiece(triangle, addPiece);
    }
    return result;
}

}  // namespace sherd
