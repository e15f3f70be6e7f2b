#include "geometry/cutting/lattice_spacing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numerics/mesh_measures.h"
#include "geometry/cutting/lattice_grid.h"

namespace sherd {

double latticeSpacing(const TriangleMesh& surface, double particle_spacing, double largest_node_count,
                      double largest) {
    constexpr double share = 0.65;  // of the particle spacing: fine enough for round edges
    double spacing = share * particle_spacing;
    if (largest > 0) spacing = std::min(spacing, largest);
    const Vec3 size = boundingBox(surface.vertices).sizes().array() + 2 * lattice_margin * spacing;
    return std::max(spacing, std::cbrt(size.prod() / largest_node_count));
}

double spacingAtBorders(const Discretisation& solid, const FragmentLabels& labels) {
    std::vector<double> at_borders;
    for (std::size_t i = 0; i < solid.neighbours.size(); ++i)
        for (int j : solid.neighbours[i])
            if (labels.of_particle[j] != labels.of_particle[i]) {
                at_borders.push_back(solid.particles[i].spacing);
                break;
            }
    if (at_borders.empty()) return solid.spacing;
    const auto fine = at_borders.begin() + static_cast<long>(at_borders.size() / 5);
    std::nth_element(at_borders.begin(), fine, at_borders.end());
    return *fine;
}

}  // namespace sherd
