#pragma once

#include <sherd/fields.h>
#include <sherd/types.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace demo {

using sherd::Field;
using sherd::Range;

/// A key or a value of a scene file that cannot be taken, as a sentence that begins with the path of the key.
/// Thrown by what reads the parts of a scene, caught in `readScene`.
struct BadKey {
    std::string sentence;
};

/// An object of a scene file. Every `read` takes over what the object says and leaves the value alone where
/// it says nothing; the keys that were asked for are those there are.
class Fields {
  public:
    Fields(const nlohmann::json& object, std::string path);

    bool has(const char* name) const { return object_.contains(name); }
    std::string pathOf(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }
    const std::string& path() const { return path_; }

    /// A number, a text, three numbers, the name of an enum's value, or an object with the fields of a struct
    /// (`visitFields`).
    template <class Value>
    void read(const Field& field, Value& value) {
        if constexpr (sherd::has_fields<Value>)
            object(field.name, [&](Fields& part) { part.readAll(value); });
        else
            readValue(field, value);
    }

    /// All fields of a struct.
    template <class Struct>
    void readAll(Struct& fields) {
        visitFields(fields, [&](const Field& field, auto& value) { read(field, value); });
    }

    /// Calls `read_part(Fields&)` on the object of that name, if there is one.
    template <class Read>
    void object(const char* name, const Read& read_part) {
        if (const nlohmann::json* part = find(name)) readObject(*part, pathOf(name), read_part);
    }

    /// Calls `read_item(Fields&)` on every object in the list of that name, if there is one.
    template <class Read>
    void list(const char* name, const Read& read_item) {
        const nlohmann::json* items = find(name);
        if (!items) return;
        if (!items->is_array()) fail(name, "must be a list in brackets, not " + items->dump());
        for (std::size_t i = 0; i < items->size(); ++i)
            readObject((*items)[i], pathOf(name) + "[" + std::to_string(i) + "]", read_item);
    }

    /// The value of that name as it stands; nullptr if there is none.
    const nlohmann::json* find(const char* name);

    /// Calls `read_part(Fields&)` on an object and refuses keys that it did not ask for.
    template <class Read>
    static void readObject(const nlohmann::json& object, const std::string& path, const Read& read_part) {
        Fields fields(object, path);
        read_part(fields);
        fields.refuseUnknown();
    }

    /// `what` goes on from the path of the key and has no full stop.
    [[noreturn]] void fail(const std::string& name, const std::string& what) const;

  private:
    void readValue(const Field& field, double& value);
    void readValue(const Field& field, int& value);
    void readValue(const Field& field, std::uint64_t& value);
    void readValue(const Field& field, std::string& value);
    void readValue(const Field& field, sherd::Vec3& value);
    template <class Enum>
    std::enable_if_t<std::is_enum_v<Enum>> readValue(const Field& field, Enum& value) {
        std::string name = sherd::nameOf(value);
        readValue(field, name);
        const auto named = sherd::valueNamed<Enum>(name);
        if (!named)
            fail(field.name, "is \"" + name + "\"; choose one of: " + sherd::possibleValues(field, value));
        value = *named;
    }
    void refuseUnknown() const;
    void requireWithin(const std::string& name, const nlohmann::json& number, const Range& range) const;

    const nlohmann::json& object_;
    std::string path_;
    std::vector<std::string> known_;
};

}  // namespace demo
