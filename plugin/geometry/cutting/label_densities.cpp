#include "geometry/cutting/label_densities.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/cutting/particle_weights.h"

namespace sherd {

namespace {

/// Spreads the kernel of one particle: a part of it to the runner-up, the rest to `label`.
void spreadParticle(const LabelLattice& lattice, const Particle& particle, int label,
                    const RunnerUp& runner_up, double weight, NodeDensities& densities) {
    const double radius = kernelRadius(particle);
    const Vec3 centre = (particle.position - lattice.origin) / lattice.spacing;
    const double jitter = lattice.jitter + 1e-6, own_reach = radius / lattice.spacing,
                 reach = own_reach + jitter;
    const Eigen::Vector3i first = (centre.array() - reach).ceil().cast<int>().max(0);
    const Eigen::Vector3i last = (centre.array() + reach).floor().cast<int>().min(lattice.size.array() - 1);
    for (int k = first.z(); k <= last.z(); ++k)
        for (int j = first.y(); j <= last.y(); ++j) {
            // The part of the row that the kernel may reach.
            const double dz = std::max(0.0, std::abs(k - centre.z()) - jitter),
                         dy = std::max(0.0, std::abs(j - centre.y()) - jitter),
                         squared_room = own_reach * own_reach - dz * dz - dy * dy;
            if (squared_room < 0) continue;
            const double room = std::sqrt(squared_room) + jitter;
            const int begin = std::max(first.x(), static_cast<int>(std::ceil(centre.x() - room))),
                      end = std::min(last.x(), static_cast<int>(std::floor(centre.x() + room)));
            for (int i = begin; i <= end; ++i) {
                const int node = lattice.index(i, j, k);
                if (lattice.labels[node] == -1) continue;
                const double squared = (lattice.nodes[node] - particle.position).squaredNorm();
                if (squared >= radius * radius) continue;
                const double value = kernel(squared / (radius * radius));
                if (!(value > 0)) continue;
                densities.add(node, label, (1 - runner_up.share) * weight * value);
                if (runner_up.share > 0)
                    densities.add(node, runner_up.label, runner_up.share * weight * value);
            }
        }
}

/// While kernels are spread each cluster has a density of its own, under a number below zero: -1 is the
/// first.
int densityOfCluster(int cluster) {
    return -1 - cluster;
}
int clusterOfDensity(int label) {
    return -1 - label;
}

/// Reweights the clusters at each node by their distances from it to their seeds: the nearest gets the sum of
/// all their densities, each other one that sum times (smallest distance / own distance). From then on the
/// densities are those of the clusters' fragments.
void reweightByDistance(const LabelLattice& lattice, const FragmentLabels& labels, NodeDensities& densities) {
    std::vector<int> fragment_of(labels.seeds.size());
    for (std::size_t i = 0; i < labels.cluster.size(); ++i)
        if (labels.cluster[i] >= 0) fragment_of[labels.cluster[i]] = labels.of_particle[i];
    std::vector<NodeDensities::Entry*> clusters;
    std::vector<double> distances;
    for (int node = 0; node < densities.nodeCount(); ++node) {
        clusters.clear();
        distances.clear();
        double sum = 0, nearest = std::numeric_limits<double>::infinity();
        densities.forEach(node, [&](NodeDensities::Entry& density) {
            if (density.label >= 0) return;
            const int cluster = clusterOfDensity(density.label);
            clusters.push_back(&density);
            distances.push_back(labels.distance(labels.seeds[cluster], lattice.nodes[node]));
            nearest = std::min(nearest, distances.back());
            sum += density.value;
            density.label = fragment_of[cluster];
        });
        for (std::size_t i = 0; i < clusters.size(); ++i)
            clusters[i]->value = sum * (distances[i] > 0 ? nearest / distances[i] : 1);
    }
}

}  // namespace

NodeDensities labelDensities(const LabelLattice& lattice, const Discretisation& solid,
                             const FragmentLabels& labels) {
    NodeDensities densities(lattice.nodes.size());
    const std::vector<double> weights = particleWeights(solid, labels);
    for (int i = 0; i < static_cast<int>(solid.particles.size()); ++i) {
        const Particle& particle = solid.particles[i];
        if (labels.distance && labels.cluster[i] >= 0)
            spreadParticle(lattice, particle, densityOfCluster(labels.cluster[i]), {}, weights[i], densities);
        else
            spreadParticle(lattice, particle, labels.of_particle[i], labels.runnerUpOf(i), weights[i],
                           densities);
    }
    if (labels.distance) reweightByDistance(lattice, labels, densities);
    return densities;
}

}  // namespace sherd
