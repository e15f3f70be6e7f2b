#include "viewer/choices.h"

#include <filesystem>

namespace demo {
namespace {

sherd::Status setMaterial(BreakableBody& body, const std::string& name) {
    auto material = sherd::Material::named(name);
    if (!material) return sherd::Error{material.error()};
    body.material = std::move(material).value();
    body.look = lookOf(body.material);
    return sherd::success();
}

}  // namespace

bool Choices::isScene() const {
    return std::filesystem::path(file).extension() == ".json";
}

sherd::Status chooseMaterials(Scene& scene, const Choices& choices) {
    for (BreakableBody& body : scene.bodies) {
        if (!choices.material.empty()) {
            const sherd::Status set = setMaterial(body, choices.material);
            if (!set) return set;
        }
        body.material.tensile_strength_pa *= double(choices.strength_factor);
        if (!choices.quality) continue;
        const sherd::Settings fresh = sherd::Settings::forQuality(*choices.quality);
        body.settings.sampling = fresh.sampling;
        body.settings.stress = fresh.stress;
    }
    return sherd::success();
}

void chooseFracture(Scene& scene, const Choices& choices) {
    for (BreakableBody& body : scene.bodies) {
        sherd::FractureSettings& fracture = body.settings.fracture;
        if (choices.fragment_count) fracture.fragment_count = *choices.fragment_count;
        if (choices.guide) fracture.guide.kind = *choices.guide;
        if (choices.seed != 1) fracture.seed = choices.seed;
    }
}

const std::vector<std::string>& materialNames() {
    static const std::vector<std::string> names = {"ceramic", "plaster", "glass", "concrete",
                                                   "brick",   "stone",   "ice",   "wood"};
    return names;
}

}  // namespace demo
