#include "core/mlpg/splines/spline_space.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace sherd {
namespace {

constexpr double well_filled = 0.25;  // a part that fills less of its cell determines no function by itself
constexpr int search_layers = 3;      // of neighbouring parts, for a well-filled one

using Pieces = std::array<double, 4>;

/// The p + 1 B-splines that differ from zero on a cell, at t in [-1/2, 1/2] from its middle, and their
/// slopes.
void pieces(int degree, double t, Pieces& value, Pieces& slope) {
    const double s = t + 0.5, r = 1 - s;
    switch (degree) {
        case 1:
            value = {r, s};
            slope = {-1, 1};
            break;
        case 2:
            value = {r * r / 2, 0.5 + s * r, s * s / 2};
            slope = {-r, r - s, s};
            break;
        default:
            value = {r * r * r / 6, (3 * s * s * s - 6 * s * s + 4) / 6, (3 * r * r * r - 6 * r * r + 4) / 6,
                     s * s * s / 6};
            slope = {-r * r / 2, (3 * s * s - 4 * s) / 2, (4 * r - 3 * r * r) / 2, s * s / 2};
    }
}

/// Lagrange polynomial `k` on the nodes 0 ... degree, at an integer.
double lagrange(int degree, int k, int at) {
    double value = 1;
    for (int m = 0; m <= degree; ++m)
        if (m != k) value *= static_cast<double>(at - m) / (k - m);
    return value;
}

/// Builds a SplineSpace step by step.
class Builder {
  public:
    Builder(const CellParts& solid, SplineSpace& space)
        : solid_(solid), space_(space), part_count_(static_cast<int>(solid.parts.size())) {}

    void run() {
        findComponents();
        splitByConnection();
        chooseGoodParts();
        tieOthers();
    }

  private:
    void findComponents() {
        space_.component_of_part.assign(part_count_, -1);
        std::vector<int> queue;
        for (int first = 0; first < part_count_; ++first) {
            if (space_.component_of_part[first] >= 0) continue;
            queue.assign(1, first);
            space_.component_of_part[first] = space_.component_count;
            for (size_t next = 0; next < queue.size(); ++next)
                for (const int other : solid_.neighbours[queue[next]]) {
                    if (space_.component_of_part[other] >= 0) continue;
                    space_.component_of_part[other] = space_.component_count;
                    queue.push_back(other);
                }
            ++space_.component_count;
        }
    }

    long long latticeIndex(const Eigen::Vector3i& point) const {
        const long long nx = solid_.count.x() + space_.degree, ny = solid_.count.y() + space_.degree;
        return (point.z() * ny + point.y()) * nx + point.x();
    }

    /// One raw function for every lattice point and connected set of parts in its support.
    void splitByConnection() {
        const int width = space_.degree + 1, per_part = space_.perPart();
        space_.raw_of.assign(part_count_, std::vector<int>(per_part, -1));
        // Lattice points in ascending order, each with the parts in its support, ascending.
        std::vector<std::pair<long long, int>> seen;
        seen.reserve(static_cast<size_t>(part_count_) * per_part);
        for (int part = 0; part < part_count_; ++part)
            for (int n = 0; n < per_part; ++n)
                seen.emplace_back(latticeIndex(solid_.parts[part].cell + offset(n, width)), part);
        std::sort(seen.begin(), seen.end());
        std::vector<int> members, stack;
        std::vector<int> group(part_count_, -1);
        for (size_t begin = 0, end = 0; begin < seen.size(); begin = end) {
            members.clear();
            for (end = begin; end < seen.size() && seen[end].first == seen[begin].first; ++end)
                members.push_back(seen[end].second);
            for (const int part : members) group[part] = -2;  // in this support, not reached yet
            for (const int part : members) {
                if (group[part] != -2) continue;
                const int raw = space_.raw_count++;
                supports_.emplace_back();
                points_.push_back(pointOf(seen[begin].first));
                stack.assign(1, part);
                group[part] = raw;
                while (!stack.empty()) {
                    const int here = stack.back();
                    stack.pop_back();
                    supports_.back().push_back(here);
                    const Eigen::Vector3i local = points_.back() - solid_.parts[here].cell;
                    space_.raw_of[here][(local.z() * width + local.y()) * width + local.x()] = raw;
                    for (const int other : solid_.neighbours[here])
                        if (group[other] == -2) {
                            group[other] = raw;
                            stack.push_back(other);
                        }
                }
            }
            for (const int part : members) group[part] = -1;
        }
    }

