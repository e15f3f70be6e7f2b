#pragma once

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

// Lines, words and numbers of a Wavefront OBJ.

namespace sherd {

inline constexpr std::string_view blanks = " \t\r";

/// Takes the next word off the front of `line`; empty at the end.
inline std::string_view takeWord(std::string_view& line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

inline std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// Takes the first line off the front of `text`, and its end.
inline std::string_view takeLine(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Whether the record goes on in the next line: a backslash is at its end. Comments may end in one by chance.
inline bool goesOn(std::string_view line) {
    line = trimmed(line);
    return !line.empty() && line.back() == '\\' && line.find('#') == std::string_view::npos;
}

/// Takes what is before the next slash off the front of `word`, and the slash.
inline std::string_view takeIndex(std::string_view& word) {
    const std::size_t end = std::min(word.find('/'), word.size());
    const std::string_view index = word.substr(0, end);
    word.remove_prefix(std::min(end + 1, word.size()));
    return index;
}

/// The whole word as a number, whatever the locale; infinite where a double cannot hold it.
template <class Number>
std::optional<Number> parseNumber(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if constexpr (std::is_floating_point_v<Number>)
        if (fault == std::errc::result_out_of_range) return std::numeric_limits<Number>::infinity();
    if (fault != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

}  // namespace sherd
