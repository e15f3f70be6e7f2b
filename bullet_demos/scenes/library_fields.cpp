#include "scenes/library_fields.h"

namespace demo {
namespace {

using sherd::Material;

/// The library says what is wrong after the name of the struct, and begins with the member: its path goes
/// before that.
void requireValid(const sherd::Status& status, const std::string& path) {
    if (status) return;
    const std::string sentence = status.error();
    const std::size_t colon = sentence.find(": ");
    throw BadKey{path + "." + (colon == std::string::npos ? sentence : sentence.substr(colon + 2))};
}

Material libraryMaterial(const std::string& name, const std::string& path) {
    const sherd::Result<Material> known = Material::named(name);
    if (known) return known.value();
    throw BadKey{path + ": " + known.error() + " Or give the constants in braces."};
}

void readConstants(Fields& fields, Material& material) {
    std::string like;
    fields.read("like", like);
    if (!like.empty()) material = libraryMaterial(like, fields.pathOf("like"));
    const auto constant = [&](const char* name, double& value) {
        if (like.empty() && !fields.has(name))
            fields.fail(name, "is missing; give it, or the library's material that gives it as \"like\"");
        fields.read(name, value);
    };
    fields.read("name", material.name);
    constant("youngs_modulus_pa", material.youngs_modulus_pa);
    constant("poisson_ratio", material.poisson_ratio);
    constant("density_kg_m3", material.density_kg_m3);
    constant("tensile_strength_pa", material.tensile_strength_pa);
    constant("fracture_energy_j_m2", material.fracture_energy_j_m2);
    fields.read("strength_scatter", material.strength_scatter);
    fields.read("compressive_strength_pa", material.compressive_strength_pa);
    fields.read("weibull_modulus", material.weibull_modulus);
    fields.read("weibull_volume_m3", material.weibull_volume_m3);
    fields.read("failure_criterion", material.failure_criterion);
    requireValid(material.validate(), fields.path());
}

void readSampling(Fields& fields, sherd::SamplingSettings& sampling) {
    fields.read("spacing_m", sampling.spacing_m);
    fields.read("layers_across_wall", sampling.layers_across_wall);
    fields.read("smallest_count", sampling.smallest_count);
    fields.read("largest_count", sampling.largest_count);
    fields.read("largest_factor_millions", sampling.largest_factor_millions);
    fields.read("largest_factor_if_thin_millions", sampling.largest_factor_if_thin_millions);
    fields.read("cells_per_spacing", sampling.cells_per_spacing);
    fields.read("smallest_fill", sampling.smallest_fill);
    requireValid(sampling.validate(), fields.path());
}

void readStress(Fields& fields, sherd::StressSettings& stress) {
    using namespace sherd;
    fields.read<TestFunction>("test_function", stress.test_function,
                              {{"galerkin", TestFunction::galerkin},
                               {"heaviside", TestFunction::heaviside},
                               {"heaviside_paper", TestFunction::heaviside_paper}});
    fields.read<TrialFunction>(
        "trial_function", stress.trial_function,
        {{"spline", TrialFunction::spline}, {"gmls", TrialFunction::gmls}, {"mls", TrialFunction::mls}});
    fields.read<Basis>("basis", stress.basis,
                       {{"linear", Basis::linear}, {"quadratic", Basis::quadratic}, {"cubic", Basis::cubic}});
    fields.read("resampling_rounds", stress.resampling_rounds);
    fields.read("resampling_margin", stress.resampling_margin);
    fields.read("support_radius", stress.support_radius);
    requireValid(stress.validate(), fields.path());
}

void readContact(Fields& fields, sherd::ContactSettings& contact) {
    fields.read("partner_youngs_modulus_pa", contact.partner_youngs_modulus_pa);
    fields.read("partner_poisson_ratio", contact.partner_poisson_ratio);
    fields.read("shortest_contact_s", contact.shortest_contact_s);
    fields.read("longest_contact_s", contact.longest_contact_s);
    fields.read("smallest_patch", contact.smallest_patch);
    fields.read("largest_patch", contact.largest_patch);
    requireValid(contact.validate(), fields.path());
}

void readGuide(Fields& fields, sherd::GuideField& guide) {
    using Kind = sherd::GuideField::Kind;
    if (!fields.has("kind")) fields.fail("kind", "is missing; choose one of: none, constant, radial");
    fields.read<Kind>("kind", guide.kind,
                      {{"none", Kind::none}, {"constant", Kind::constant}, {"radial", Kind::radial}});
    fields.read("direction", guide.direction);
    fields.read("penalty", guide.penalty);
    requireValid(guide.validate(), fields.path());
}

void readFracture(Fields& fields, sherd::FractureSettings& fracture) {
    fields.read("resample_contacts", fracture.resample_contacts);
    fields.read("fragment_count", fracture.fragment_count);
    fields.read("energy_into_cracks", fracture.energy_into_cracks);
    fields.read("largest_fragment_count", fracture.largest_fragment_count);
    fields.read("smallest_fragment_m3", fracture.smallest_fragment_m3);
    fields.read<sherd::Debris>("debris", fracture.debris,
                               {{"unbreakable", sherd::Debris::unbreakable},
                                {"merged", sherd::Debris::merged},
                                {"dropped", sherd::Debris::dropped}});
    fields.read<sherd::CollisionShape>("collision_shape", fracture.collision_shape,
                                       {{"boxes", sherd::CollisionShape::boxes},
                                        {"hull", sherd::CollisionShape::hull},
                                        {"convex_parts", sherd::CollisionShape::convex_parts}});
    fields.read("damage_waves", fracture.damage_waves);
    fields.read("crack_roughness", fracture.crack_roughness);
    fields.object("guide", [&](Fields& guide) { readGuide(guide, fracture.guide); });
    fields.read("rest_after_break_s", fracture.rest_after_break_s);
    requireValid(fracture.validate(), fields.path());
}

}  // namespace

void readMaterial(Fields& body, Material& material) {
    const nlohmann::json* found = body.find("material");
    if (!found) body.fail("material", "is missing; give the name of one, or its constants in braces");
    const std::string path = body.pathOf("material");
    if (found->is_string()) {
        material = libraryMaterial(found->get<std::string>(), path);
        return;
    }
    Fields::readObject(*found, path, [&](Fields& constants) { readConstants(constants, material); });
}

void readSettings(Fields& body, sherd::Settings& settings) {
    using sherd::Quality;
    body.object("settings", [&](Fields& fields) {
        Quality quality = Quality::game;
        fields.read<Quality>(
            "quality", quality,
            {{"preview", Quality::preview}, {"game", Quality::game}, {"film", Quality::film}});
        settings = sherd::Settings::forQuality(quality);
        fields.object("sampling", [&](Fields& part) { readSampling(part, settings.sampling); });
        fields.object("stress", [&](Fields& part) { readStress(part, settings.stress); });
        fields.object("contact", [&](Fields& part) { readContact(part, settings.contact); });
        fields.object("fracture", [&](Fields& part) { readFracture(part, settings.fracture); });
    });
}

}  // namespace demo
