#include "geometry/cutting/lattice_building.h"

#include <algorithm>

#include "core/numerics/hashed_random.h"
#include "core/numerics/mesh_measures.h"
#include "geometry/cutting/active_cells.h"
#include "geometry/cutting/label_densities.h"

namespace sherd {

namespace {

constexpr int without_label = -1;  // nodes of no active cell
constexpr int label_wanted = -2;

LabelLattice layLattice(const TriangleMesh& surface, const LatticeSettings& settings) {
    const Eigen::AlignedBox3d box = boundingBox(surface.vertices);
    LabelLattice lattice;
    lattice.spacing = settings.spacing;
    lattice.jitter = settings.jitter;
    lattice.origin = box.min() - Vec3::Constant(lattice_margin * settings.spacing);
    lattice.size =
        ((box.max() - box.min()) / settings.spacing).array().ceil().cast<int>() + 2 * lattice_margin + 1;
    lattice.nodes.resize(static_cast<std::size_t>(lattice.size.cast<double>().prod()), Vec3::Zero());
    return lattice;
}

// Those that are to get a label.
void placeNodes(LabelLattice& lattice, std::uint64_t seed) {
    std::uint64_t node = 0;
    for (int k = 0; k < lattice.size.z(); ++k)
        for (int j = 0; j < lattice.size.y(); ++j)
            for (int i = 0; i < lattice.size.x(); ++i, ++node) {
                if (lattice.labels[node] != label_wanted) continue;
                const Vec3 jitter(hashedRandom(seed, node, 0), hashedRandom(seed, node, 1),
                                  hashedRandom(seed, node, 2));
                lattice.nodes[node] =
                    lattice.origin + lattice.spacing * (Vec3(i, j, k) + lattice.jitter * jitter);
            }
}

// Which nodes are to get a label: those of active cells.
std::vector<int> markNodes(const LabelLattice& lattice) {
    std::vector<int> labels(lattice.nodes.size(), without_label);
    lattice.forEachCell([&](int i, int j, int k) {
        if (!lattice.active_cells[lattice.index(i, j, k)]) return;
        for (int corner = 0; corner < 8; ++corner) labels[lattice.cornerOf(i, j, k, corner)] = label_wanted;
    });
    return labels;
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

// The densest label of each node that a kernel reaches; the lower of two that are equally dense.
void chooseLabels(LabelLattice& lattice) {
    for (int node = 0; node < lattice.densities.nodeCount(); ++node) {
        double best = 0;
        lattice.densities.forEach(node, [&](const NodeDensities::Entry& density) {
            if (density.value < best || (density.value == best && density.label > lattice.labels[node]))
                return;
            best = density.value;
            lattice.labels[node] = density.label;
        });
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
// island of nodes without any takes that of the nearest particle.
void labelUnreached(LabelLattice& lattice, const Discretisation& solid, const FragmentLabels& labels) {
    const int steps[3] = {1, lattice.size.x(), lattice.size.x() * lattice.size.y()};
    const int count = static_cast<int>(lattice.nodes.size());
    std::vector<int> front;
    for (int node = 0; node < count; ++node)
        if (lattice.labels[node] >= 0) front.push_back(node);
    const auto flood = [&] {
        for (std::size_t head = 0; head < front.size(); ++head)
            for (int step : steps)
                for (int next : {front[head] - step, front[head] + step})
                    if (next >= 0 && next < count && lattice.labels[next] == label_wanted) {
                        lattice.labels[next] = lattice.labels[front[head]];
                        front.push_back(next);
                    }
    };
    flood();
    for (int node = 0; node < count; ++node) {
        if (lattice.labels[node] != label_wanted) continue;
        lattice.labels[node] = labels.of_particle[nearestParticle(solid, lattice.nodes[node])];
        front = {node};
        flood();
    }
}

}  // namespace

LabelLattice buildLabelLattice(const TriangleMesh& surface, const Discretisation& solid,
                               const FragmentLabels& labels, const LatticeSettings& settings) {
    LabelLattice lattice = layLattice(surface, settings);
    lattice.active_cells = findActiveCells(surface, lattice);
    lattice.labels = markNodes(lattice);
    placeNodes(lattice, settings.seed);
    lattice.densities = labelDensities(lattice, solid, labels);
    lattice.sharp = findSharpLabels(labels);
    chooseLabels(lattice);
    labelUnreached(lattice, solid, labels);
    return lattice;
}

}  // namespace sherd
