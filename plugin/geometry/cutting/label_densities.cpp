#include "geometry/cutting/label_densities.h"

#include <algorithm>
#include <limits>

#include "core/numerics/parallel_chunks.h"
#include "geometry/cutting/particle_weights.h"

namespace sherd {

namespace {

/// What a particle adds to the nodes around it, in the order in which it is used.
struct Source {
    Vec3 position;
    double squared_radius;
    double share;  // of its material that counts as the runner-up's
    double weight;
    int label, runner_up;  // clusters have numbers below zero while kernels are summed
};

int densityOfCluster(int cluster) {
    return -1 - cluster;
}
int clusterOfDensity(int label) {
    return -1 - label;
}

std::vector<Source> sourcesOf(const Discretisation& solid, const ParticleReach& reach,
                              const FragmentLabels& labels) {
    const std::vector<double> weights = particleWeights(solid, reach, labels);
    std::vector<Source> sources;
    sources.reserve(weights.size());
    for (int i = 0; i < static_cast<int>(weights.size()); ++i) {
        const Particle& particle = solid.particles[i];
        const double radius = kernelRadius(particle);
        Source source = {particle.position, radius * radius, 0, weights[i], labels.of_particle[i], -1};
        if (labels.distance && labels.cluster[i] >= 0) {
            source.label = densityOfCluster(labels.cluster[i]);
        } else if (const RunnerUp runner_up = labels.runnerUpOf(i); runner_up.share > 0) {
            source.share = runner_up.share;
            source.runner_up = runner_up.label;
        }
        sources.push_back(source);
    }
    return sources;
}

constexpr int no_sole_label = std::numeric_limits<int>::min();

/// The labels of sources that add to one alone: a short list, since all nodes look at it.
std::vector<int> soleLabelsOf(const std::vector<Source>& sources) {
    std::vector<int> labels;
    labels.reserve(sources.size());
    for (const Source& source : sources) labels.push_back(source.share > 0 ? no_sole_label : source.label);
    return labels;
}

/// Which fragment each cluster belongs to.
std::vector<int> fragmentsOfClusters(const FragmentLabels& labels) {
    std::vector<int> fragment_of(labels.seeds.size());
    for (std::size_t i = 0; i < labels.cluster.size(); ++i)
        if (labels.cluster[i] >= 0) fragment_of[labels.cluster[i]] = labels.of_particle[i];
    return fragment_of;
}

/// Labels a part of the nodes.
class Labelling {
  public:
    Labelling(const std::vector<Source>& sources, const std::vector<int>& sole_labels,
              const std::vector<int>& fragment_of, const FragmentLabels& labels, LabelLattice& lattice)
        : sources_(sources),
          sole_labels_(sole_labels),
          fragment_of_(fragment_of),
          labels_(labels),
          lattice_(lattice) {}

    NodeDensities::Part run(int from, int to) {
        const LatticeLayout& layout = *lattice_.layout;
        for (int n = from; n < to; ++n) {
            const int* const begin = layout.particles.data() + layout.first_particle[n];
            const int* const end = layout.particles.data() + layout.first_particle[n + 1];
            if (begin != end) label(layout.nodes[n], begin, end);
        }
        return std::move(densities_);
    }

  private:
    void label(int node, const int* begin, const int* end) {
        entries_.clear();
        if (haveOneLabel(begin, end))
            findAny(node, begin, end);
        else
            sumUp(node, begin, end);
        if (entries_.empty()) return;
        if (labels_.distance) reweightByDistance(lattice_.nodes[node]);
        double best = 0;
        for (const Entry& density : entries_) {
            if (density.value < best || (density.value == best && density.label > lattice_.labels[node]))
                continue;
            best = density.value;
            lattice_.labels[node] = density.label;
        }
        densities_.add(node, entries_);
    }

    bool haveOneLabel(const int* begin, const int* end) const {
        const int label = sole_labels_[*begin];
        return label != no_sole_label &&
               std::all_of(begin, end, [&](int particle) { return sole_labels_[particle] == label; });
    }

    /// The kernel of a particle at a node; 0 beyond it.
    double kernelAt(int node, const Source& source) const {
        const double squared = (lattice_.nodes[node] - source.position).squaredNorm();
        return squared >= source.squared_radius ? 0 : kernel(squared / source.squared_radius);
    }

    void findAny(int node, const int* begin, const int* end) {
        if (std::any_of(begin, end, [&](int p) { return kernelAt(node, sources_[p]) > 0; }))
            entries_.push_back({sources_[*begin].label, 1});
    }

    void sumUp(int node, const int* begin, const int* end) {
        for (const int* particle = begin; particle != end; ++particle) {
            const Source& source = sources_[*particle];
            const double value = kernelAt(node, source);
            if (!(value > 0)) continue;
            add(source.label, (1 - source.share) * source.weight * value);
            if (source.share > 0) add(source.runner_up, source.share * source.weight * value);
        }
    }

    void add(int label, double value) {
        for (Entry& known : entries_)
            if (known.label == label) {
                known.value += value;
                return;
            }
        entries_.push_back({label, value});
    }

    /// Reweights the clusters at a node by their distances from it to their seeds: the nearest gets the sum
    /// of all their densities, each other one that sum times (smallest distance / own distance). From then on
    /// the densities are those of the clusters' fragments.
    void reweightByDistance(const Vec3& x) {
        distances_.assign(entries_.size(), 0);
        double sum = 0, nearest = std::numeric_limits<double>::infinity();
        for (std::size_t e = entries_.size(); e-- > 0;) {
            if (entries_[e].label >= 0) continue;
            distances_[e] = labels_.distance(labels_.seeds[clusterOfDensity(entries_[e].label)], x);
            nearest = std::min(nearest, distances_[e]);
            sum += entries_[e].value;
        }
        for (std::size_t e = 0; e < entries_.size(); ++e) {
            if (entries_[e].label >= 0) continue;
            entries_[e].label = fragment_of_[clusterOfDensity(entries_[e].label)];
            entries_[e].value = sum * (distances_[e] > 0 ? nearest / distances_[e] : 1);
        }
    }

    using Entry = NodeDensities::Entry;
    const std::vector<Source>& sources_;
    const std::vector<int>& sole_labels_;
    const std::vector<int>& fragment_of_;  // clusters
    const FragmentLabels& labels_;
    LabelLattice& lattice_;
    NodeDensities::Part densities_;
    std::vector<Entry> entries_;  // at one node
    std::vector<double> distances_;
};

}  // namespace

void labelByDensities(const Discretisation& solid, const ParticleReach& reach, const FragmentLabels& labels,
                      LabelLattice& lattice) {
    const std::vector<Source> sources = sourcesOf(solid, reach, labels);
    const std::vector<int> sole_labels = soleLabelsOf(sources), fragment_of = fragmentsOfClusters(labels);
    const int count = static_cast<int>(lattice.layout->nodes.size());
    const int chunks = labels.distance ? 1 : 8;  // a guide field may be a function of the user's
    std::vector<NodeDensities::Part> parts(chunks);
    forEachChunk(chunks, [&](int chunk) {
        parts[chunk] = Labelling(sources, sole_labels, fragment_of, labels, lattice)
                           .run(chunkBegin(chunk, chunks, count), chunkBegin(chunk + 1, chunks, count));
    });
    lattice.densities = NodeDensities(lattice.nodes.size());
    for (const NodeDensities::Part& part : parts) lattice.densities.append(part);
}

}  // namespace sherd
