#include "scenes/box_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace demo {
namespace {

using GridPoint = std::array<int, 3>;

/// Collects the six sides; points on the box's edges belong to several sides and become one vertex each.
struct BoxSurface {
    Vec3 size;
    GridPoint divisions;
    sherd::TriangleMesh mesh;
    std::map<GridPoint, int> vertex_of;

    int vertex(const GridPoint& point) {
        const auto [found, is_new] = vertex_of.try_emplace(point, static_cast<int>(mesh.vertices.size()));
        if (is_new) {
            Vec3 position;
            for (int k = 0; k < 3; ++k)
                position[k] = size[k] * (static_cast<double>(point[k]) / divisions[k] - 0.5);
            mesh.vertices.push_back(position);
        }
        return found->second;
    }

    /// One square, counter-clockwise seen from outside. The diagonal alternates so that no direction is
    /// preferred.
    void square(const std::array<GridPoint, 4>& corners, bool flip) {
        std::array<int, 4> v{};
        std::transform(corners.begin(), corners.end(), v.begin(),
                       [this](const GridPoint& p) { return vertex(p); });
        const int first = flip ? 1 : 0;
        mesh.triangles.push_back({v[first], v[first + 1], v[first + 2]});
        mesh.triangles.push_back({v[first], v[first + 2], v[(first + 3) % 4]});
    }

    /// The side whose normal is along `axis`, at its low or high end.
    void side(int axis, bool high) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < divisions[u]; ++i) {
            for (int j = 0; j < divisions[v]; ++j) {
                GridPoint p{};
                p[axis] = high ? divisions[axis] : 0;
                std::array<GridPoint, 4> corners{p, p, p, p};
                const int du[4] = {0, 1, 1, 0}, dv[4] = {0, 0, 1, 1};
                for (int k = 0; k < 4; ++k) {
                    GridPoint& corner = corners[high ? k : 3 - k];
                    corner[u] = i + du[k];
                    corner[v] = j + dv[k];
                }
                square(corners, (i + j) % 2 != 0);
            }
        }
    }
};

}  // namespace

sherd::TriangleMesh boxMesh(const Box& box) {
    BoxSurface surface{box.size_m, {}, {}, {}};
    for (int k = 0; k < 3; ++k) {
        surface.divisions[k] = std::max(1, static_cast<int>(std::lround(box.size_m[k] / box.edge_m)));
    }
    for (int axis = 0; axis < 3; ++axis) {
        surface.side(axis, false);
        surface.side(axis, true);
    }
    return std::move(surface.mesh);
}

double boxEdge(const Vec3& size_m, int triangles) {
    const double area = 2 * (size_m.x() * size_m.y() + size_m.y() * size_m.z() + size_m.z() * size_m.x());
    return std::sqrt(2 * area / triangles);
}

}  // namespace demo
