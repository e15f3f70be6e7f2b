#include "geometry/shells.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/mesh_measures.h"

namespace sherd {

bool Shell::isFlat() const {
    // A sheet of side L and thickness 1e-8 L is still a solid; rounding is far below that.
    constexpr double no_volume = 1e-9;
    return std::abs(volume_m3) < no_volume * std::pow(area_m2, 1.5);
}

std::vector<Shell> shellsOf(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges) {
    const std::vector<int> shell_of = shellOfTriangle(mesh, edges);
    std::vector<Shell> shells(*std::max_element(shell_of.begin(), shell_of.end()) + 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Shell& shell = shells[shell_of[t]];
        if (shell.triangles.empty()) shell.first_vertex = mesh.triangles[t][0];
        shell.triangles.push_back(static_cast<int>(t));
        const Vec3& origin = mesh.vertices[shell.first_vertex];
        const auto [a, b, c] = cornersOf(mesh, t);
        shell.box.extend(a).extend(b).extend(c);
        shell.volume_m3 += (a - origin).dot((b - origin).cross(c - origin)) / 6;
        shell.area_m2 += areaVector({a, b, c}).norm();
    }
    return shells;
}

int solidCount(const TriangleMesh& mesh) {
    const std::vector<Shell> shells = shellsOf(mesh, surfaceTopology(mesh).edges);
    return static_cast<int>(
        std::count_if(shells.begin(), shells.end(), [](const Shell& shell) { return shell.volume_m3 > 0; }));
}

std::string describeShell(const TriangleMesh& mesh, const Shell& shell) {
    return "The part of the surface at " + describePlace(mesh.vertices[shell.first_vertex]) + " (" +
           describeTriangle(mesh, shell.triangles.front()) + ")";
}

std::string suchParts(std::size_t count) {
    return count < 2 ? "" : " (" + std::to_string(count) + " such parts)";
}

}  // namespace sherd
