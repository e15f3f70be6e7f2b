#include "core/mlpg/splines/spline_ties.h"

#include <algorithm>

namespace sherd {
namespace {

constexpr double well_filled = 0.25;  // a part that fills less of its cell determines no function by itself
constexpr int search_layers = 3;      // of neighbouring parts, for a well-filled one

/// Lagrange polynomial `k` on the nodes 0 ... degree, at an integer.
double lagrange(int degree, int k, int at) {
    double value = 1;
    for (int m = 0; m <= degree; ++m)
        if (m != k) value *= static_cast<double>(at - m) / (k - m);
    return value;
}

/// The parts that determine functions: those that are well filled, and where there is none around, the best
/// of a function's support.
class GoodParts {
  public:
    GoodParts(const CellParts& solid, const RawFunctions& raw)
        : solid_(solid), raw_(raw), good_(solid.parts.size(), 0), mark_(solid.parts.size(), -1) {
        for (size_t part = 0; part < good_.size(); ++part)
            good_[part] = solid.parts[part].fill >= well_filled;
        for (int function = 0; function < raw.count(); ++function)
            if (nearest(function) < 0) good_[fullestOf(raw.supports[function])] = 1;
    }

    bool any(const std::vector<int>& parts) const {
        return std::any_of(parts.begin(), parts.end(), [&](int part) { return good_[part]; });
    }

    /// Of the good parts in the fewest steps along neighbours from a function's support, the one nearest to
    /// its middle; -1 if none is near.
    int nearest(int function) {
        layer_ = raw_.supports[function];
        ++stamp_;
        for (const int part : layer_) mark_[part] = stamp_;
        for (int step = 0; step <= search_layers; ++step) {
            int best = -1;
            for (const int part : layer_)
                if (good_[part] && (best < 0 || better(function, part, best))) best = part;
            if (best >= 0) return best;
            advance();
            if (layer_.empty()) break;
        }
        return -1;
    }

  private:
    int fullestOf(const std::vector<int>& parts) const {
        int best = parts[0];
        for (const int part : parts)
            if (solid_.parts[part].fill > solid_.parts[best].fill ||
                (solid_.parts[part].fill == solid_.parts[best].fill && part < best))
                best = part;
        return best;
    }

    bool better(int function, int a, int b) const {
        // Twice the distance from the middle of the support to the middle of a cell, in cells, squared.
        const auto distance = [&](int part) {
            const Eigen::Vector3i twice = 2 * (raw_.highest_cells[function] - solid_.parts[part].cell) -
                                          Eigen::Vector3i::Constant(raw_.degree);
            return twice.squaredNorm();
        };
        if (distance(a) != distance(b)) return distance(a) < distance(b);
        if (solid_.parts[a].fill != solid_.parts[b].fill) return solid_.parts[a].fill > solid_.parts[b].fill;
        return a < b;
    }

    /// From a layer of parts to their neighbours that no layer had yet.
    void advance() {
        next_.clear();
        for (const int part : layer_)
            for (const int other : solid_.neighbours[part])
                if (mark_[other] != stamp_) {
                    mark_[other] = stamp_;
                    next_.push_back(other);
                }
        layer_.swap(next_);
    }

    const CellParts& solid_;
    const RawFunctions& raw_;
    std::vector<char> good_;                // per part
    std::vector<int> mark_, layer_, next_;  // of the search
    int stamp_ = 0;
};

}  // namespace

SplineTies::SplineTies(const CellParts& solid, const RawFunctions& raw) {
    GoodParts good(solid, raw);
    std::vector<int> number(raw.count(), -1);
    for (int function = 0; function < raw.count(); ++function) {
        if (!good.any(raw.supports[function])) continue;
        number[function] = static_cast<int>(raw_of_function.size());
        raw_of_function.push_back(function);
    }
    const auto extrapolate = [&](int function, int part) {
        const Eigen::Vector3i distance = raw.highest_cells[function] - solid.parts[part].cell;
        for (int n = 0; n < raw.perPart(); ++n) {
            const Eigen::Vector3i node = raw.offset(n);
            double factor = 1;
            for (int d = 0; d < 3; ++d) factor *= lagrange(raw.degree, node[d], distance[d]);
            if (factor != 0) terms.push_back({number[raw.of_part[part][n]], factor});
        }
    };
    starts.assign(1, 0);
    for (int function = 0; function < raw.count(); ++function) {
        if (number[function] >= 0)
            terms.push_back({number[function], 1});
        else
            extrapolate(function, good.nearest(function));
        starts.push_back(static_cast<int>(terms.size()));
    }
}

}  // namespace sherd
