#include <sherd/settings.h>

#include <algorithm>

#include "core/parameters/faults.h"
#include "io/json_fields.h"

namespace sherd {

namespace {

using nlohmann::json;

/// Lays what an object says over the settings.
void layOver(Settings& settings, const JsonEntry& entry, Missing missing,
             std::vector<std::string> other_keys) {
    FieldReader reader(entry, missing);
    visitFields(settings, reader);
    other_keys.insert(other_keys.end(), reader.names().begin(), reader.names().end());
    entry.allowOnly(other_keys);
    const std::string fault = faultOf(settings);
    if (!fault.empty()) throw BadEntry{entry.pathOf(fault) + "."};
}

Settings settingsOf(const JsonEntry& entry) {
    Quality quality = Quality::game;
    FieldReader start(entry, Missing::any);
    start(Field{"quality", "where the settings start from"}, quality);
    Settings settings = Settings::forQuality(quality);
    layOver(settings, entry, Missing::but_to_break, start.names());
    return settings;
}

/// {"sampling": {"spacing_m": 0.02}} of "sampling.spacing_m=0.02". A value that is no JSON counts as text.
void assign(json& object, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    const std::string path = assignment.substr(0, equals);
    if (equals == std::string::npos || path.empty())
        throw BadEntry{"'" + assignment + "' is not PATH=VALUE."};
    json* at = &object;
    for (std::size_t from = 0; from <= path.size();) {
        const std::size_t dot = std::min(path.find('.', from), path.size());
        if (!at->is_object() && !at->is_null())
            throw BadEntry{path + " leads through a value that has no keys."};
        at = &(*at)[path.substr(from, dot - from)];
        from = dot + 1;
    }
    const std::string value = assignment.substr(equals + 1);
    json parsed = json::parse(value, nullptr, false);
    *at = parsed.is_discarded() ? json(value) : std::move(parsed);
}

}  // namespace

Result<Settings> Settings::fromJsonFile(const std::string& path) {
    return readJson<Settings>(path, settingsOf);
}

Result<Settings> Settings::fromJson(const std::string& text, const std::string& key) {
    return resultOf("", [&] {
        const json value = parseJsonText(text);
        return settingsOf(JsonEntry(value, key));
    });
}

std::string Settings::toJson() const {
    return writtenJson(jsonOf(*this), 2);
}

Status Settings::set(const std::vector<std::string>& assignments) {
    return resultOf("", [&] {
        json changes = json::object();
        for (const std::string& assignment : assignments) assign(changes, assignment);
        Settings changed = *this;
        layOver(changed, JsonEntry(changes, ""), Missing::any, {});
        *this = std::move(changed);
        return std::monostate();
    });
}

}  // namespace sherd
