#include "geometry/cutting/lattice_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/cutting/active_cells.h"
#include "geometry/cutting/particle_reach.h"
#include "geometry/cutting/triangle_box.h"

namespace sherd {

namespace {

constexpr double jitter = 0.15;  // of the spacing

LatticeGrid gridOver(const TriangleMesh& surface, double spacing_m) {
    const Eigen::AlignedBox3d box = boundingBox(surface.vertices);
    LatticeGrid grid;
    grid.spacing = spacing_m;
    grid.jitter = jitter;
    grid.origin = box.min() - Vec3::Constant(lattice_margin * spacing_m);
    grid.size = ((box.max() - box.min()) / spacing_m).array().ceil().cast<int>() + 2 * lattice_margin + 1;
    return grid;
}

// The number of each node among those of active cells, else -1.
std::vector<int> placesOfNodes(const LatticeGrid& grid, const std::vector<int>& active_cells) {
    std::vector<int> places(grid.nodeCount(), -1);
    for (const int cell : active_cells)
        for (int corner = 0; corner < 8; ++corner) places[cell + grid.stepToCorner(corner)] = 0;
    int count = 0;
    for (int& place : places)
        if (place == 0) place = count++;
    return places;
}

// Calls visit(cell) for the cells whose cracks may meet a triangle.
template <class Visit>
void forEachCellAt(const LatticeGrid& grid, const TriangleBox& box, const Visit& visit) {
    // Nodes are jittered, so a cell reaches beyond its place on the grid. The lattice begins in the air below
    // the solid, so all of this is positive and truncation rounds down.
    const double reach = grid.jitter + 1e-6, cells_per_m = 1 / grid.spacing;
    int first[3], last[3];
    for (int d = 0; d < 3; ++d) {
        first[d] = static_cast<int>((box.low[d] - grid.origin[d]) * cells_per_m - reach);
        last[d] = static_cast<int>((box.high[d] - grid.origin[d]) * cells_per_m + reach);
    }
    for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i) visit(grid.index(i, j, k));
}

void listTriangles(const TriangleMesh& surface, LatticeLayout& layout) {
    std::vector<int> number_of(layout.grid.nodeCount(), -1);
    for (std::size_t c = 0; c < layout.active_cells.size(); ++c)
        number_of[layout.active_cells[c]] = static_cast<int>(c);
    std::vector<TriangleBox> boxes;
    boxes.reserve(surface.triangles.size());
    for (const Triangle& t : surface.triangles) boxes.push_back(boxOf(t, surface.vertices));
    std::vector<int>& first = layout.first_triangle;
    first.assign(layout.active_cells.size() + 1, 0);
    for (const TriangleBox& box : boxes)
        forEachCellAt(layout.grid, box, [&](int cell) { ++first[number_of[cell] + 1]; });
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    layout.triangles.resize(first.back());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t t = 0; t < boxes.size(); ++t)
        forEachCellAt(layout.grid, boxes[t],
                      [&](int cell) { layout.triangles[next[number_of[cell]]++] = static_cast<int>(t); });
}

// Calls visit(first, last) for the rows of nodes that the kernel of a particle may reach, wherever jitter
// puts the nodes.
template <class Visit>
void forEachRowInReach(const LatticeGrid& grid, const Particle& particle, const Visit& visit) {
    const Vec3 centre = (particle.position - grid.origin) / grid.spacing;
    const double sideways = grid.jitter + 1e-6, own_reach = kernelRadius(particle) / grid.spacing,
                 reach = own_reach + sideways;
    const Eigen::Vector3i first = (centre.array() - reach).ceil().cast<int>().max(0);
    const Eigen::Vector3i last = (centre.array() + reach).floor().cast<int>().min(grid.size.array() - 1);
    for (int k = first.z(); k <= last.z(); ++k)
        for (int j = first.y(); j <= last.y(); ++j) {
            const double dz = std::max(0.0, std::abs(k - centre.z()) - sideways),
                         dy = std::max(0.0, std::abs(j - centre.y()) - sideways),
                         squared_room = own_reach * own_reach - dz * dz - dy * dy;
            if (squared_room < 0) continue;
            const double room = std::sqrt(squared_room) + sideways;
            visit(grid.index(std::max(first.x(), static_cast<int>(std::ceil(centre.x() - room))), j, k),
                  grid.index(std::min(last.x(), static_cast<int>(std::floor(centre.x() + room))), j, k));
        }
}

// Calls visit(place, particle) for all pairs of a node and a particle that may reach it, by particle.
template <class Visit>
void forEachReached(const LatticeGrid& grid, const Discretisation& solid, const std::vector<int>& places,
                    const Visit& visit) {
    for (int i = 0; i < static_cast<int>(solid.particles.size()); ++i)
        forEachRowInReach(grid, solid.particles[i], [&](int first, int last) {
            for (int node = first; node <= last; ++node)
                if (places[node] >= 0) visit(places[node], i);
        });
}

void listParticles(const Discretisation& solid, const std::vector<int>& places, LatticeLayout& layout) {
    std::vector<int>& first = layout.first_particle;
    first.assign(layout.nodes.size() + 1, 0);
    forEachReached(layout.grid, solid, places, [&](int place, int) { ++first[place + 1]; });
    for (std::size_t n = 1; n < first.size(); ++n) first[n] += first[n - 1];
    layout.particles.resize(first.back());
    std::vector<int> next(first.begin(), first.end() - 1);
    forEachReached(layout.grid, solid, places,
                   [&](int place, int particle) { layout.particles[next[place]++] = particle; });
}

}  // namespace

LatticeLayout layLattice(const TriangleMesh& surface, const Discretisation& solid, double spacing_m) {
    LatticeLayout layout;
    layout.grid = gridOver(surface, spacing_m);
    layout.active_cells = findActiveCells(surface, layout.grid);
    listTriangles(surface, layout);
    const std::vector<int> places = placesOfNodes(layout.grid, layout.active_cells);
    for (int node = 0; node < static_cast<int>(places.size()); ++node)
        if (places[node] >= 0) layout.nodes.push_back(node);
    listParticles(solid, places, layout);
    return layout;
}

}  // namespace sherd
