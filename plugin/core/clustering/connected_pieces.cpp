#include "core/clustering/connected_pieces.h"

#include <algorithm>
#include <utility>

namespace sherd {

namespace {

void joinSpecks(std::vector<std::vector<int>>& pieces) {
    constexpr std::size_t largest_speck = 5;
    while (pieces.size() > 1 && pieces.back().size() <= largest_speck) {
        pieces[0].insert(pieces[0].end(), pieces.back().begin(), pieces.back().end());
        pieces.pop_back();
    }
    std::sort(pieces[0].begin(), pieces[0].end());
}

}  // namespace

std::vector<std::vector<int>> ConnectedPieces::of(const std::vector<int>& members) {
    for (const int i : members) is_waiting_[i] = 1;
    std::vector<std::vector<int>> pieces;
    for (const int first : members)
        if (is_waiting_[first]) pieces.push_back(takePiece(first));
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    joinSpecks(pieces);
    return pieces;
}

std::vector<int> ConnectedPieces::takePiece(int first) {
    std::vector<int> piece = {first};
    is_waiting_[first] = 0;
    for (std::size_t head = 0; head < piece.size(); ++head)
        for (const int j : solid_.neighbours[piece[head]]) {
            if (!is_waiting_[j]) continue;
            is_waiting_[j] = 0;
            piece.push_back(j);
        }
    std::sort(piece.begin(), piece.end());
    return piece;
}

}  // namespace sherd
