#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sherd {

/// A value that cannot be used, as a sentence. Thrown by JsonEntry, caught by readJson.
struct BadEntry {
    std::string sentence;
};

/// A JSON value and its path: "loads[1].region.sphere". What cannot be used is thrown as BadEntry, in a
/// sentence that begins with the path.
class JsonEntry {
  public:
    /// An empty path: the whole, which sentences call "the JSON". The value has to outlive the entry.
    JsonEntry(const nlohmann::json& value, std::string path) : value_(value), path_(std::move(path)) {}

    /// `what` goes on from the path and has no full stop.
    [[noreturn]] void fail(const std::string& what) const;

    const std::string& path() const { return path_; }
    std::string pathOf(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }
    bool has(const char* name) const { return value_.contains(name); }
    bool isText() const { return value_.is_string(); }

    /// Refuses what is no object.
    void requireObject() const;

    JsonEntry operator[](const char* name) const;

    /// The keys of an object that are not among `names`.
    std::vector<std::string> keysBeside(const std::vector<std::string>& names) const;

    /// Refuses other keys than these.
    void allowOnly(const std::vector<std::string>& names) const;

    double number() const;
    int wholeNumber() const;
    std::uint64_t naturalNumber() const;
    bool truth() const;
    std::string text() const;
    Vec3 vector() const;
    std::vector<JsonEntry> list() const;

    /// The value as sentences show it.
    std::string shown() const;

  private:
    std::string item(std::size_t i) const { return path_ + "[" + std::to_string(i) + "]"; }

    const nlohmann::json& value_;
    std::string path_;
};

/// The JSON of a file or of a text; comments (`//`, `/* */`) are allowed. Throws BadEntry.
nlohmann::json parseJsonFile(const std::string& path);
nlohmann::json parseJsonText(const std::string& text);

/// The text of a value; bytes that are not UTF-8 are replaced rather than thrown for.
template <class Json>
std::string writtenJson(const Json& value, int indent) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Calls `make`, which may throw BadEntry, and sets `before` in front of its sentence.
template <class Make>
auto resultOf(const std::string& before, const Make& make) -> Result<decltype(make())> {
    try {
        return make();
    } catch (const BadEntry& bad) {
        return Error{before + bad.sentence};
    }
}

/// Reads a JSON file with `make`, which takes its root as JsonEntry. The error names the file, the key and
/// what is wrong.
template <class Value, class Make>
Result<Value> readJson(const std::string& path, const Make& make) {
    return resultOf(path + ": ", [&]() -> Value {
        const nlohmann::json root = parseJsonFile(path);
        return make(JsonEntry(root, ""));
    });
}

}  // namespace sherd
