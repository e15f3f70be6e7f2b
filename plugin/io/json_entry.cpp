#include "io/json_entry.h"

#include <sherd/fields.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace sherd {

namespace {

using nlohmann::json;

/// Where the text is wrong, and how, without the parser's names for that.
std::string faultOf(const json::exception& error) {
    const std::string what = error.what(), names = "parse error at ";
    const auto place = what.find(names);
    return place == std::string::npos ? what : what.substr(place + names.size());
}

template <class Source>
json parse(Source&& source) {
    try {
        return json::parse(source, nullptr, true, true);
    } catch (const json::exception& error) {
        throw BadEntry{"this is not JSON: " + faultOf(error) + "."};
    }
}

}  // namespace

void JsonEntry::fail(const std::string& what) const {
    throw BadEntry{(path_.empty() ? "the JSON" : path_) + " " + what + "."};
}

void JsonEntry::requireObject() const {
    if (!value_.is_object()) fail("must be an object in braces, not " + shown());
}

JsonEntry JsonEntry::operator[](const char* name) const {
    requireObject();
    const auto found = value_.find(name);
    if (found == value_.end()) throw BadEntry{pathOf(name) + " is missing."};
    return {*found, pathOf(name)};
}

std::vector<std::string> JsonEntry::keysBeside(const std::vector<std::string>& names) const {
    requireObject();
    std::vector<std::string> keys;
    for (const auto& item : value_.items())
        if (std::find(names.begin(), names.end(), item.key()) == names.end()) keys.push_back(item.key());
    return keys;
}

void JsonEntry::allowOnly(const std::vector<std::string>& names) const {
    for (const std::string& key : keysBeside(names))
        throw BadEntry{pathOf(key) + " is not a key; choose one of: " + listOf(names) + "."};
}

double JsonEntry::number() const {
    if (!value_.is_number()) fail("must be a number, not " + shown());
    return value_.get<double>();
}

int JsonEntry::wholeNumber() const {
    if (!value_.is_number_integer()) fail("must be a whole number, not " + shown());
    if (std::abs(value_.get<double>()) > std::numeric_limits<int>::max()) fail("is too large: " + shown());
    return value_.get<int>();
}

std::uint64_t JsonEntry::naturalNumber() const {
    if (!value_.is_number_unsigned()) fail("must be a whole number, 0 or positive, not " + shown());
    return value_.get<std::uint64_t>();
}

bool JsonEntry::truth() const {
    if (!value_.is_boolean()) fail("must be true or false, not " + shown());
    return value_.get<bool>();
}

std::string JsonEntry::text() const {
    if (!value_.is_string()) fail("must be text in quotes, not " + shown());
    return value_.get<std::string>();
}

Vec3 JsonEntry::vector() const {
    if (!value_.is_array() || value_.size() != 3) fail("must be a list of three numbers, not " + shown());
    Vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = JsonEntry(value_[i], item(i)).number();
    return v;
}

std::vector<JsonEntry> JsonEntry::list() const {
    if (!value_.is_array()) fail("must be a list in brackets, not " + shown());
    std::vector<JsonEntry> entries;
    for (std::size_t i = 0; i < value_.size(); ++i) entries.emplace_back(value_[i], item(i));
    return entries;
}

std::string JsonEntry::shown() const {
    // What is nested may be of any depth and length.
    const auto nested = [](const json& item) { return item.is_structured() && !item.empty(); };
    if (value_.is_structured() && (value_.size() > 6 || std::any_of(value_.begin(), value_.end(), nested)))
        return value_.is_array() ? "a longer list" : "a larger object";
    return writtenJson(value_, -1);
}

json parseJsonFile(const std::string& path) {
    std::ifstream in(path);
    if (!in || std::filesystem::is_directory(path)) throw BadEntry{"the file cannot be opened."};
    return parse(in);
}

json parseJsonText(const std::string& text) {
    return parse(text);
}

}  // namespace sherd
