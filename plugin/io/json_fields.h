#pragma once

#include <sherd/fields.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/json_entry.h"

namespace sherd {

/// Which fields an object may leave out.
enum class Missing {
    any,           ///< they keep the values that they have
    but_needed,    ///< all but those that every use needs
    but_to_break,  ///< all but those that a body needs that can break
};

inline bool mayBeMissing(InFile in_file, Missing missing) {
    if (in_file == InFile::needed) return missing == Missing::any;
    return in_file != InFile::needed_to_break || missing != Missing::but_to_break;
}

/// Takes over what a JSON object says of a struct with fields. Ranges are left to `faultOf`.
class FieldReader {
  public:
    /// `where_else`: how a needed field can be given otherwise, goes on from "is missing; give it".
    FieldReader(const JsonEntry& object, Missing missing, std::string where_else = "")
        : object_(object), missing_(missing), where_else_(std::move(where_else)) {
        object.requireObject();
    }

    template <class Value>
    void operator()(const Field& field, Value& value) {
        if (field.in_file == InFile::never) return;
        names_.emplace_back(field.name);
        if (object_.has(field.name))
            take(object_[field.name], field, value);
        else if (!mayBeMissing(field.in_file, missing_))
            throw BadEntry{object_.pathOf(field.name) + " is missing; " + remedy(field, value) + "."};
    }

    /// The keys that were asked for.
    const std::vector<std::string>& names() const { return names_; }

  private:
    template <class Value>
    std::string remedy(const Field& field, const Value& value) const {
        if (std::is_enum_v<Value>) return "choose one of: " + possibleValues(field, value);
        return "give it" + where_else_;
    }

    template <class Value>
    void take(const JsonEntry& entry, const Field& field, Value& value) const {
        if constexpr (has_fields<Value>) {
            FieldReader reader(entry, missing_);
            visitFields(value, reader);
            entry.allowOnly(reader.names());
        } else if constexpr (std::is_enum_v<Value>) {
            const std::string name = entry.text();
            const auto named = valueNamed<Value>(name);
            if (!named) entry.fail("is \"" + name + "\"; choose one of: " + possibleValues(field, value));
            value = *named;
        } else if constexpr (std::is_same_v<Value, double>) {
            const bool infinite =
                std::isinf(field.range.special) && entry.isText() && entry.text() == "infinity";
            value = infinite ? field.range.special : entry.number();
        } else if constexpr (std::is_same_v<Value, int>) {
            value = entry.wholeNumber();
        } else if constexpr (std::is_same_v<Value, bool>) {
            value = entry.truth();
        } else if constexpr (std::is_same_v<Value, std::string>) {
            value = entry.text();
            if (!isAmong(field.names, value))
                entry.fail("is \"" + value + "\"; choose one of: " + listOf(field.names));
        } else if constexpr (std::is_same_v<Value, Vec3>) {
            value = entry.vector();
        } else {
            static_assert(std::is_same_v<Value, std::uint64_t>, "no JSON is known for this type");
            value = entry.naturalNumber();
        }
    }

    const JsonEntry& object_;
    Missing missing_;
    std::string where_else_;
    std::vector<std::string> names_;
};

/// The keys of a struct's fields.
template <class Struct>
std::vector<std::string> keysOf(const Struct& described) {
    std::vector<std::string> keys;
    visitFields(described, [&](const Field& field, const auto&) {
        if (field.in_file != InFile::never) keys.emplace_back(field.name);
    });
    return keys;
}

/// All fields of a struct that a file can give, in their order.
template <class Struct>
nlohmann::ordered_json jsonOf(const Struct& described) {
    nlohmann::ordered_json object;
    visitFields(described, [&](const Field& field, const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if (field.in_file == InFile::never) return;
        auto& entry = object[field.name];
        if constexpr (has_fields<Value>)
            entry = jsonOf(value);
        else if constexpr (std::is_enum_v<Value>)
            entry = nameOf(value);
        else if constexpr (std::is_same_v<Value, Vec3>)
            entry = {value.x(), value.y(), value.z()};
        else
            entry = value;
        if constexpr (std::is_same_v<Value, double>)
            if (std::isinf(value)) entry = "infinity";
    });
    return object;
}

}  // namespace sherd
