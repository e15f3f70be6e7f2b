#include "core/mlpg/splines/raw_functions.h"

#include <algorithm>

namespace sherd {
namespace {

/// Highest cells of supports, numbered: they reach `degree` cells beyond the grid.
struct Lattice {
    long long nx, ny;

    Lattice(const CellParts& solid, int degree)
        : nx(solid.count.x() + degree), ny(solid.count.y() + degree) {}

    long long index(const Eigen::Vector3i& point) const {
        return (point.z() * ny + point.y()) * nx + point.x();
    }
    Eigen::Vector3i point(long long index) const {
        return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
                static_cast<int>(index / nx / ny)};
    }
};

/// Makes the functions of one lattice point after the other.
class Splitter {
  public:
    Splitter(const CellParts& solid, RawFunctions& functions)
        : solid_(solid), functions_(functions), group_(solid.parts.size(), elsewhere) {}

    /// `members`: all parts in the support of a lattice point, ascending.
    void split(const Eigen::Vector3i& point, const std::vector<int>& members) {
        for (const int part : members) group_[part] = not_reached;
        for (const int part : members)
            if (group_[part] == not_reached) addFunction(point, part);
        for (const int part : members) group_[part] = elsewhere;
    }

  private:
    /// The function of all parts that are connected to `first` inside the support.
    void addFunction(const Eigen::Vector3i& point, int first) {
        const int raw = functions_.count(), width = functions_.degree + 1;
        functions_.supports.emplace_back();
        functions_.highest_cells.push_back(point);
        stack_.assign(1, first);
        group_[first] = raw;
        while (!stack_.empty()) {
            const int part = stack_.back();
            stack_.pop_back();
            functions_.supports.back().push_back(part);
            const Eigen::Vector3i local = point - solid_.parts[part].cell;
            functions_.of_part[part][(local.z() * width + local.y()) * width + local.x()] = raw;
            for (const int other : solid_.neighbours[part])
                if (group_[other] == not_reached) {
                    group_[other] = raw;
                    stack_.push_back(other);
                }
        }
    }

    static constexpr int elsewhere = -1, not_reached = -2;
    const CellParts& solid_;
    RawFunctions& functions_;
    std::vector<int> group_, stack_;
};

}  // namespace

RawFunctions::RawFunctions(const CellParts& solid, int spline_degree) : degree(spline_degree) {
    const int part_count = static_cast<int>(solid.parts.size());
    of_part.assign(part_count, std::vector<int>(perPart(), -1));
    // Lattice points in ascending order, each with the parts in its support, ascending.
    const Lattice lattice(solid, degree);
    std::vector<std::pair<long long, int>> seen;
    seen.reserve(static_cast<size_t>(part_count) * perPart());
    for (int part = 0; part < part_count; ++part)
        for (int n = 0; n < perPart(); ++n)
            seen.emplace_back(lattice.index(solid.parts[part].cell + offset(n)), part);
    std::sort(seen.begin(), seen.end());
    Splitter splitter(solid, *this);
    std::vector<int> members;
    for (size_t begin = 0, end = 0; begin < seen.size(); begin = end) {
        members.clear();
        for (end = begin; end < seen.size() && seen[end].first == seen[begin].first; ++end)
            members.push_back(seen[end].second);
        splitter.split(lattice.point(seen[begin].first), members);
    }
}

}  // namespace sherd
