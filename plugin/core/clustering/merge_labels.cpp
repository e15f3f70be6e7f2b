#include "core/clustering/merge_labels.h"

#include <map>

namespace sherd {

namespace {

struct Piece {
    double volume = 0;           // m^3
    std::map<int, double> area;  // m^2, shared with each neighbour
    int into = -1;               // the piece that it became part of
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
        if (pieces[p].into >= 0 || pieces[p].area.empty()) continue;
        if (smallest < 0 || pieces[p].volume < pieces[smallest].volume) smallest = p;
    }
    return smallest;
}

void mergeIntoNeighbour(std::vector<Piece>& pieces, int small) {
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
    pieces[small].into = target;
    pieces[small].area.clear();
}

}  // namespace

void mergeSmallest(const Discretisation& solid, double smallest_m3, int largest_count,
                   FragmentLabels& labels) {
    std::vector<Piece> pieces = measure(solid, labels);
    for (int left = labels.count;; --left) {
        const int small = smallestWithNeighbours(pieces);
        if (small < 0 || (pieces[small].volume >= smallest_m3 && left <= largest_count)) break;
        mergeIntoNeighbour(pieces, small);
    }
    std::vector<int> number(pieces.size(), -1);
    labels.count = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p)
        if (pieces[p].into < 0) number[p] = labels.count++;
    const auto renumbered = [&](int label) {
        while (pieces[label].into >= 0) label = pieces[label].into;
        return number[label];
    };
    for (int& label : labels.of_particle) label = renumbered(label);
    for (std::size_t i = 0; i < labels.shared.size(); ++i) {
        SharedLabel& shared = labels.shared[i];
        if (shared.second >= 0) shared.second = renumbered(shared.second);
        if (shared.second == labels.of_particle[i]) shared = {};
    }
}

}  // namespace sherd
