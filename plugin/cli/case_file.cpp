#include "case_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>

namespace sherd::cli {

namespace {

using nlohmann::json;

/// A case that cannot be read; caught in `readCase`.
struct BadCase {
    std::string sentence;
};

/// A value of the file and the key it has there: "loads[1].region.sphere".
class Entry {
  public:
    Entry(const json& value, std::string key) : value_(value), key_(std::move(key)) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw BadCase{(key_.empty() ? "the file" : "\"" + key_ + "\"") + " " + what + "."};
    }

    bool has(const char* name) const { return value_.contains(name); }

    Entry operator[](const char* name) const {
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
        for (const std::string& key : keysBeside(names)) fail("has the unknown key \"" + key + "\"; known are " + list);
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
        for (int i = 0; i < 3; ++i) v[i] = Entry(value_[i], item(i)).number();
        return v;
    }

    std::vector<Entry> list() const {
        if (!value_.is_array()) fail("must be a list");
        std::vector<Entry> entries;
        for (std::size_t i = 0; i < value_.size(); ++i) entries.emplace_back(value_[i], item(i));
        return entries;
    }

  private:
    std::string item(std::size_t i) const { return key_ + "[" + std::to_string(i) + "]"; }

    const json& value_;
    std::string key_;
};

SurfaceRegion region(const Entry& entry) {
    entry.allowOnly({"sphere", "box", "cylinder"});
    if (entry.has("sphere") + entry.has("box") + entry.has("cylinder") != 1)
        entry.fail("must be one of sphere, box and cylinder");
    if (entry.has("sphere")) {
        const Entry sphere = entry["sphere"];
        sphere.allowOnly({"centre", "radius"});
        return SphereRegion{sphere["centre"].vector(), sphere["radius"].number()};
    }
    if (entry.has("box")) {
        const Entry box = entry["box"];
        box.allowOnly({"lo", "hi"});
        return BoxRegion{box["lo"].vector(), box["hi"].vector()};
    }
    const Entry cylinder = entry["cylinder"];
    cylinder.allowOnly({"point", "axis", "radius"});
    return CylinderRegion{cylinder["point"].vector(), cylinder["axis"].vector(), cylinder["radius"].number()};
}

SurfaceLoad load(const Entry& entry) {
    entry.allowOnly({"region", "force_n", "pressure_pa"});
    if (entry.has("force_n") == entry.has("pressure_pa"))
        entry.fail("must have either force_n (the total, three numbers) or pressure_pa");
    SurfaceLoad load;
    load.region = region(entry["region"]);
    if (entry.has("force_n")) load.force_n = entry["force_n"].vector();
    if (entry.has("pressure_pa")) load.pressure_pa = entry["pressure_pa"].number();
    return load;
}

SurfaceRegion support(const Entry& entry) {
    entry.allowOnly({"region"});
    return region(entry["region"]);
}

Material material(const Entry& entry) {
    Material material;
    material.youngs_modulus_pa = entry["youngs_modulus_pa"].number();
    material.poisson_ratio = entry["poisson_ratio"].number();
    material.density_kg_m3 = entry["density_kg_m3"].number();
    if (const Status valid = material.validate(); !valid) throw BadCase{valid.error()};
    return material;
}

StressCase stressCase(const Entry& entry, const std::filesystem::path& folder) {
    StressCase read;
    // These four are for people.
    read.unknown_keys = entry.keysBeside({"name", "description", "smallest_thickness_m", "reference",  //
                                          "mesh", "material", "loads", "supports", "spin_rad_s"});
    if (entry.has("name")) read.name = entry["name"].text();
    read.mesh = (folder / entry["mesh"].text()).string();
    read.material = material(entry["material"]);
    for (const Entry& item : entry["loads"].list()) read.loads.push_back(load(item));
    if (entry.has("supports"))
        for (const Entry& item : entry["supports"].list()) read.supports.push_back(support(item));
    if (entry.has("spin_rad_s")) read.spin_rad_s = entry["spin_rad_s"].vector();
    if (read.loads.empty() && read.spin_rad_s.isZero(0))
        entry["loads"].fail("is empty and there is no spin_rad_s, so nothing loads the body");
    return read;
}

}  // namespace

Result<StressCase> readCase(const std::string& path) {
    std::ifstream in(path);
    if (!in || std::filesystem::is_directory(path)) return Error{path + ": the case file cannot be opened."};
    try {
        return stressCase(Entry(json::parse(in), ""), std::filesystem::path(path).parent_path());
    } catch (const BadCase& bad) {
        return Error{path + ": " + bad.sentence};
    } catch (const json::exception& error) {
        return Error{path + ": this is not JSON: " + error.what()};
    }
}

}  // namespace sherd::cli
