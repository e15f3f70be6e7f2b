#pragma once

#include <sherd/enum_names.h>
#include <sherd/types.h>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace sherd {

/// The numbers that a field takes. Infinity is one only as the special value, NaN never.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool open_below = false;  ///< `least` itself is out of range
    bool open_above = false;  ///< `most` itself is out of range
    double step = 0;          ///< least, least + step, ... up to most; 0: all between
    /// One more number that is taken, with a meaning of its own ("0: chosen from the wall thickness"); NaN:
    /// there is none.
    double special = std::numeric_limits<double>::quiet_NaN();
    const char* special_meaning = "";
    const char* unit = "";
    const char* remark = "";  ///< what the number is, as "fraction of the wall thickness"

    static constexpr Range positive(const char* unit = "") {
        Range range = atLeast(0, unit);
        range.open_below = true;
        return range;
    }
    static constexpr Range atLeast(double least, const char* unit = "") {
        return between(least, std::numeric_limits<double>::infinity(), unit);
    }
    static constexpr Range between(double least, double most, const char* unit = "") {
        Range range;
        range.least = least;
        range.most = most;
        range.unit = unit;
        return range;
    }
    /// Above 0 and at most 1.
    static constexpr Range fractionOf(const char* remark) {
        Range range = between(0, 1).with(remark);
        range.open_below = true;
        return range;
    }

    constexpr Range inSteps(double of) const {
        Range range = *this;
        range.step = of;
        return range;
    }
    constexpr Range orSpecial(double value, const char* meaning) const {
        Range range = *this;
        range.special = value;
        range.special_meaning = meaning;
        return range;
    }
    constexpr Range with(const char* other_remark) const {
        Range range = *this;
        range.remark = other_remark;
        return range;
    }

    bool allows(double value) const;

    /// The numbers in words that go on from "must be": "0 (none) or between 1 and 1000", "positive, in Pa".
    std::string text() const;
};

/// Whether a file that describes a struct gives a field of it.
enum class InFile {
    optional,         ///< where it does not, the field keeps its default
    needed,           ///< it has to
    needed_to_break,  ///< it has to, unless the body is only to be stressed
    never,            ///< it cannot: the library sets the field from others
};

/// One field of a struct, but for its value.
struct Field {
    const char* name;  ///< of the member, and the key in JSON
    const char* meaning;
    Range range = {};  ///< of a number, or of each of three
    InFile in_file = InFile::optional;
    std::vector<std::string> names = {};  ///< of a text: the choices there are; empty: any text
};

/// "linear, quadratic, cubic".
std::string listOf(const std::vector<std::string>& names);

/// Whether a text is one of the names; any is if there are none.
bool isAmong(const std::vector<std::string>& names, const std::string& text);

/// What a field takes, in words: "positive, in Pa", "linear, quadratic, cubic", "true or false".
template <class Value>
std::string possibleValues(const Field& field, const Value&) {
    if constexpr (std::is_enum_v<Value>) return listOf(namesInFiles<Value>());
    if constexpr (std::is_same_v<Value, bool>) return "true or false";
    if constexpr (std::is_same_v<Value, std::string>)
        return field.names.empty() ? "text" : listOf(field.names);
    if constexpr (std::is_same_v<Value, Vec3>)
        return std::isinf(field.range.most) ? "three numbers" : "three numbers, each " + field.range.text();
    if constexpr (std::is_arithmetic_v<Value>) return field.range.text();
    return "";
}

}  // namespace sherd