    static Eigen::Vector3i offset(int n, int width) {
        return {n % width, n / width % width, n / width / width};
    }

    Eigen::Vector3i pointOf(long long index) const {
        const long long nx = solid_.count.x() + space_.degree, ny = solid_.count.y() + space_.degree;
        return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
                static_cast<int>(index / nx / ny)};
    }

    /// Well-filled parts, and where there is none around, the best of a function's support.
    void chooseGoodParts() {
        good_.assign(part_count_, 0);
        for (int part = 0; part < part_count_; ++part) good_[part] = solid_.parts[part].fill >= well_filled;
        for (int raw = 0; raw < space_.raw_count; ++raw) {
            if (nearestGood(raw) >= 0) continue;
            const std::vector<int>& support = supports_[raw];
            int best = support[0];
            for (const int part : support)
                if (solid_.parts[part].fill > solid_.parts[best].fill ||
                    (solid_.parts[part].fill == solid_.parts[best].fill && part < best))
                    best = part;
            good_[best] = 1;
        }
    }

    /// Of the good parts in the fewest steps along neighbours, the one nearest to the middle of the
    /// function's support; -1 if none is near.
    int nearestGood(int raw) {
        const std::vector<int>& from = supports_[raw];
        // Twice the distance to the middle of a cell, in cells, squared.
        const auto distance = [&](int part) {
            const Eigen::Vector3i twice =
                2 * (points_[raw] - solid_.parts[part].cell) - Eigen::Vector3i::Constant(space_.degree);
            return twice.squaredNorm();
        };
        const auto better = [&](int a, int b) {
            if (distance(a) != distance(b)) return distance(a) < distance(b);
            if (solid_.parts[a].fill != solid_.parts[b].fill)
                return solid_.parts[a].fill > solid_.parts[b].fill;
            return a < b;
        };
        std::vector<int>& layer = layer_;
        layer = from;
        if (static_cast<int>(mark_.size()) != part_count_) mark_.assign(part_count_, -1);
        ++stamp_;
        for (const int part : layer) mark_[part] = stamp_;
        for (int step = 0; step <= search_layers; ++step) {
            int best = -1;
            for (const int part : layer)
                if (good_[part] && (best < 0 || better(part, best))) best = part;
            if (best >= 0) return best;
            next_.clear();
            for (const int part : layer)
                for (const int other : solid_.neighbours[part])
                    if (mark_[other] != stamp_) {
                        mark_[other] = stamp_;
                        next_.push_back(other);
                    }
            layer.swap(next_);
            if (layer.empty()) break;
        }
        return -1;
    }

    void tieOthers() {
        std::vector<int> number(space_.raw_count, -1);
        for (int raw = 0; raw < space_.raw_count; ++raw) {
            const std::vector<int>& support = supports_[raw];
            if (std::none_of(support.begin(), support.end(), [&](int part) { return good_[part]; })) continue;
            number[raw] = space_.function_count++;
            const Vec3 shift = Vec3::Constant((1 - space_.degree) / 2.0);
            space_.centres.push_back(solid_.origin +
                                     (points_[raw].cast<double>() + shift).cwiseProduct(solid_.edges));
            space_.points.push_back(points_[raw]);
            space_.component.push_back(space_.component_of_part[support[0]]);
        }
        space_.term_starts.assign(1, 0);
        for (int raw = 0; raw < space_.raw_count; ++raw) {
            if (number[raw] >= 0)
                space_.terms.push_back({number[raw], 1});
            else
                extrapolate(raw, nearestGood(raw), number);
            space_.term_starts.push_back(static_cast<int>(space_.terms.size()));
        }
    }

