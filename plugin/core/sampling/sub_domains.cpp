#include "core/sampling/sub_domains.h"

#include <algorithm>
#include <numeric>

#include "core/sampling/merge_small.h"

namespace sherd {
namespace {

int rootOf(std::vector<int>& parent, int i) {
    while (parent[std::size_t(i)] != i)
        i = parent[std::size_t(i)] = parent[std::size_t(parent[std::size_t(i)])];
    return i;
}

/// Parts of the solid that are connected inside one particle cell: the lowest cell of each stands for it.
std::vector<int> connectedParts(const CutCells& cells, const std::vector<long long>& particle_cell) {
    std::vector<int> parent(particle_cell.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const IntegrationFace& face : cells.faces) {
        const int a = rootOf(parent, face.cells[0]), b = rootOf(parent, face.cells[1]);
        if (particle_cell[std::size_t(face.cells[0])] == particle_cell[std::size_t(face.cells[1])])
            parent[std::size_t(std::max(a, b))] = std::min(a, b);
    }
    for (std::size_t c = 0; c < parent.size(); ++c) parent[c] = rootOf(parent, int(c));
    return parent;
}

/// Area of a face in faces of a whole particle cell.
double relativeArea(const SamplingGrid& grid, const IntegrationFace& face) {
    const Vec3 edge = grid.cell_size * grid.cells_per_spacing;
    return face.area.cwiseProduct(edge).sum() / edge.prod();
}

/// Numbers what stands for itself in ascending (particle cell, cell).
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
    const std::vector<int> part = connectedParts(cells, particle_cell);

    const double whole = grid.voxelVolume() * std::pow(grid.cells_per_spacing, 3);
    std::vector<double> fill(count, 0.0);
    for (std::size_t c = 0; c < count; ++c) fill[std::size_t(part[c])] += cells.moments[c].volume / whole;
    std::vector<SharedFace> shared;
    shared.reserve(cells.faces.size());
    for (const IntegrationFace& face : cells.faces) {
        const int a = part[std::size_t(face.cells[0])], b = part[std::size_t(face.cells[1])];
        if (a != b) shared.push_back({{a, b}, relativeArea(grid, face)});
    }
    // Cells that are not the lowest of their part share no face here and so stay out of the merging.
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
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(domains.count));
    for (const IntegrationFace& face : cells.faces) {
        const int a = domains.of_cell[std::size_t(face.cells[0])],
                  b = domains.of_cell[std::size_t(face.cells[1])];
        if (a == b) continue;
        neighbours[std::size_t(a)].push_back(b);
        neighbours[std::size_t(b)].push_back(a);
    }
    for (std::vector<int>& list : neighbours) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return neighbours;
}

}  // namespace sherd
