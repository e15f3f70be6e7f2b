#include "geometry/cutting/label_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/hashed_random.h"
#include "geometry/cutting/active_cells.h"
#include "geometry/cutting/particle_weights.h"

namespace sherd {

namespace {

constexpr int margin_cells = 3;  // of air around the solid's box
constexpr double spacing_share =
    0.65;  // of the particle spacing: fine enough for round edges, no finer than what is known

std::pair<Vec3, Vec3> boundingBox(const TriangleMesh& surface) {
    Vec3 low = surface.vertices.front(), high = low;
    for (const Vec3& v : surface.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    return {low, high};
}

LabelLattice placeNodes(const TriangleMesh& surface, const LatticeSettings& settings) {
    const auto [low, high] = boundingBox(surface);
    LabelLattice lattice;
    lattice.spacing = settings.spacing;
    lattice.origin = low - Vec3::Constant(margin_cells * settings.spacing);
    lattice.size = ((high - low) / settings.spacing).array().ceil().cast<int>() + 2 * margin_cells + 1;
    lattice.nodes.reserve(static_cast<std::size_t>(lattice.size.cast<double>().prod()));
    for (int k = 0; k < lattice.size.z(); ++k)
        for (int j = 0; j < lattice.size.y(); ++j)
            for (int i = 0; i < lattice.size.x(); ++i) {
                const std::uint64_t node = lattice.nodes.size();
                const Vec3 jitter(hashedRandom(settings.seed, node, 0), hashedRandom(settings.seed, node, 1),
                                  hashedRandom(settings.seed, node, 2));
                lattice.nodes.push_back(lattice.origin +
                                        settings.spacing * (Vec3(i, j, k) + settings.jitter * jitter));
            }
    return lattice;
}

// Nodes of active cells get label -2 (to be found), all others -1.
void markNodes(LabelLattice& lattice) {
    lattice.labels.assign(lattice.nodes.size(), -1);
    for (int k = 0; k + 1 < lattice.size.z(); ++k)
        for (int j = 0; j + 1 < lattice.size.y(); ++j)
            for (int i = 0; i + 1 < lattice.size.x(); ++i) {
                if (!lattice.active_cells[lattice.index(i, j, k)]) continue;
                for (int corner = 0; corner < 8; ++corner)
                    lattice.labels[lattice.index(i + corner % 2, j + corner / 2 % 2, k + corner / 4)] = -2;
            }
}

void addDensity(LabelLattice& lattice, int node, int label, double value) {
    for (int d = lattice.first_density[node]; d >= 0; d = lattice.densities[d].next)
        if (lattice.densities[d].label == label) {
            lattice.densities[d].value += value;
            return;
        }
    lattice.densities.push_back({label, value, lattice.first_density[node]});
    lattice.first_density[node] = static_cast<int>(lattice.densities.size()) - 1;
}

void spreadParticle(LabelLattice& lattice, const Particle& particle, int label, const SharedLabel& shared,
                    double weight) {
    const double radius = kernelRadius(particle);
    const Vec3 centre = (particle.position - lattice.origin) / lattice.spacing;
    const double reach = radius / lattice.spacing + 0.5;  // nodes are jittered
    const Eigen::Vector3i first = (centre.array() - reach).ceil().cast<int>().max(0);
    const Eigen::Vector3i last = (centre.array() + reach).floor().cast<int>().min(lattice.size.array() - 1);
    for (int k = first.z(); k <= last.z(); ++k)
        for (int j = first.y(); j <= last.y(); ++j)
            for (int i = first.x(); i <= last.x(); ++i) {
                const int node = lattice.index(i, j, k);
                if (lattice.labels[node] == -1) continue;
                const double value =
                    kernel((lattice.nodes[node] - particle.position).squaredNorm() / (radius * radius));
                if (!(value > 0)) continue;
                addDensity(lattice, node, label, (1 - shared.share) * weight * value);
                if (shared.share > 0) addDensity(lattice, node, shared.second, shared.share * weight * value);
            }
}

// Clusters have a density each until here, under numbers below zero: -1 for the first.
int densityOfCluster(int cluster) {
    return -1 - cluster;
}

void spreadParticles(LabelLattice& lattice, const Discretisation& solid, const FragmentLabels& labels) {
    const std::vector<double> weights = particleWeights(solid, labels);
    for (int i = 0; i < static_cast<int>(solid.particles.size()); ++i) {
        const Particle& particle = solid.particles[i];
        if (labels.distance && labels.cluster[i] >= 0)
            spreadParticle(lattice, particle, densityOfCluster(labels.cluster[i]), {}, weights[i]);
        else
            spreadParticle(lattice, particle, labels.of_particle[i], labels.sharedAt(i), weights[i]);
    }
}

// What clusters there are at a node, as their kernels say, is shared out anew by the distances from their
// seeds: the nearest gets all of it, the others less by as much as they are farther. Then it belongs to their
// fragments.
void shareByDistance(LabelLattice& lattice, const FragmentLabels& labels) {
    std::vector<int> fragment_of(labels.seeds.size());
    for (std::size_t i = 0; i < labels.cluster.size(); ++i)
        if (labels.cluster[i] >= 0) fragment_of[labels.cluster[i]] = labels.of_particle[i];
    std::vector<LabelLattice::Density*> clusters;
    std::vector<double> distances;
    for (std::size_t node = 0; node < lattice.nodes.size(); ++node) {
        clusters.clear();
        distances.clear();
        double sum = 0, nearest = std::numeric_limits<double>::infinity();
        for (int d = lattice.first_density[node]; d >= 0; d = lattice.densities[d].next) {
            LabelLattice::Density& density = lattice.densities[d];
            if (density.label >= 0) continue;
            const int cluster = densityOfCluster(density.label);
            clusters.push_back(&density);
            distances.push_back(labels.distance(labels.seeds[cluster], lattice.nodes[node]));
            nearest = std::min(nearest, distances.back());
            sum += density.value;
            density.label = fragment_of[cluster];
        }
        for (std::size_t i = 0; i < clusters.size(); ++i)
            clusters[i]->value = sum * (distances[i] > 0 ? nearest / distances[i] : 1);
    }
}

void chooseLabels(LabelLattice& lattice) {
    for (std::size_t node = 0; node < lattice.nodes.size(); ++node) {
        double best = 0;
        for (int d = lattice.first_density[node]; d >= 0; d = lattice.densities[d].next) {
            const auto& density = lattice.densities[d];
            if (density.value < best || (density.value == best && density.label > lattice.labels[node]))
                continue;
            best = density.value;
            lattice.labels[node] = density.label;
        }
    }
}

int nearestParticle(const Discretisation& solid, const Vec3& x) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(solid.particles.size()); ++i)
        if ((solid.particles[i].position - x).squaredNorm() <
            (solid.particles[best].position - x).squaredNorm())
            best = i;
    return best;
}

// Nodes that no kernel reaches take the label of the nearest node that has one, counted in lattice steps; an
// island without any takes that of the nearest particle.
void fillTheRest(LabelLattice& lattice, const Discretisation& solid, const FragmentLabels& labels) {
    const int steps[3] = {1, lattice.size.x(), lattice.size.x() * lattice.size.y()};
    const int count = static_cast<int>(lattice.nodes.size());
    std::vector<int> front;
    for (int node = 0; node < count; ++node)
        if (lattice.labels[node] >= 0) front.push_back(node);
    const auto flood = [&] {
        for (std::size_t head = 0; head < front.size(); ++head)
            for (int step : steps)
                for (int next : {front[head] - step, front[head] + step})
                    if (next >= 0 && next < count && lattice.labels[next] == -2) {
                        lattice.labels[next] = lattice.labels[front[head]];
                        front.push_back(next);
                    }
    };
    flood();
    for (int node = 0; node < count; ++node) {
        if (lattice.labels[node] != -2) continue;
        lattice.labels[node] = labels.of_particle[nearestParticle(solid, lattice.nodes[node])];
        front = {node};
        flood();
    }
}

}  // namespace

