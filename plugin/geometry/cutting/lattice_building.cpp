#include "geometry/cutting/lattice_building.h"

#include <utility>

#include "geometry/cutting/label_by_cracks.h"
#include "geometry/cutting/label_densities.h"

namespace sherd {

namespace {

constexpr int without_label = -1;  // nodes of no active cell
constexpr int label_wanted = -2;

// Those that are to get a label.
void placeNodes(LabelLattice& lattice, std::uint64_t seed) {
    for (const int node : lattice.layout->nodes) lattice.nodes[node] = placeOfNode(lattice, node, seed);
}

// Which labels have cracks that are placed better than by smoothing.
std::vector<char> findSharpLabels(const FragmentLabels& labels) {
    std::vector<char> sharp(labels.count, 0);
    for (std::size_t i = 0; i < labels.runner_up.size(); ++i)
        if (labels.runner_up[i].label >= 0)
            sharp[labels.of_particle[i]] = sharp[labels.runner_up[i].label] = 1;
    for (std::size_t i = 0; i < labels.cluster.size(); ++i)
        if (labels.cluster[i] >= 0) sharp[labels.of_particle[i]] = 1;
    return sharp;
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
// island of nodes without any takes that of the nearest particle.
void labelUnreached(LabelLattice& lattice, const Discretisation& solid, const FragmentLabels& labels) {
    const int steps[3] = {1, lattice.size.x(), lattice.size.x() * lattice.size.y()};
    const int count = static_cast<int>(lattice.nodes.size());
    std::vector<int> front;
    bool all_reached = true;
    for (const int node : lattice.layout->nodes)
        if (lattice.labels[node] >= 0)
            front.push_back(node);
        else
            all_reached = false;
    if (all_reached) return;
    const auto flood = [&] {
        for (std::size_t head = 0; head < front.size(); ++head)
            for (int step : steps)
                for (int next : {front[head] - step, front[head] + step})
                    if (next >= 0 && next < count && lattice.labels[next] == label_wanted) {
                        lattice.labels[next] = lattice.labels[front[head]];
                        if (lattice.cracks) lattice.parts[next] = lattice.parts[front[head]];
                        front.push_back(next);
                    }
    };
    flood();
    for (const int node : lattice.layout->nodes) {
        if (lattice.labels[node] != label_wanted) continue;
        const int particle = nearestParticle(solid, lattice.nodes[node]);
        lattice.labels[node] = labels.of_particle[particle];
        if (lattice.cracks) lattice.parts[node] = labels.part[particle];
        front = {node};
        flood();
    }
}

}  // namespace

LabelLattice buildLabelLattice(std::shared_ptr<const LatticeLayout> layout, const Discretisation& solid,
                               const ParticleReach& reach, const FragmentLabels& labels, std::uint64_t seed) {
    LabelLattice lattice;
    static_cast<LatticeGrid&>(lattice) = layout->grid;
    lattice.layout = std::move(layout);
    lattice.nodes.resize(lattice.nodeCount(), Vec3::Zero());
    lattice.labels.resize(lattice.nodes.size(), without_label);
    for (const int node : lattice.layout->nodes) lattice.labels[node] = label_wanted;
    placeNodes(lattice, seed);
    if (labels.cracks) {
        constexpr double place_beside_crack = 0.06;
        lattice.smallest_edge_place = place_beside_crack;
        lattice.cracks = labels.cracks;
        lattice.parts.resize(lattice.nodes.size(), -1);
        labelByCracks(solid, labels, seed, lattice);
    } else {
        labelByDensities(solid, reach, labels, lattice);
        lattice.sharp = findSharpLabels(labels);
    }
    labelUnreached(lattice, solid, labels);
    return lattice;
}

}  // namespace sherd
