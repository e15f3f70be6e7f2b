#include "core/sampling/merge_small.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/numerics/union_find.h"

namespace sherd {
namespace {

constexpr double rounding = 1e-12;  // of a whole cell: less counts as no volume
constexpr double tie = 1e-9;        // relative differences below this are rounding: the lower index wins

/// The pieces as they are merged.
class Merging {
  public:
    Merging(std::vector<double> volumes, const std::vector<SharedFace>& faces)
        : volumes_(std::move(volumes)),
          faces_(faces),
          sets_(volumes_.size()),
          members_(volumes_.size()),
          first_face_(volumes_.size() + 1, 0),
          face_of_(2 * faces.size()) {
        for (const SharedFace& face : faces_)
            for (const int piece : face.pieces) ++first_face_[std::size_t(piece) + 1];
        std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
        std::vector<int> next(first_face_.begin(), first_face_.end() - 1);
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (const int piece : faces_[f].pieces)
                face_of_[std::size_t(next[std::size_t(piece)]++)] = int(f);
    }

    bool isRoot(int piece) const { return sets_.isRoot(piece); }

    std::vector<int> roots() { return sets_.roots(); }

    /// Merges what `root` stands for into neighbours until the result is not small.
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
    /// The roots that `root` shares faces with, ascending, and the area shared with each.
    void gatherNeighbours(int root) {
        neighbours_.clear();
        const auto gather = [&](int piece) {
            for (int i = first_face_[std::size_t(piece)]; i < first_face_[std::size_t(piece) + 1]; ++i) {
                const SharedFace& face = faces_[std::size_t(face_of_[std::size_t(i)])];
                const int other = sets_.root(face.pieces[face.pieces[0] == piece ? 1 : 0]);
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
        sets_.uniteInto(into, from);
        volumes_[std::size_t(into)] += volumes_[std::size_t(from)];
        auto& members = members_[std::size_t(into)];
        members.push_back(from);
        members.insert(members.end(), members_[std::size_t(from)].begin(), members_[std::size_t(from)].end());
        members_[std::size_t(from)].clear();
    }

    std::vector<double> volumes_;
    const std::vector<SharedFace>& faces_;
    UnionFind sets_;
    std::vector<std::vector<int>> members_;  // per root: the pieces merged into it
    std::vector<int> first_face_, face_of_;  // the faces of each piece, compressed rows
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
        if (merging.isRoot(piece)) merging.mergeWhileSmall(piece, fraction);
    return merging.roots();
}

}  // namespace sherd
