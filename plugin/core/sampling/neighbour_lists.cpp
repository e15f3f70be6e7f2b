#include "core/sampling/neighbour_lists.h"

#include <algorithm>

namespace sherd {

std::vector<std::vector<int>> neighbourLists(std::size_t count,
                                             const std::vector<std::array<int, 2>>& links) {
    std::vector<std::vector<int>> neighbours(count);
    for (const auto& [a, b] : links) {
        if (a == b) continue;
        neighbours[std::size_t(a)].push_back(b);
        neighbours[std::size_t(b)].push_back(a);
    }
    for (std::vector<int>& list : neighbours) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return neighbours;
}

}  // namespace sherd
