#include "core/linear_algebra/nested_dissection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sherd {
namespace {

constexpr int smallest_cut = 100;          // vertices: in fewer, a local order does as well
constexpr double smallest_half = 0.15;     // of the vertices, on either side of a cut
constexpr double largest_separator = 0.6;  // of the vertices; more leave nothing to be gained

class Dissection {
  public:
    Dissection(const BlockGraph& graph, const std::vector<Eigen::Vector3i>& places)
        : graph_(graph),
          places_(places),
          side_(graph.size(), outside),
          order_(graph.size()),
          part_(graph.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        dissect(0, graph.size());
    }

    std::vector<int> parts() && { return std::move(part_); }

  private:
    /// Vertices with a place of at least `plane` along the axis lie above the cut.
    struct Cut {
        int axis = 0, plane = 0;
    };

    /// Gives the vertices order_[begin] ... order_[end - 1] their parts.
    void dissect(int begin, int end) {
        if (begin == end) return;
        Cut cut;
        if (end - begin <= smallest_cut || !findCut(begin, end, cut)) return makePart(begin, end);
        const auto first = order_.begin() + begin, last = order_.begin() + end;
        for (auto v = first; v != last; ++v) side_[*v] = places_[*v][cut.axis] >= cut.plane ? above : below;
        const auto touches = [&](int vertex, char other_side) {
            for (int e = graph_.starts[vertex]; e < graph_.starts[vertex + 1]; ++e)
                if (side_[graph_.neighbours[e]] == other_side) return true;
            return false;
        };
        const auto touching = [&](char side) {
            std::vector<int> list;
            for (auto v = first; v != last; ++v)
                if (side_[*v] == side && touches(*v, side == below ? above : below)) list.push_back(*v);
            return list;
        };
        const std::vector<int> lower = touching(below), upper = touching(above);
        for (const int vertex : lower.size() < upper.size() ? lower : upper) side_[vertex] = separator;
        const auto middle =
            std::stable_partition(first, last, [&](int vertex) { return side_[vertex] == below; });
        const auto top =
            std::stable_partition(middle, last, [&](int vertex) { return side_[vertex] == above; });
        const int middle_at = static_cast<int>(middle - order_.begin()),
                  top_at = static_cast<int>(top - order_.begin());
        for (auto v = first; v != last; ++v) side_[*v] = outside;
        if (end - top_at > largest_separator * (end - begin)) return makePart(begin, end);
        dissect(begin, middle_at);
        dissect(middle_at, top_at);
        makePart(top_at, end);
    }

    void makePart(int begin, int end) {
        for (int k = begin; k < end; ++k) part_[order_[k]] = part_count_;
        ++part_count_;
    }

    /// The cut with the fewest vertices beside it for what it splits off. False where none splits off much.
    bool findCut(int begin, int end, Cut& best) {
        Eigen::Vector3i lowest = places_[order_[begin]], highest = lowest;
        for (int k = begin; k < end; ++k) {
            lowest = lowest.cwiseMin(places_[order_[k]]);
            highest = highest.cwiseMax(places_[order_[k]]);
        }
        double least = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            layers_.assign(highest[axis] - lowest[axis] + 1, 0);
            for (int k = begin; k < end; ++k) ++layers_[places_[order_[k]][axis] - lowest[axis]];
            const int count = static_cast<int>(layers_.size());
            for (int cut = 1, under = 0; cut < count; ++cut) {
                under += layers_[cut - 1];
                const int half = std::min(under, end - begin - under);
                if (half < smallest_half * (end - begin)) continue;
                // Quadratic splines reach over two layers.
                const int below_cut = layers_[cut - 1] + (cut > 1 ? layers_[cut - 2] : 0);
                const int above_cut = layers_[cut] + (cut + 1 < count ? layers_[cut + 1] : 0);
                const double cost = std::min(below_cut, above_cut) / static_cast<double>(half);
                if (cost >= least) continue;
                least = cost;
                best = {axis, lowest[axis] + cut};
            }
        }
        return std::isfinite(least);
    }

    enum Side : char { outside, below, above, separator };
    const BlockGraph& graph_;
    const std::vector<Eigen::Vector3i>& places_;
    std::vector<char> side_;
    std::vector<int> order_, part_, layers_;
    int part_count_ = 0;
};

}  // namespace

std::vector<int> nestedDissection(const BlockGraph& graph, const std::vector<Eigen::Vector3i>& places) {
    return Dissection(graph, places).parts();
}

}  // namespace sherd
