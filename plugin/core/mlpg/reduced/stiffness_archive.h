#pragma once

#include <algorithm>
#include <array>
#include <cstring>

#include "core/archive/finite.h"
#include "core/archive/indices.h"
#include "core/mlpg/reduced/packed_stiffness.h"

namespace sherd {

inline constexpr int entries_of_block = 9;
inline constexpr std::array<int, 4> bits_of_entries = {8, 10, 12, 16};  // by their kind

inline std::size_t bytesOfEntries(int kind) {
    return static_cast<std::size_t>((entries_of_block * bits_of_entries[static_cast<std::size_t>(kind)] + 7) /
                                    8);
}

/// The kind of the fewest bits that hold the entries of a block. Most couplings are weak, and few bits hold
/// them.
inline int kindOfEntries(const std::int16_t* entries) {
    std::size_t kind = 0;
    for (int e = 0; e < entries_of_block; ++e)
        while (entries[e] < -(1 << (bits_of_entries[kind] - 1)) ||
               entries[e] >= 1 << (bits_of_entries[kind] - 1))
            ++kind;
    return static_cast<int>(kind);
}

/// Without branches on the kind, which nothing foretells. Four bytes are read from where an entry begins.
inline void unpackEntries(const std::byte* from, int kind, std::int16_t* entries) {
    const int bits = bits_of_entries[static_cast<std::size_t>(kind)], most = 1 << (bits - 1);
    for (int e = 0; e < entries_of_block; ++e) {
        std::uint32_t four = 0;
        std::memcpy(&four, from + e * bits / 8, sizeof four);
        const auto own = static_cast<int>(four >> (e * bits % 8) & static_cast<std::uint32_t>(2 * most - 1));
        entries[e] = static_cast<std::int16_t>(own - most);
    }
}

inline void packEntries(const std::int16_t* entries, int kind, std::byte* to) {
    const int bits = bits_of_entries[static_cast<std::size_t>(kind)], most = 1 << (bits - 1);
    for (int e = 0; e < entries_of_block; ++e) {
        std::uint32_t four = 0;
        std::memcpy(&four, to + e * bits / 8, sizeof four);
        four |= static_cast<std::uint32_t>(entries[e] + most) << (e * bits % 8);
        std::memcpy(to + e * bits / 8, &four, sizeof four);
    }
}

/// The entries of all blocks one after the other, each in the bits of its kind.
template <class Archive>
void archiveEntries(Archive& archive, const std::vector<std::uint8_t>& heads,
                    UnsetVector<std::int16_t>& entries) {
    std::size_t size = sizeof(std::uint32_t);  // with room for the last one to be read as four
    for (const std::uint8_t head : heads) size += bytesOfEntries(head % 4);
    std::vector<std::byte> packed;
    if constexpr (Archive::reads) {
        const std::byte* from = archive.next(size);
        archive.require(from);
        if (!from) return;
        archive.skip(size);
        entries.resize(entries_of_block * heads.size());
        std::int16_t* to = entries.data();
        for (const std::uint8_t head : heads) {
            unpackEntries(from, head % 4, to);
            from += bytesOfEntries(head % 4);
            to += entries_of_block;
        }
    } else {
        packed.resize(size);
        std::byte* to = packed.data();
        for (std::size_t b = 0; b < heads.size(); ++b) {
            packEntries(entries.data() + entries_of_block * b, heads[b] % 4, to);
            to += bytesOfEntries(heads[b] % 4);
        }
        archive.raw(packed.data(), size);
    }
}

/// The rows of the blocks, which fall down each column: a head has how far it is from the row before, and the
/// kind of the block's entries. Rows that are too far are listed.
inline constexpr int far_row = 63;

inline std::vector<std::uint8_t> headsOf(const PackedStiffness& stiffness, std::vector<int>& far_rows) {
    std::vector<std::uint8_t> heads;
    for (int column = 0; column < stiffness.blockCount(); ++column) {
        int row = column;
        for (int b = stiffness.starts[column]; b < stiffness.starts[column + 1]; ++b) {
            const int step = std::min(stiffness.rows[b] - row, far_row);
            row = stiffness.rows[b];
            if (step == far_row) far_rows.push_back(row);
            heads.push_back(static_cast<std::uint8_t>(
                4 * step + kindOfEntries(stiffness.entries.data() + entries_of_block * b)));
        }
    }
    return heads;
}

/// False if a row is none of the matrix.
inline bool findRows(const std::vector<std::uint8_t>& heads, const std::vector<int>& far_rows,
                     PackedStiffness& stiffness) {
    stiffness.rows.resize(heads.size());
    auto next_far = far_rows.begin();
    for (int column = 0; column < stiffness.blockCount(); ++column) {
        int row = column;
        for (int b = stiffness.starts[column]; b < stiffness.starts[column + 1]; ++b) {
            const int step = heads[b] / 4;
            if (step == far_row && next_far == far_rows.end()) return false;
            row = step == far_row ? *next_far++ : row + step;
            if (row < column || row >= stiffness.blockCount()) return false;
            stiffness.rows[b] = row;
        }
    }
    return next_far == far_rows.end();
}

/// Of so many functions.
template <class Archive>
void archiveStiffness(Archive& archive, int function_count, PackedStiffness& stiffness) {
    auto& [starts, rows, entries, roots] = stiffness;
    static_cast<void>(rows);  // by their heads
    const auto blocks = static_cast<std::size_t>(function_count);
    std::vector<std::uint8_t> heads;
    std::vector<int> far_rows;
    if constexpr (!Archive::reads) heads = headsOf(stiffness, far_rows);
    archiveAll(archive, roots, heads);
    archiveIndices(archive, far_rows, function_count);
    archiveStarts(archive, starts, blocks, heads.size());
    archive.require(roots.size() == 3 * blocks && areFinite(roots));
    if (!archive.good()) return;
    if constexpr (Archive::reads) archive.require(findRows(heads, far_rows, stiffness));
    archiveEntries(archive, heads, entries);
}

}  // namespace sherd
