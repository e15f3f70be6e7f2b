#include "core/mlpg/reduced/local_functions.h"

#include <algorithm>
#include <map>
#include <utility>

namespace sherd {

namespace {

/// Of the largest load on a part: a support presses with little on many places, where the modes do. Functions
/// there would leave fewer for what strikes.
constexpr double faint = 0.03;

}  // namespace

LocalFunctions::LocalFunctions(const SplineProblem& problem)
    : parts_(problem.parts()), function_count_(problem.space->function_count) {
    const SplineSpace& space = *problem.space;
    std::vector<int> last_part(static_cast<std::size_t>(function_count_), -1);
    const int part_count = static_cast<int>(space.raw_of.size());
    of_part_.reserve(space.raw_of.size() * static_cast<std::size_t>(space.perPart()));
    starts_.push_back(0);
    for (int part = 0; part < part_count; ++part) {
        for (const int r : space.raw_of[part])
            for (const SplineTies::Term& term : space.termsOf(r))
                if (std::exchange(last_part[term.function], part) != part) of_part_.push_back(term.function);
        starts_.push_back(static_cast<int>(of_part_.size()));
    }
}

std::vector<int> LocalFunctions::around(const std::vector<PointForce>& loads, int most) const {
    std::map<int, Push> pushes;  // by part
    for (const PointForce& load : loads) {
        const int part = parts_.partAt(load.position);
        if (part < 0) continue;
        const double size = load.force.norm();
        pushes[part].place += size * load.position;
        pushes[part].force += load.force;
        pushes[part].size += size;
    }
    std::vector<std::pair<double, int>> largest_first;
    for (const auto& [part, push] : pushes) largest_first.push_back({-push.size, part});
    std::sort(largest_first.begin(), largest_first.end());
    while (!largest_first.empty() && largest_first.back().first > faint * largest_first.front().first)
        largest_first.pop_back();

    std::vector<int> parts;  // in order of importance
    for (const auto& entry : largest_first) parts.push_back(entry.second);
    for (const auto& entry : largest_first) addThrough(pushes[entry.second], parts);
    const std::size_t under_loads = parts.size();
    for (std::size_t i = 0; i < under_loads; ++i)
        parts.insert(parts.end(), parts_.neighbours[parts[i]].begin(), parts_.neighbours[parts[i]].end());
    for (std::size_t i = 0; i < largest_first.size(); ++i) addDiagonal(parts[i], parts);

    std::vector<char> is_chosen(static_cast<std::size_t>(function_count_), 0);
    std::vector<int> chosen;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int part = parts[i];
        if (static_cast<int>(chosen.size()) >= (i < under_loads ? most : most / 2)) break;
        for (int at = starts_[part]; at < starts_[part + 1]; ++at)
            if (!std::exchange(is_chosen[of_part_[at]], 1)) chosen.push_back(of_part_[at]);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

/// Adds the parts that a push meets on its way through the solid: on the far face of a thin wall the stress
/// is as local as under the load.
void LocalFunctions::addThrough(const Push& push, std::vector<int>& parts) const {
    constexpr double step = 0.5;  // of the shortest edge of a cell
    constexpr int most_steps = 8;
    if (!(push.size > 0) || !(push.force.norm() > 0)) return;
    const Vec3 stride = step * parts_.edges.minCoeff() * push.force.normalized();
    Vec3 x = push.place / push.size;
    for (int i = 0; i < most_steps; ++i) {
        x += stride;
        const int part = parts_.partAt(x);
        if (part < 0 || parts_.toCell(x, parts_.parts[part].cell).cwiseAbs().maxCoeff() > 0.5) return;
        if (parts.back() != part) parts.push_back(part);
    }
}

/// Adds the parts in the cells that touch that of a part in an edge, reached through those beside it.
void LocalFunctions::addDiagonal(int part, std::vector<int>& parts) const {
    for (const int beside : parts_.neighbours[part])
        for (const int second : parts_.neighbours[beside])
            if ((parts_.parts[second].cell - parts_.parts[part].cell).cwiseAbs().maxCoeff() <= 1)
                parts.push_back(second);
}

}  // namespace sherd
