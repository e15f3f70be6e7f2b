#include "scenes/library_fields.h"

#include <utility>

namespace demo {
namespace {

/// The library's sentences begin with the path of the key.
template <class Value>
Value valueOf(sherd::Result<Value> result) {
    if (!result) throw BadKey{result.error()};
    return std::move(result).value();
}

}  // namespace

void readMaterial(Fields& body, sherd::Material& material, const std::string& folder) {
    const nlohmann::json* found = body.find("material");
    if (!found) body.fail("material", "is missing; give the name of one, or its constants in braces");
    material = valueOf(sherd::Material::fromJson(found->dump(), body.pathOf("material"), folder));
}

void readSettings(Fields& body, sherd::Settings& settings, std::uint64_t seed) {
    const nlohmann::json* found = body.find("settings");
    nlohmann::json given = found ? *found : nlohmann::json::object();
    if (given.is_object()) {
        for (const char* part : {"strength", "fracture"}) {
            nlohmann::json& settings_part = given[part];
            if (settings_part.is_null()) settings_part = nlohmann::json::object();
            if (settings_part.is_object()) settings_part.emplace("seed", seed);
        }
    }
    settings = valueOf(sherd::Settings::fromJson(given.dump(), body.pathOf("settings")));
}

}  // namespace demo
