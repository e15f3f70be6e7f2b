#include "scenes/json_fields.h"

#include <algorithm>
#include <limits>

namespace demo {
namespace {

using nlohmann::json;

constexpr Range whole_numbers =
    Range::between(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());

}  // namespace

Fields::Fields(const json& object, std::string path) : object_(object), path_(std::move(path)) {
    if (!object.is_object())
        throw BadKey{(path_.empty() ? "the file" : path_) + " must be an object in braces, not " +
                     object.dump() + "."};
}

void Fields::fail(const std::string& name, const std::string& what) const {
    throw BadKey{pathOf(name) + " " + what + "."};
}

const json* Fields::find(const char* name) {
    known_.emplace_back(name);
    const auto found = object_.find(name);
    return found == object_.end() ? nullptr : &*found;
}

void Fields::requireWithin(const std::string& name, const json& number, const Range& range) const {
    if (!range.allows(number.get<double>()))
        fail(name, "is " + number.dump() + " but must be " + range.text());
}

void Fields::readValue(const Field& field, double& value) {
    const json* found = find(field.name);
    if (!found) return;
    if (!found->is_number()) fail(field.name, "must be a number, not " + found->dump());
    requireWithin(field.name, *found, field.range);
    value = found->get<double>();
}

void Fields::readValue(const Field& field, int& value) {
    const json* found = find(field.name);
    if (!found) return;
    if (!found->is_number_integer()) fail(field.name, "must be a whole number, not " + found->dump());
    requireWithin(field.name, *found, field.range);
    requireWithin(field.name, *found, whole_numbers);
    value = found->get<int>();
}

void Fields::readValue(const Field& field, std::uint64_t& value) {
    const json* found = find(field.name);
    if (!found) return;
    if (!found->is_number_integer()) fail(field.name, "must be a whole number, not " + found->dump());
    requireWithin(field.name, *found, field.range);
    value = found->get<std::uint64_t>();
}

void Fields::readValue(const Field& field, std::string& value) {
    const json* found = find(field.name);
    if (!found) return;
    if (!found->is_string()) fail(field.name, "must be text in quotes, not " + found->dump());
    value = found->get<std::string>();
}

void Fields::readValue(const Field& field, sherd::Vec3& value) {
    const json* found = find(field.name);
    if (!found) return;
    const auto is_number = [](const json& item) { return item.is_number(); };
    if (!found->is_array() || found->size() != 3 || !std::all_of(found->begin(), found->end(), is_number))
        fail(field.name, "must be a list of three numbers, not " + found->dump());
    for (int axis = 0; axis < 3; ++axis) {
        requireWithin(field.name + ("[" + std::to_string(axis) + "]"), (*found)[axis], field.range);
        value[axis] = (*found)[axis].get<double>();
    }
}

void Fields::refuseUnknown() const {
    std::string names;
    for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
    for (const auto& item : object_.items())
        if (std::find(known_.begin(), known_.end(), item.key()) == known_.end())
            fail(item.key(), "is not a key; choose one of: " + names);
}

}  // namespace demo
