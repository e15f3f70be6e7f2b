#pragma once

#include <Eigen/Dense>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "core/archive/byte_reader.h"
#include "core/archive/byte_writer.h"

namespace sherd {

// An archive is a ByteWriter or a ByteReader. One function lists the fields of a struct for both,
//
//     template <class Archive>
//     void archiveFields(Archive& archive, Particle& particle) {
//         auto& [position, volume, spacing] = particle;
//         archiveAll(archive, position, volume, spacing);
//     }
//
// so that what is written is what is read, and a struct with one field more does not compile. Numbers keep
// their bits, in the order of this processor's bytes.

template <class Archive, class Value>
void archive(Archive& archive, Value& value);

template <class Archive, class... Values>
void archiveAll(Archive& to_or_from, Values&... values) {
    (archive(to_or_from, values), ...);
}

namespace detail {

/// Numbers without anything between them: copied as they lie in memory, alone or in a list.
template <class Value, class = void>
struct IsBlock : std::bool_constant<std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>> {};
template <class Scalar, int rows, int columns>
struct IsBlock<Eigen::Matrix<Scalar, rows, columns>>
    : std::bool_constant<rows != Eigen::Dynamic && columns != Eigen::Dynamic> {
    static_assert(rows == Eigen::Dynamic || columns == Eigen::Dynamic ||
                  sizeof(Eigen::Matrix<Scalar, rows, columns>) == rows * columns * sizeof(Scalar));
};
template <class Item, std::size_t count>
struct IsBlock<std::array<Item, count>> : IsBlock<Item> {};

/// Bytes of a default value, the least that any value takes.
template <class Value>
std::size_t leastBytes() {
    if constexpr (IsBlock<Value>::value) return sizeof(Value);
    static const std::size_t size = [] {
        ByteWriter writer;
        Value value{};
        archive(writer, value);
        return writer.bytes().size();
    }();
    return size;
}

template <class Archive>
void archiveOne(Archive& archive, bool& value) {
    auto byte = static_cast<std::uint8_t>(value);
    archive.raw(&byte, 1);
    archive.require(byte <= 1);
    value = byte == 1;
}

template <class Archive>
void archiveOne(Archive& archive, std::string& text) {
    text.resize(archive.count(text.size(), 1));
    archive.raw(text.data(), text.size());
}

template <class Archive, class Scalar, int rows>
void archiveOne(Archive& archive, Eigen::Matrix<Scalar, rows, Eigen::Dynamic>& matrix) {
    static_assert(rows != Eigen::Dynamic);
    const std::size_t column = rows * sizeof(Scalar);
    const auto columns = archive.count(static_cast<std::size_t>(matrix.cols()), column);
    if constexpr (Archive::reads) matrix.resize(rows, static_cast<Eigen::Index>(columns));
    archive.raw(matrix.data(), columns * column);
}

}  // namespace detail

/// A list whose items `each` archives, in `least_bytes` or more.
template <class Archive, class Item, class Each>
void archiveList(Archive& archive, std::vector<Item>& list, std::size_t least_bytes, const Each& each) {
    const std::size_t count = archive.count(list.size(), least_bytes);
    if constexpr (Archive::reads) {
        list.clear();
        list.resize(count);
    }
    for (Item& item : list) each(item);
}

namespace detail {

template <class Archive, class Item, class Allocator>
void archiveOne(Archive& to_or_from, std::vector<Item, Allocator>& list) {
    if constexpr (IsBlock<Item>::value) {
        const std::size_t count = to_or_from.count(list.size(), sizeof(Item));
        if constexpr (Archive::reads) list.resize(count);
        to_or_from.raw(list.data(), count * sizeof(Item));
    } else {
        archiveList(to_or_from, list, leastBytes<Item>(), [&](Item& item) { archive(to_or_from, item); });
    }
}

template <class Archive, class Value>
auto archiveOne(Archive& archive, Value& value) -> decltype(archiveFields(archive, value)) {
    return archiveFields(archive, value);
}

}  // namespace detail

/// Writes a value, or reads it. Structs say how with `archiveFields`.
template <class Archive, class Value>
void archive(Archive& archive, Value& value) {
    if constexpr (detail::IsBlock<Value>::value)
        archive.raw(&value, sizeof value);
    else
        detail::archiveOne(archive, value);
}

/// An enum whose values are 0 ... count - 1.
template <class Archive, class Enum>
void archiveEnum(Archive& archive, Enum& value, std::size_t count) {
    auto number = static_cast<std::uint8_t>(value);
    archive.raw(&number, 1);
    archive.require(number < count);
    if (number < count) value = static_cast<Enum>(number);
}

}  // namespace sherd
