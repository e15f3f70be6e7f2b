#include "core/mlpg/particle_forms/support_graph.h"

#include <algorithm>

namespace sherd {
namespace {

/// Breadth-first walk from `start` over neighbours that `admits` accepts. `seen` is scratch: stamped with
/// `stamp`.
template <class Admits>
std::vector<int> connectedFrom(const Discretisation& solid, int start, std::vector<int>& seen, int stamp,
                               const Admits& admits) {
    std::vector<int> reached{start};
    seen[start] = stamp;
    for (size_t next = 0; next < reached.size(); ++next)
        for (int neighbour : solid.neighbours[reached[next]]) {
            if (seen[neighbour] == stamp || !admits(neighbour)) continue;
            seen[neighbour] = stamp;
            reached.push_back(neighbour);
        }
    std::sort(reached.begin(), reached.end());
    return reached;
}

std::vector<double> subdomainExtents(const Discretisation& solid) {
    std::vector<double> extents(solid.particles.size(), 0);
    const auto include = [&](int cell, const Vec3& point) {
        const int particle = solid.cells[cell].particle;
        extents[particle] = std::max(extents[particle], (point - solid.particles[particle].position).norm());
    };
    for (size_t cell = 0; cell < solid.cells.size(); ++cell)
        include(static_cast<int>(cell), solid.cells[cell].moments.centroid);
    for (double& extent : extents) extent += solid.cell_size.norm() / 2;  // out to the cells' corners
    for (const IntegrationFace& face : solid.faces)
        for (int cell : face.cells) include(cell, face.centroid);
    for (const SurfacePoint& point : solid.surface_points) include(point.cell, point.position);
    return extents;
}

}  // namespace

SupportGraph::SupportGraph(const Discretisation& solid, double support_radius)
    : solid_(&solid), support_radius_(support_radius), extents_(subdomainExtents(solid)) {
    const int count = static_cast<int>(solid.particles.size());
    std::vector<int> seen(count, -1);
    candidates_.reserve(count);
    for (int owner = 0; owner < count; ++owner)
        candidates_.push_back(connectedFrom(solid, owner, seen, owner, [&](int other) {
            const Vec3 offset = solid.particles[other].position - solid.particles[owner].position;
            return offset.norm() < supportRadius(other) + extents_[owner];
        }));
}

std::vector<int> SupportGraph::widerCandidates(int owner, double factor) const {
    std::vector<int> seen(solid_->particles.size(), -1);
    return connectedFrom(*solid_, owner, seen, 0, [&](int other) {
        const Vec3 offset = solid_->particles[other].position - solid_->particles[owner].position;
        return offset.norm() < factor * supportRadius(other) + extents_[owner];
    });
}

std::vector<std::vector<int>> SupportGraph::balls(double radius) const {
    const std::vector<Particle>& particles = solid_->particles;
    std::vector<int> seen(particles.size(), -1);
    std::vector<std::vector<int>> result;
    result.reserve(particles.size());
    for (int owner = 0; owner < static_cast<int>(particles.size()); ++owner)
        result.push_back(connectedFrom(*solid_, owner, seen, owner, [&](int other) {
            const double distance = (particles[other].position - particles[owner].position).norm();
            return distance < radius * particles[owner].spacing + extents_[other];
        }));
    return result;
}

Components connectedComponents(const Discretisation& solid) {
    Components components;
    components.of_particle.assign(solid.particles.size(), -1);
    std::vector<int> seen(solid.particles.size(), -1);
    for (size_t first = 0; first < solid.particles.size(); ++first) {
        if (components.of_particle[first] >= 0) continue;
        for (int particle :
             connectedFrom(solid, static_cast<int>(first), seen, components.count, [](int) { return true; }))
            components.of_particle[particle] = components.count;
        ++components.count;
    }
    return components;
}

}  // namespace sherd
