#pragma once

#include <algorithm>
#include <vector>

#include "core/archive/archive.h"

namespace sherd {

// Indices take one, two or four bytes each, as the largest possible one needs, and none is read that is out
// of range.

namespace detail {

template <class Stored, class Archive>
void archiveNumber(Archive& archive, int& number, int least, std::uint32_t range) {
    auto stored = static_cast<Stored>(static_cast<std::uint32_t>(number) - static_cast<std::uint32_t>(least));
    archive.raw(&stored, sizeof stored);
    if constexpr (Archive::reads) {
        archive.require(stored < range);
        number = archive.good() ? static_cast<int>(stored) + least : least;
    }
}

template <class Stored, class Archive>
void archiveNumbers(Archive& archive, int* numbers, std::size_t count, int least, std::uint32_t range) {
    for (std::size_t i = 0; i < count; ++i) archiveNumber<Stored>(archive, numbers[i], least, range);
}

inline std::size_t bytesFor(std::uint32_t range) {
    return range <= 1u << 8 ? 1 : range <= 1u << 16 ? 2 : 4;
}

}  // namespace detail

/// least <= index < end, for each of some indices.
template <class Archive>
void archiveIndices(Archive& archive, int* indices, std::size_t count, int end, int least = 0) {
    if constexpr (!Archive::reads)
        for (std::size_t i = 0; i < count; ++i) archive.require(least <= indices[i] && indices[i] < end);
    const auto range = static_cast<std::uint32_t>(std::max(0, end - least));
    const std::size_t bytes = detail::bytesFor(range);
    if (bytes == 1) detail::archiveNumbers<std::uint8_t>(archive, indices, count, least, range);
    if (bytes == 2) detail::archiveNumbers<std::uint16_t>(archive, indices, count, least, range);
    if (bytes == 4) detail::archiveNumbers<std::uint32_t>(archive, indices, count, least, range);
}

/// The same for one index.
template <class Archive>
void archiveIndex(Archive& archive, int& index, int end, int least = 0) {
    archiveIndices(archive, &index, 1, end, least);
}

/// And for a list of them.
template <class Archive>
void archiveIndices(Archive& archive, std::vector<int>& list, int end, int least = 0) {
    const auto range = static_cast<std::uint32_t>(std::max(0, end - least));
    const std::size_t count = archive.count(list.size(), detail::bytesFor(range));
    if constexpr (Archive::reads) list.resize(count);
    archiveIndices(archive, list.data(), count, end, least);
}

/// And for a list of lists.
template <class Archive>
void archiveIndices(Archive& archive, std::vector<std::vector<int>>& lists, int end) {
    archiveList(archive, lists, sizeof(std::uint32_t),
                [&](std::vector<int>& list) { archiveIndices(archive, list, end); });
}

/// Where groups begin in a list of `items`: #groups + 1, from 0 on, never falling.
template <class Archive>
void archiveStarts(Archive& archive, std::vector<int>& starts, std::size_t groups, std::size_t items) {
    archive.require(items < std::numeric_limits<int>::max());
    archiveIndices(archive, starts, static_cast<int>(items) + 1);
    archive.require(starts.size() == groups + 1 && starts.front() == 0 &&
                    starts.back() == static_cast<int>(items) && std::is_sorted(starts.begin(), starts.end()));
}

}  // namespace sherd
