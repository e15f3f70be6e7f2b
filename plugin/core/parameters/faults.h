#pragma once

#include <sherd/fields.h>

#include <string>
#include <type_traits>
#include <vector>

#include "core/numerics/range_checks.h"

namespace sherd {

/// Rules that join several fields of a struct; none for most.
template <class Struct>
void checkTogether(RangeChecks&, const Struct&) {}
void checkTogether(RangeChecks& checks, const Material& material);
void checkTogether(RangeChecks& checks, const SamplingSettings& sampling);
void checkTogether(RangeChecks& checks, const GuideField& guide);
void checkTogether(RangeChecks& checks, const FractureSettings& fracture);

/// What a field may not be: out of its range, or a text or an enum that is none of its names.
template <class Value>
void checkField(RangeChecks& checks, const Field& field, const Value& value) {
    if constexpr (std::is_same_v<Value, std::string>)
        checks.require(isAmong(field.names, value), field.name, "'" + value + "'",
                       "one of " + listOf(field.names));
    else if constexpr (std::is_same_v<Value, Vec3>)
        for (int axis = 0; axis < 3; ++axis)
            checks.require(field.range.allows(value[axis]), field.name + ("[" + std::to_string(axis) + "]"),
                           value[axis], field.range.text());
    else if constexpr (std::is_enum_v<Value>) {
        std::vector<std::string> names;
        bool is_named = false;
        for (const auto& entry : enum_names<Value>) {
            names.push_back(entry.name);
            is_named = is_named || entry.value == value;
        }
        checks.require(is_named, field.name, static_cast<int>(value), "one of " + listOf(names));
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>)
        checks.require(field.range.allows(static_cast<double>(value)), field.name, value, field.range.text());
}

/// What is wrong with a struct of fields and the structs in it, without its name and without a full stop:
/// "poisson_ratio is 0.5 but must be between 0 and 0.499 (0.5 is incompressible)"; empty if nothing is.
template <class Struct>
std::string faultOf(const Struct& checked) {
    RangeChecks checks("");
    std::string inner;
    visitFields(checked, [&](const Field& field, const auto& value) {
        if constexpr (!has_fields<decltype(value)>)
            checkField(checks, field, value);
        else if (const std::string fault = faultOf(value); inner.empty() && !fault.empty())
            inner = field.name + ("." + fault);
    });
    checkTogether(checks, checked);
    return inner.empty() ? checks.fault() : inner;
}

/// The same as a sentence about `subject`.
template <class Struct>
Status statusOf(const std::string& subject, const Struct& checked) {
    const std::string fault = faultOf(checked);
    return fault.empty() ? success() : Status(Error{subject + ": " + fault + "."});
}

}  // namespace sherd
