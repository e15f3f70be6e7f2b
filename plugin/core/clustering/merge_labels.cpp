#include "core/clustering/merge_labels.h"

#include <map>

#include "core/numerics/union_find.h"

namespace sherd {

namespace {

struct Piece {
    double volume = 0;           // m^3
    std::map<int, double> area;  // m^2, shared with each neighbour; empty once it is part of another piece
};

std::vector<Piece> measure(const Discretisation& solid, const FragmentLabels& labels) {
    std::vector<Piece> pieces(labels.count);
    for (std::size_t i = 0; i < solid.particles.size(); ++i)
        pieces[labels.of_particle[i]].volume += solid.particles[i].volume;
    for (const IntegrationFace& face : solid.faces) {
        const int a = labels.of_particle[solid.cells[face.cells[0]].particle];
        const int b = labels.of_particle[solid.cells[face.cells[1]].particle];
        if (a == b) continue;
        pieces[a].area[b] += face.area.norm();
        pieces[b].area[a] += face.area.norm();
    }
    return pieces;
}

int smallestWithNeighbours(const std::vector<Piece>& pieces) {
    int smallest = -1;
    for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
        if (pieces[p].area.empty()) continue;
        if (smallest < 0 || pieces[p].volume < pieces[smallest].volume) smallest = p;
    }
    return smallest;
}

/// Merges a piece into the neighbour that it shares most area with, and returns that one.
int mergeIntoNeighbour(std::vector<Piece>& pieces, int small) {
    int target = -1;
    for (const auto& [other, area] : pieces[small].area)
        if (target < 0 || area > pieces[small].area[target]) target = other;
    pieces[target].volume += pieces[small].volume;
    pieces[target].area.erase(small);
    for (const auto& [other, area] : pieces[small].area) {
        if (other == target) continue;
        pieces[target].area[other] += area;
        pieces[other].area[target] += area;
        pieces[other].area.erase(small);
    }
    pieces[small].area.clear();
    return target;
}

}  // namespace

void mergeSmallest(const Discretisation& solid, double smallest_m3, int largest_count,
                   FragmentLabels& labels) {
    std::vector<Piece> pieces = measure(solid, labels);
    UnionFind merged(pieces.size());
    for (int left = labels.count;; --left) {
        const int small = smallestWithNeighbours(pieces);
        if (small < 0 || (pieces[small].volume >= smallest_m3 && left <= largest_count)) break;
        merged.uniteInto(mergeIntoNeighbour(pieces, small), small);
    }
    std::vector<int> number(pieces.size(), -1);
    labels.count = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p)
        if (merged.isRoot(static_cast<int>(p))) number[p] = labels.count++;
    const auto renumbered = [&](int label) { return number[merged.root(label)]; };
    for (int& label : labels.of_particle) label = renumbered(label);
    for (std::size_t i = 0; i < labels.runner_up.size(); ++i) {
        RunnerUp& runner_up = labels.runner_up[i];
        if (runner_up.label >= 0) runner_up.label = renumbered(runner_up.label);
        if (runner_up.label == labels.of_particle[i]) runner_up = {};
    }
}

}  // namespace sherd
