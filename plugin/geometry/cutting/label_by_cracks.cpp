#include "geometry/cutting/label_by_cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/numerics/parallel_chunks.h"

namespace sherd {

namespace {

constexpr int attempts = 8;      // to place a node
constexpr double wanted = 0.15;  // of the lattice spacing: distance of a node from all cracks

/// A part of the body with particles near a node.
struct NearPart {
    int part, label;
    double squared_distance;  // of its nearest particle
};

/// Labels a part of the nodes.
class Labelling {
  public:
    Labelling(const Discretisation& solid, const FragmentLabels& labels, std::uint64_t seed,
              LabelLattice& lattice)
        : solid_(solid), labels_(labels), seed_(seed), lattice_(lattice) {}

    void run(int from, int to) {
        const LatticeLayout& layout = *lattice_.layout;
        for (int n = from; n < to; ++n) {
            const int* const begin = layout.particles.data() + layout.first_particle[n];
            const int* const end = layout.particles.data() + layout.first_particle[n + 1];
            if (begin != end) label(layout.nodes[n], begin, end);
        }
    }

  private:
    void label(int node, const int* begin, const int* end) {
        const int part = labels_.part[*begin];
        if (std::all_of(begin, end, [&](int particle) { return labels_.part[particle] == part; })) {
            lattice_.parts[node] = part;
            lattice_.labels[node] = labels_.of_particle[*begin];
            return;
        }
        double widest = -1;
        Vec3 best_place = lattice_.nodes[node];
        for (int attempt = 0; attempt < attempts && widest < wanted * lattice_.spacing; ++attempt) {
            if (attempt > 0) lattice_.nodes[node] = placeOfNode(lattice_, node, seed_, attempt);
            findNear(lattice_.nodes[node], begin, end);
            const NearPart owner = ownerOf(lattice_.nodes[node]);
            const double free = distanceFromCracks(owner, lattice_.nodes[node]);
            if (free <= widest) continue;
            widest = free;
            best_place = lattice_.nodes[node];
            lattice_.parts[node] = owner.part;
            lattice_.labels[node] = owner.label;
        }
        lattice_.nodes[node] = best_place;
    }

    void findNear(const Vec3& x, const int* begin, const int* end) {
        near_.clear();
        for (const int* particle = begin; particle != end; ++particle) {
            const int part = labels_.part[*particle];
            const double squared = (solid_.particles[*particle].position - x).squaredNorm();
            const auto known =
                std::find_if(near_.begin(), near_.end(), [&](const NearPart& n) { return n.part == part; });
            if (known == near_.end())
                near_.push_back({part, labels_.of_particle[*particle], squared});
            else
                known->squared_distance = std::min(known->squared_distance, squared);
        }
    }

    NearPart ownerOf(const Vec3& x) const {
        NearPart owner = near_.front();
        for (const NearPart& other : near_) {
            if (other.part == owner.part) continue;
            const double lead = labels_.cracks->lead(other.part, owner.part, x);
            if (std::isnan(lead) ? other.squared_distance < owner.squared_distance : lead > 0) owner = other;
        }
        return owner;
    }

    double distanceFromCracks(const NearPart& owner, const Vec3& x) const {
        double least = std::numeric_limits<double>::infinity();
        for (const NearPart& other : near_) {
            if (other.label == owner.label) continue;
            const double lead = labels_.cracks->lead(owner.part, other.part, x);
            if (!std::isnan(lead)) least = std::min(least, std::abs(lead));
        }
        return least;
    }

    const Discretisation& solid_;
    const FragmentLabels& labels_;
    std::uint64_t seed_;
    LabelLattice& lattice_;
    std::vector<NearPart> near_;
};

}  // namespace

void labelByCracks(const Discretisation& solid, const FragmentLabels& labels, std::uint64_t seed,
                   LabelLattice& lattice) {
    const int count = static_cast<int>(lattice.layout->nodes.size());
    constexpr int chunks = 8;
    forEachChunk(chunks, [&](int chunk) {
        Labelling(solid, labels, seed, lattice)
            .run(chunkBegin(chunk, chunks, count), chunkBegin(chunk + 1, chunks, count));
    });
}

}  // namespace sherd
