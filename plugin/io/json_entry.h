#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sherd {

/// A file that cannot be used, thrown by JsonEntry.
struct BadEntry {
    std::string sentence;
};

/// A value of the file and the key it has there: "loads[1].region.sphere".
class JsonEntry {
  public:
    JsonEntry(const nlohmann::json& value, std::string key) : value_(value), key_(std::move(key)) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw BadEntry{(key_.empty() ? "the file" : "\"" + key_ + "\"") + " " + what + "."};
    }

    bool has(const char* name) const { return value_.contains(name); }

    JsonEntry operator[](const char* name) const {
        if (!value_.is_object()) fail("must be an object");
        const auto found = value_.find(name);
        if (found == value_.end()) fail(std::string("lacks the key \"") + name + "\"");
        return {*found, key_.empty() ? name : key_ + "." + name};
    }

    std::vector<std::string> keysBeside(std::initializer_list<const char*> names) const {
        if (!value_.is_object()) fail("must be an object");
        std::vector<std::string> keys;
        for (const auto& item : value_.items())
            if (std::find(names.begin(), names.end(), item.key()) == names.end()) keys.push_back(item.key());
        return keys;
    }

    void allowOnly(std::initializer_list<const char*> names) const {
        std::string list;
        for (const char* name : names) list += (list.empty() ? "" : ", ") + std::string(name);
        for (const std::string& key : keysBeside(names))
            fail("has the unknown key \"" + key + "\"; known are " + list);
    }

    double number() const {
        if (!value_.is_number()) fail("must be a number");
        const double number = value_.get<double>();
        if (!std::isfinite(number)) fail("must be finite");
        return number;
    }

    std::string text() const {
        if (!value_.is_string()) fail("must be a string");
        return value_.get<std::string>();
    }

    Vec3 vector() const {
        if (!value_.is_array() || value_.size() != 3) fail("must be a list of three numbers");
        Vec3 v;
        for (int i = 0; i < 3; ++i) v[i] = JsonEntry(value_[i], item(i)).number();
        return v;
    }

    std::vector<JsonEntry> list() const {
        if (!value_.is_array()) fail("must be a list");
        std::vector<JsonEntry> entries;
        for (std::size_t i = 0; i < value_.size(); ++i) entries.emplace_back(value_[i], item(i));
        return entries;
    }

  private:
    std::string item(std::size_t i) const { return key_ + "[" + std::to_string(i) + "]"; }

    const nlohmann::json& value_;
    std::string key_;
};

/// Reads a JSON file with `make`, which takes its root as JsonEntry. The error names the file, the key and
/// what is wrong.
template <class Value, class Make>
Result<Value> readJson(const std::string& path, const Make& make) {
    std::ifstream in(path);
    if (!in || std::filesystem::is_directory(path)) return Error{path + ": the file cannot be opened."};
    try {
        const nlohmann::json root = nlohmann::json::parse(in);
        return make(JsonEntry(root, ""));
    } catch (const BadEntry& bad) {
        return Error{path + ": " + bad.sentence};
    } catch (const nlohmann::json::exception& error) {
        return Error{path + ": this is not JSON: " + error.what()};
    }
}

}  // namespace sherd