    void extrapolate(int raw, int part, const std::vector<int>& number) {
        const int width = space_.degree + 1;
        const Eigen::Vector3i distance = points_[raw] - solid_.parts[part].cell;
        for (int n = 0; n < space_.perPart(); ++n) {
            const Eigen::Vector3i node = offset(n, width);
            double factor = 1;
            for (int d = 0; d < 3; ++d) factor *= lagrange(space_.degree, node[d], distance[d]);
            if (factor != 0) space_.terms.push_back({number[space_.raw_of[part][n]], factor});
        }
    }

    const CellParts& solid_;
    SplineSpace& space_;
    int part_count_;
    std::vector<std::vector<int>> supports_;  // per raw function: its parts
    std::vector<Eigen::Vector3i>
        points_;  // per raw function: its lattice point, the highest cell of its support
    std::vector<char> good_;
    std::vector<int> mark_, layer_, next_;
    int stamp_ = 0;
};

}  // namespace

SplineSpace::SplineSpace(const CellParts& solid, int spline_degree) : degree(spline_degree) {
    Builder(solid, *this).run();
}

Eigen::Matrix3Xd SplineSpace::expand(const Eigen::VectorXd& unknowns) const {
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, raw_count);
    for (int r = 0; r < raw_count; ++r)
        for (int k = term_starts[r]; k < term_starts[r + 1]; ++k)
            raw.col(r) += terms[k].factor * unknowns.segment<3>(3L * terms[k].function);
    return raw;
}

Eigen::VectorXd SplineSpace::gather(const Eigen::Matrix3Xd& raw) const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(3L * function_count);
    for (int r = 0; r < raw_count; ++r)
        for (int k = term_starts[r]; k < term_starts[r + 1]; ++k)
            forces.segment<3>(3L * terms[k].function) += terms[k].factor * raw.col(r);
    return forces;
}

void splineValues(int degree, const Vec3& xi, std::vector<double>& values) {
    std::array<Pieces, 3> value, slope;
    for (int d = 0; d < 3; ++d) pieces(degree, xi[d], value[d], slope[d]);
    values.clear();
    for (int k = 0; k <= degree; ++k)
        for (int j = 0; j <= degree; ++j)
            for (int i = 0; i <= degree; ++i) values.push_back(value[0][i] * value[1][j] * value[2][k]);
}

void splineGradients(int degree, const Vec3& xi, std::vector<Vec3>& gradients) {
    std::array<Pieces, 3> value, slope;
    for (int d = 0; d < 3; ++d) pieces(degree, xi[d], value[d], slope[d]);
    gradients.clear();
    for (int k = 0; k <= degree; ++k)
        for (int j = 0; j <= degree; ++j)
            for (int i = 0; i <= degree; ++i)
                gradients.emplace_back(slope[0][i] * value[1][j] * value[2][k],
                                       value[0][i] * slope[1][j] * value[2][k],
                                       value[0][i] * value[1][j] * slope[2][k]);
}

Eigen::MatrixXd splinePowers(int degree) {
    Eigen::MatrixXd at(degree + 1, degree + 1), vandermonde(degree + 1, degree + 1);
    for (int q = 0; q <= degree; ++q) {
        const double t = q / static_cast<double>(degree) - 0.5;
        Pieces value, slope;
        pieces(degree, t, value, slope);
        for (int a = 0; a <= degree; ++a) at(q, a) = value[a];
        for (int k = 0; k <= degree; ++k) vandermonde(q, k) = std::pow(t, k);
    }
    return vandermonde.inverse() * at;
}

}  // namespace sherd
