#include <algorithm>
#include <filesystem>

#include "core/parameters/faults.h"
#include "io/material_entry.h"

namespace sherd {

namespace {

namespace fs = std::filesystem;

/// Where names of files start from, and the files that are being read, to see one that is like itself.
struct Place {
    std::string folder;
    std::vector<std::string> files = {};
};

Material describedBy(const JsonEntry& entry, const Place& place, Missing missing);

Material ofFile(const std::string& path, Place place, Missing missing) {
    if (std::find(place.files.begin(), place.files.end(), path) != place.files.end())
        throw BadEntry{path + " is \"like\" itself; give its fields, or another material."};
    place.files.push_back(path);
    place.folder = fs::path(path).parent_path().string();
    auto read =
        readJson<Material>(path, [&](const JsonEntry& entry) { return describedBy(entry, place, missing); });
    if (!read) throw BadEntry{read.error()};
    return std::move(read).value();
}

Material called(const JsonEntry& entry, const Place& place, Missing missing) {
    const std::string name = entry.text();
    if (fs::path(name).extension() == ".json")
        return ofFile((fs::path(place.folder) / name).lexically_normal().string(), place, missing);
    const Result<Material> known = Material::named(name);
    if (known) return known.value();
    throw BadEntry{(entry.path().empty() ? "" : entry.path() + ": ") + known.error() +
                   " Or give the constants in braces, or a file of them that ends in .json."};
}

Material describedBy(const JsonEntry& entry, const Place& place, Missing missing) {
    const bool complete = entry.has("like");
    Material material = complete ? called(entry["like"], place, missing) : Material();
    // A key that is spelt wrongly is often one that is missing then.
    std::vector<std::string> keys = keysOf(material);
    keys.insert(keys.begin(), "like");
    entry.allowOnly(keys);
    FieldReader reader(entry, complete ? Missing::any : missing,
                       ", or the material that gives it as \"like\"");
    visitFields(material, reader);
    const std::string fault = faultOf(material);
    if (!fault.empty()) throw BadEntry{entry.pathOf(fault) + "."};
    return material;
}

}  // namespace

Material materialOf(const JsonEntry& entry, const std::string& folder, Missing missing) {
    return entry.isText() ? called(entry, {folder}, missing) : describedBy(entry, {folder}, missing);
}

Result<Material> Material::fromJsonFile(const std::string& path) {
    return resultOf("", [&] { return ofFile(path, {}, Missing::but_to_break); });
}

Result<Material> Material::fromJson(const std::string& text, const std::string& key,
                                    const std::string& folder) {
    return resultOf("", [&] {
        const nlohmann::json value = parseJsonText(text);
        return materialOf(JsonEntry(value, key), folder, Missing::but_to_break);
    });
}

std::string Material::toJson() const {
    return writtenJson(jsonOf(*this), 2);
}

}  // namespace sherd
