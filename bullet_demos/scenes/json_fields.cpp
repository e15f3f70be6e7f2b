#include "scenes/json_fields.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace demo {
namespace {

using nlohmann::json;

std::string text(const Range& range) {
    std::ostringstream out;
    const bool below = std::isfinite(range.least), above = std::isfinite(range.most);
    if (below && above) out << "between " << range.least << " and " << range.most;
    if (below && !above) out << "at least " << range.least;
    if (!below && above) out << "at most " << range.most;
    if (!below && !above) out << "finite";
    out << (*range.unit ? " " : "") << range.unit;
    return out.str();
}

/// Whether the number is in the range; not a number is in none.
bool isWithin(double value, const Range& range) {
    return std::isfinite(value) && value >= range.least && value <= range.most;
}

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

void Fields::read(const char* name, double& value, const Range& range) {
    const json* found = find(name);
    if (!found) return;
    if (!found->is_number()) fail(name, "must be a number, not " + found->dump());
    if (!isWithin(found->get<double>(), range))
        fail(name, "is " + found->dump() + " but must be " + text(range));
    value = found->get<double>();
}

void Fields::read(const char* name, int& value, const Range& range) {
    const json* found = find(name);
    if (!found) return;
    if (!found->is_number_integer()) fail(name, "must be a whole number, not " + found->dump());
    constexpr double limit = std::numeric_limits<int>::max();
    const Range whole{std::max(range.least, -limit), std::min(range.most, limit), range.unit};
    if (!isWithin(found->get<double>(), whole))
        fail(name, "is " + found->dump() + " but must be " + text(whole));
    value = found->get<int>();
}

void Fields::read(const char* name, bool& value) {
    const json* found = find(name);
    if (!found) return;
    if (!found->is_boolean()) fail(name, "must be true or false, not " + found->dump());
    value = found->get<bool>();
}

void Fields::read(const char* name, std::string& value) {
    const json* found = find(name);
    if (!found) return;
    if (!found->is_string()) fail(name, "must be text in quotes, not " + found->dump());
    value = found->get<std::string>();
}

void Fields::read(const char* name, sherd::Vec3& value, const Range& range) {
    const json* found = find(name);
    if (!found) return;
    const auto is_number = [](const json& item) { return item.is_number(); };
    if (!found->is_array() || found->size() != 3 || !std::all_of(found->begin(), found->end(), is_number))
        fail(name, "must be a list of three numbers, not " + found->dump());
    for (int axis = 0; axis < 3; ++axis) {
        const double component = (*found)[axis].get<double>();
        if (!isWithin(component, range))
            fail(std::string(name) + "[" + std::to_string(axis) + "]",
                 "is " + (*found)[axis].dump() + " but must be " + text(range));
        value[axis] = component;
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
