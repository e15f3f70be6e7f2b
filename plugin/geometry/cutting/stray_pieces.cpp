#include "geometry/cutting/stray_pieces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/numerics/union_find.h"

namespace sherd {

namespace {

constexpr double smallest_piece = 0.05;  // of a particle's mean volume

std::vector<char> findStrays(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                             const Discretisation& solid, const FragmentLabels& labels,
                             std::vector<PieceShell>& shells) {
    const double mean_volume = meanParticleVolume(solid);
    std::map<int, std::vector<int>> of_label;
    for (int s = 0; s < static_cast<int>(shells.size()); ++s) of_label[shells[s].label].push_back(s);
    if (of_label.size() < shells.size()) findBoxes(boundary, points, shells);
    std::vector<char> is_stray(shells.size(), false);
    for (const auto& [label, members] : of_label) {
        const int largest = *std::max_element(members.begin(), members.end(), [&](int a, int b) {
            return shells[a].volume < shells[b].volume;
        });
        for (int s : members) {
            is_stray[s] = shells[s].volume < smallest_piece * mean_volume;
            if (is_stray[s] || s == largest) continue;
            bool holds_particle = false;
            for (std::size_t i = 0; i < solid.particles.size() && !holds_particle; ++i)
                holds_particle = labels.of_particle[i] == label &&
                                 contains(shells[s], solid.particles[i].position, boundary, points);
            is_stray[s] = !holds_particle;
        }
    }
    return is_stray;
}

// Makes strays of pieces beyond the limits.
void addSmallest(const std::vector<PieceShell>& shells, const PieceLimits& limits,
                 std::vector<char>& is_stray) {
    std::vector<std::pair<double, int>> kept;  // volume and number
    for (std::size_t s = 0; s < shells.size(); ++s)
        if (!is_stray[s]) kept.push_back({shells[s].volume, static_cast<int>(s)});
    std::sort(kept.begin(), kept.end());
    const int excess = static_cast<int>(kept.size()) - std::max(2, limits.most);
    for (int i = 0; i + 2 < static_cast<int>(kept.size()); ++i)
        if (i < excess || kept[i].first < limits.smallest_m3) is_stray[kept[i].second] = true;
}

// The crack area that each piece shares with each neighbour, m^2.
std::vector<std::map<int, double>> contactAreas(const std::vector<PieceShell>& shells,
                                                const LabelBoundary& boundary,
                                                const std::vector<Vec3>& points) {
    const std::vector<int> piece_of = pieceOfTriangle(shells, boundary);
    std::vector<std::map<int, double>> areas(shells.size());
    for (int t = boundary.body_count; t < static_cast<int>(boundary.triangles.size()); ++t) {
        const auto& [a, b, c] = boundary.triangles[t];
        areas[piece_of[t]][piece_of[boundary.opposite(t)]] +=
            (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
    }
    return areas;
}

// Which shell each one becomes part of: itself, or for a stray what became of the neighbour with which it
// shares most crack area, decided in ascending order of volume.
std::vector<int> chooseTargets(const std::vector<PieceShell>& shells, const LabelBoundary& boundary,
                               const std::vector<Vec3>& points, const std::vector<char>& is_stray) {
    auto areas = contactAreas(shells, boundary, points);
    std::vector<int> order;
    for (int s = 0; s < static_cast<int>(shells.size()); ++s)
        if (is_stray[s]) order.push_back(s);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return std::make_pair(shells[a].volume, a) < std::make_pair(shells[b].volume, b);
    });
    UnionFind merged(shells.size());
    for (int s : order) {
        std::map<int, double> shared;  // with what became of the neighbours
        for (const auto& [other, area] : areas[s])
            if (merged.root(other) != s) shared[merged.root(other)] += area;
        int best = -1;
        double most = 0;
        for (const auto& [other, area] : shared)
            if (area > most) best = other, most = area;
        if (best < 0) continue;
        merged.uniteInto(best, s);
        for (const auto& [other, area] : areas[s]) areas[best][other] += area;
    }
    return merged.roots();
}

}  // namespace

void mergeShells(const std::vector<int>& target_of, const LabelBoundary& boundary,
                 std::vector<PieceShell>& shells) {
    std::vector<int> piece_of = pieceOfTriangle(shells, boundary);
    for (int& piece : piece_of)
        if (piece >= 0) piece = target_of[piece];  // a crack that vanished before is in none
    std::vector<char> has_grown(shells.size(), false);
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (target_of[s] == static_cast<int>(s)) continue;
        has_grown[target_of[s]] = true;
        PieceShell& target = shells[target_of[s]];
        const auto own_count = static_cast<std::ptrdiff_t>(target.triangles.size());
        target.triangles.insert(target.triangles.end(), shells[s].triangles.begin(),
                                shells[s].triangles.end());
        std::inplace_merge(target.triangles.begin(), target.triangles.begin() + own_count,
                           target.triangles.end());
        target.volume += shells[s].volume;
        target.merged_labels.push_back(shells[s].label);
        shells[s].triangles.clear();
    }
    for (std::size_t s = 0; s < shells.size(); ++s) {
        PieceShell& shell = shells[s];
        if (!has_grown[s]) continue;
        const auto vanished = [&](int t) {
            return t >= boundary.body_count && piece_of[t] == piece_of[boundary.opposite(t)];
        };
        shell.triangles.erase(std::remove_if(shell.triangles.begin(), shell.triangles.end(), vanished),
                              shell.triangles.end());
    }
    removeEmptyShells(shells);
}

void mergeStrayPieces(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                      const Discretisation& solid, const FragmentLabels& labels, const PieceLimits& limits,
                      std::vector<PieceShell>& shells) {
    std::vector<char> is_stray = findStrays(boundary, points, solid, labels, shells);
    addSmallest(shells, limits, is_stray);
    if (std::find(is_stray.begin(), is_stray.end(), true) == is_stray.end()) return;
    mergeShells(chooseTargets(shells, boundary, points, is_stray), boundary, shells);
}

}  // namespace sherd
