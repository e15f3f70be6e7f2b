#include "core/sampling/sub_domains.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/union_find.h"
#include "core/sampling/merge_small.h"
#include "core/sampling/neighbour_lists.h"

namespace sherd {
namespace {

/// Parts of the solid that are connected inside one particle cell: of each integration cell the lowest one in
/// its part.
std::vector<int> partsOfParticleCells(const CutCells& cells, const std::vector<long long>& particle_cell) {
    UnionFind sets(particle_cell.size());
    for (const IntegrationFace& face : cells.faces)
        if (particle_cell[std::size_t(face.cells[0])] == particle_cell[std::size_t(face.cells[1])])
            sets.unite(face.cells[0], face.cells[1]);
    return sets.roots();
}

/// Area of a face in faces of a whole particle cell.
double relativeArea(const SamplingGrid& grid, const IntegrationFace& face) {
    const Vec3 edge = grid.cell_size * grid.cells_per_spacing;
    return face.area.cwiseProduct(edge).sum() / edge.prod();
}

/// Numbers the roots by their particle cells and, within one, by their integration cells.
SubDomains numberRoots(const std::vector<int>& root, const std::vector<long long>& particle_cell) {
    std::vector<int> order;
    for (int c = 0; c < int(root.size()); ++c)
        if (root[std::size_t(c)] == c) order.push_back(c);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return particle_cell[std::size_t(a)] < particle_cell[std::size_t(b)];
    });
    std::vector<int> number(root.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) number[std::size_t(order[i])] = int(i);
    SubDomains domains;
    domains.count = int(order.size());
    domains.of_cell.resize(root.size());
    for (std::size_t c = 0; c < root.size(); ++c) domains.of_cell[c] = number[std::size_t(root[c])];
    return domains;
}

}  // namespace

SubDomains findSubDomains(const SamplingGrid& grid, const CutCells& cells, double smallest_fill) {
    const std::size_t count = cells.moments.size();
    std::vector<long long> particle_cell(count);
    for (std::size_t c = 0; c < count; ++c)
        particle_cell[c] = grid.particleCellOf(grid.voxelAt(cells.home_voxel[c]));
    const std::vector<int> part = partsOfParticleCells(cells, particle_cell);

    const double whole = grid.voxelVolume() * std::pow(grid.cells_per_spacing, 3);
    std::vector<double> fill(count, 0.0);
    for (std::size_t c = 0; c < count; ++c) fill[std::size_t(part[c])] += cells.moments[c].volume / whole;
    std::vector<SharedFace> shared;
    shared.reserve(cells.faces.size());
    for (const IntegrationFace& face : cells.faces) {
        const int a = part[std::size_t(face.cells[0])], b = part[std::size_t(face.cells[1])];
        if (a != b) shared.push_back({{a, b}, relativeArea(grid, face)});
    }
    // `shared` names parts by their lowest cells only, so that all other cells stay out of the merging.
    const std::vector<int> merged = mergeSmall(std::move(fill), shared, smallest_fill);
    std::vector<int> root(count);
    for (std::size_t c = 0; c < count; ++c) root[c] = merged[std::size_t(part[c])];
    return numberRoots(root, particle_cell);
}

std::vector<Particle> placeParticles(const SamplingGrid& grid, const CutCells& cells,
                                     const SubDomains& domains) {
    std::vector<Particle> particles(static_cast<std::size_t>(domains.count));
    for (std::size_t c = 0; c < cells.moments.size(); ++c) {
        Particle& particle = particles[std::size_t(domains.of_cell[c])];
        particle.position += cells.moments[c].volume * (cells.moments[c].centroid - grid.origin);
        particle.volume += cells.moments[c].volume;
    }
    for (Particle& particle : particles) {
        particle.position = grid.origin + (particle.position / particle.volume).eval();
        particle.spacing = grid.cell_size.maxCoeff() * grid.cells_per_spacing;
    }
    return particles;
}

std::vector<std::vector<int>> neighboursThroughSolid(const CutCells& cells, const SubDomains& domains) {
    std::vector<std::array<int, 2>> links;
    links.reserve(cells.faces.size());
    for (const IntegrationFace& face : cells.faces)
        links.push_back(
            {domains.of_cell[std::size_t(face.cells[0])], domains.of_cell[std::size_t(face.cells[1])]});
    return neighbourLists(std::size_t(domains.count), links);
}

}  // namespace sherd
