#pragma once

#include <array>
#include <vector>

namespace sherd {

/// For each of `count` items the other items that a pair links it with, ascending and each once. Links of an
/// item to itself do not count.
std::vector<std::vector<int>> neighbourLists(std::size_t count, const std::vector<std::array<int, 2>>& links);

}  // namespace sherd