double LabelLattice::density(int node, int label) const {
    double most = 0;
    for (int d = first_density[node]; d >= 0; d = densities[d].next)
        if (densities[d].label == label) most = std::max(most, densities[d].value);
    return most;
}

LabelLattice buildLabelLattice(const TriangleMesh& surface, const Discretisation& solid,
                               const FragmentLabels& labels, const LatticeSettings& settings) {
    LabelLattice lattice = placeNodes(surface, settings);
    lattice.active_cells = findActiveCells(surface, lattice);
    markNodes(lattice);
    lattice.first_density.assign(lattice.nodes.size(), -1);
    spreadParticles(lattice, solid, labels);
    lattice.sharp.assign(labels.count, 0);
    for (std::size_t i = 0; i < labels.shared.size(); ++i)
        if (labels.shared[i].second >= 0)
            lattice.sharp[labels.of_particle[i]] = lattice.sharp[labels.shared[i].second] = 1;
    for (std::size_t i = 0; i < labels.cluster.size(); ++i)
        if (labels.cluster[i] >= 0) lattice.sharp[labels.of_particle[i]] = 1;
    if (labels.distance) shareByDistance(lattice, labels);
    chooseLabels(lattice);
    fillTheRest(lattice, solid, labels);
    return lattice;
}

double latticeSpacing(const TriangleMesh& surface, const Discretisation& solid, const FragmentLabels& labels,
                      double largest_node_count, double largest) {
    std::vector<double> at_borders;
    for (std::size_t i = 0; i < solid.neighbours.size(); ++i)
        for (int j : solid.neighbours[i])
            if (labels.of_particle[j] != labels.of_particle[i]) {
                at_borders.push_back(solid.particles[i].spacing);
                break;
            }
    double spacing = solid.spacing;
    if (!at_borders.empty()) {
        const auto fine = at_borders.begin() + static_cast<long>(at_borders.size() / 5);
        std::nth_element(at_borders.begin(), fine, at_borders.end());
        spacing = *fine;
    }
    spacing *= spacing_share;
    if (largest > 0) spacing = std::min(spacing, largest);
    const auto [low, high] = boundingBox(surface);
    const Vec3 box = (high - low).array() + 2 * margin_cells * spacing;
    return std::max(spacing, std::cbrt(box.prod() / largest_node_count));
}

}  // namespace sherd
