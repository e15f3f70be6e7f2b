#include <sherd/material.h>

#include "io/json_entry.h"

namespace sherd {

namespace {

Material materialOf(const JsonEntry& entry) {
    entry.allowOnly({"name", "like", "youngs_modulus_pa", "poisson_ratio", "density_kg_m3",
                     "tensile_strength_pa", "fracture_energy_j_m2", "strength_scatter",
                     "compressive_strength_pa", "weibull_modulus", "weibull_volume_m3", "failure_criterion"});
    Material material;
    const bool complete = entry.has("like");
    if (complete) {
        const Result<Material> like = Material::named(entry["like"].text());
        if (!like) throw BadEntry{like.error()};
        material = like.value();
    }
    if (entry.has("name")) material.name = entry["name"].text();
    const auto read = [&](const char* key, double& value, bool needed) {
        if (needed && !entry.has(key))
            entry.fail(std::string("lacks the key \"") + key +
                       "\"; give it, or the material that gives it as \"like\"");
        if (needed || entry.has(key)) value = entry[key].number();
    };
    read("youngs_modulus_pa", material.youngs_modulus_pa, !complete);
    read("poisson_ratio", material.poisson_ratio, !complete);
    read("density_kg_m3", material.density_kg_m3, !complete);
    read("tensile_strength_pa", material.tensile_strength_pa, !complete);
    read("fracture_energy_j_m2", material.fracture_energy_j_m2, !complete);
    read("strength_scatter", material.strength_scatter, false);
    read("compressive_strength_pa", material.compressive_strength_pa, false);
    read("weibull_modulus", material.weibull_modulus, false);
    read("weibull_volume_m3", material.weibull_volume_m3, false);
    if (entry.has("failure_criterion")) material.failure_criterion = entry["failure_criterion"].text();
    if (const Status valid = material.validate(); !valid) throw BadEntry{valid.error()};
    return material;
}

}  // namespace

Result<Material> Material::fromJson(const std::string& path) {
    return readJson<Material>(path, materialOf);
}

}  // namespace sherd
