#include "core/mlpg/splines/spline_ties.h"

#include <algorithm>
#include <cmath>

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/part_integrals.h"

namespace sherd {
namespace {

constexpr double well_filled = 0.25;  // a part that fills less of its cell determines no function by itself
constexpr double ill_held = 0.1;      // of what the corner of a cell holds of a function, see cornerHold
constexpr int search_layers = 3;      // of neighbouring parts, for a well-filled one

/// Lagrange polynomial `k` on the nodes 0 ... degree, at an integer.
double lagrange(int degree, int k, int at) {
    double value = 1;
    for (int m = 0; m <= degree; ++m)
        if (m != k) value *= static_cast<double>(at - m) / (k - m);
    return value;
}

/// int phi^2 of a function over the cube that fills a corner of a cell just well, where the function begins:
/// the least that a well-filled cube holds of any function.
double cornerHold(int degree) {
    const double cube = std::cbrt(well_filled);
    constexpr int steps = 64;  // midpoints: the threshold needs no more
    double sum = 0;
    std::vector<double> values;
    for (int i = 0; i < steps; ++i) {
        const double at = (i + 0.5) / steps * cube - 0.5;
        splineValues(degree, Vec3::Constant(at), values);
        sum += std::pow(values.back(), 2.0 / 3) * cube / steps;  // of one direction
    }
    return sum * sum * sum;
}

/// Functions of which the solid holds next to nothing, though some part in their support may be well filled:
/// that part lies where they all but vanish. Per raw function.
std::vector<char> illHeld(const CellParts& solid, const RawFunctions& raw) {
    std::vector<char> ill(raw.count(), 0);
    if (solid.order < 2 * raw.degree) return ill;  // counts of functions do without moments
    const PartIntegrals integrals(raw.degree, solid.edges);
    std::vector<double> squares(raw.count(), 0.0);
    for (size_t part = 0; part < solid.parts.size(); ++part) {
        const Eigen::VectorXd own = integrals.squares(solid.parts[part]);
        for (int n = 0; n < raw.perPart(); ++n) squares[raw.of_part[part][n]] += own[n];
    }
    const double least = ill_held * cornerHold(raw.degree);
    for (int function = 0; function < raw.count(); ++function) ill[function] = squares[function] < least;
    return ill;
}

/// The parts that determine functions: those that are well filled and hold all of theirs. Where there is none
/// around, as in a sheet far thinner than a cell, those that are well filled beside the fullest around.
class GoodParts {
  public:
    GoodParts(const CellParts& solid, const RawFunctions& raw)
        : solid_(solid), raw_(raw), good_(solid.parts.size(), 0), mark_(solid.parts.size(), -1) {
        const std::vector<char> ill = illHeld(solid, raw);
        std::vector<char> holds_all;
        for (const std::vector<int>& functions : raw.of_part)
            holds_all.push_back(
                std::none_of(functions.begin(), functions.end(), [&](int f) { return ill[f]; }));
        for (size_t part = 0; part < good_.size(); ++part)
            good_[part] = solid.parts[part].fill >= well_filled && holds_all[part];
        for (int function = 0; function < raw.count(); ++function)
            if (nearest(function) < 0) promoteBestAround(holds_all);
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
        looked_at_.clear();
        for (int step = 0; step <= search_layers; ++step) {
            looked_at_.insert(looked_at_.end(), layer_.begin(), layer_.end());
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
    /// Of the parts that `nearest` has just looked at in vain: those that hold all of their functions, if
    /// there are any.
    void promoteBestAround(const std::vector<char>& holds_all) {
        const bool some =
            std::any_of(looked_at_.begin(), looked_at_.end(), [&](int part) { return holds_all[part]; });
        const auto counts = [&](int part) { return !some || holds_all[part]; };
        double fullest = 0;
        for (const int part : looked_at_)
            if (counts(part)) fullest = std::max(fullest, solid_.parts[part].fill);
        for (const int part : looked_at_)
            if (counts(part) && solid_.parts[part].fill >= well_filled * fullest) good_[part] = 1;
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
    std::vector<char> good_;                            // per part
    std::vector<int> mark_, layer_, next_, looked_at_;  // of the search
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
