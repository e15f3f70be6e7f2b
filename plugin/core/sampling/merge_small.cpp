#include "core/sampling/merge_small.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sherd {
namespace {

constexpr double rounding = 1e-12;  // of a whole cell: no volume at all
constexpr double tie = 1e-9;        // differences below are rounding, and the order of the pieces decides

/// The pieces as they are merged.
class Merging {
  public:
    Merging(std::vector<double> volumes, const std::vector<SharedFace>& faces)
        : volumes_(std::move(volumes)),
          faces_(faces),
          parent_(volumes_.size()),
          members_(volumes_.size()),
          first_face_(volumes_.size() + 1, 0),
          face_of_(2 * faces.size()) {
        std::iota(parent_.begin(), parent_.end(), 0);
        for (const SharedFace& face : faces_)
            for (const int piece : face.pieces) ++first_face_[std::size_t(piece) + 1];
        std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
        std::vector<int> next(first_face_.begin(), first_face_.end() - 1);
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (const int piece : faces_[f].pieces)
                face_of_[std::size_t(next[std::size_t(piece)]++)] = int(f);
    }

    int rootOf(int piece) {
        while (parent_[std::size_t(piece)] != piece) {
            int& parent = parent_[std::size_t(piece)];
            parent = parent_[std::size_t(parent)];
            piece = parent;
        }
        return piece;
    }

    /// Merges `root` with its neighbours until it is not small.
    void mergeWhileSmall(int root, double fraction) {
        // A corner cut off at equal edges a has the volume a^3 / 6 and the largest face a^2 / 2.
        const double corner_depth = std::cbrt(6 * fraction) / 3;
        for (;;) {
            gatherNeighbours(root);
            if (neighbours_.empty()) return;
            auto target = neighbours_.front();
            for (const auto& neighbour : neighbours_)
                if (neighbour.second > (1 + tie) * target.second) target = neighbour;
            const double volume = volumes_[std::size_t(root)];
            const bool small = volume < fraction && volume < corner_depth * target.second;
            if (!small && volume > rounding) return;
            join(root, target.first);
            root = target.first;
        }
    }

  private:
    /// Roots that `root` shares faces with and the area, ascending by root.
    void gatherNeighbours(int root) {
        neighbours_.clear();
        const auto gather = [&](int piece) {
            for (int i = first_face_[std::size_t(piece)]; i < first_face_[std::size_t(piece) + 1]; ++i) {
                const SharedFace& face = faces_[std::size_t(face_of_[std::size_t(i)])];
                const int other = rootOf(face.pieces[face.pieces[0] == piece ? 1 : 0]);
                if (other != root) neighbours_.emplace_back(other, face.area);
            }
        };
        gather(root);
        for (const int piece : members_[std::size_t(root)]) gather(piece);
        std::stable_sort(neighbours_.begin(), neighbours_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < neighbours_.size(); ++i)
            if (kept > 0 && neighbours_[kept - 1].first == neighbours_[i].first)
                neighbours_[kept - 1].second += neighbours_[i].second;
            else
                neighbours_[kept++] = neighbours_[i];
        neighbours_.resize(kept);
    }

    void join(int from, int into) {
        parent_[std::size_t(from)] = into;
        volumes_[std::size_t(into)] += volumes_[std::size_t(from)];
        auto& members = members_[std::size_t(into)];
        members.push_back(from);
        members.insert(members.end(), members_[std::size_t(from)].begin(), members_[std::size_t(from)].end());
        members_[std::size_t(from)].clear();
    }

    std::vector<double> volumes_;
    const std::vector<SharedFace>& faces_;
    std::vector<int> parent_;
    std::vector<std::vector<int>> members_;  ///< per root: what was merged into it
    std::vector<int> first_face_, face_of_;  ///< faces of each piece, compressed rows
    std::vector<std::pair<int, double>> neighbours_;
};

}  // namespace

std::vector<int> mergeSmall(std::vector<double> volumes, const std::vector<SharedFace>& faces,
                            double fraction) {
    const int count = int(volumes.size());
    std::vector<int> small;
    for (int i = 0; i < count; ++i)
        if (volumes[std::size_t(i)] < fraction) small.push_back(i);
    std::stable_sort(small.begin(), small.end(), [&](int a, int b) {
        return std::round(volumes[std::size_t(a)] / tie) < std::round(volumes[std::size_t(b)] / tie);
    });

    Merging merging(std::move(volumes), faces);
    for (const int piece : small)
        if (merging.rootOf(piece) == piece) merging.mergeWhileSmall(piece, fraction);
    std::vector<int> root(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) root[std::size_t(i)] = merging.rootOf(i);
    return root;
}

}  // namespace sherd
