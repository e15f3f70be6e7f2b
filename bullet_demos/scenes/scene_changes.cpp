#include "scenes/scene_changes.h"

#include <algorithm>
#include <vector>

#include "scenes/json_fields.h"
#include "scenes/json_path.h"
#include "scenes/scene_fields.h"
#include "scenes/scene_json.h"

namespace demo {
namespace {

using nlohmann::json;

/// A word that stands for a path.
struct ShortKey {
    const char* name;
    const char* path;
};
constexpr ShortKey short_keys[] = {
    {"duration", "duration_s"},
    {"after_picture", "after_picture_s"},
    {"time_step", "time_step_s"},
    {"drop_height", "bodies[*].position_m[2]"},
    {"tilt", "bodies[*].turn_deg[1]"},
    {"ball_diameter", "balls[*].diameter_m"},
    {"strength", "bodies[*].material.tensile_strength_pa"},
    {"strength_scatter", "bodies[*].material.strength_scatter"},
    {"youngs_modulus", "bodies[*].material.youngs_modulus_pa"},
    {"poisson_ratio", "bodies[*].material.poisson_ratio"},
    {"density", "bodies[*].material.density_kg_m3"},
    {"fracture_energy", "bodies[*].material.fracture_energy_j_m2"},
    {"spacing", "bodies[*].settings.sampling.spacing_m"},
    {"support_radius", "bodies[*].settings.stress.support_radius"},
    {"test_function", "bodies[*].settings.stress.test_function"},
    {"trial_function", "bodies[*].settings.stress.trial_function"},
    {"basis", "bodies[*].settings.stress.basis"},
    {"collision_shape", "bodies[*].settings.fracture.collision_shape"},
    {"fragment_count", "bodies[*].settings.fracture.fragment_count"},
    {"largest_fragment_count", "bodies[*].settings.fracture.largest_fragment_count"},
};

/// The items of a list of objects; none if there is no such list.
std::vector<json*> items(json& scene, const char* name) {
    std::vector<json*> objects;
    if (!scene.is_object() || !scene.contains(name) || !scene[name].is_array()) return objects;
    for (json& item : scene[name])
        if (item.is_object()) objects.push_back(&item);
    return objects;
}

/// The striking balls fly with this speed; where there are none the breakable bodies do, straight down if
/// they stood still.
void setSpeed(json& scene, const json& speed) {
    const std::vector<json*> balls = items(scene, "balls");
    for (json* item : balls.empty() ? items(scene, "bodies") : balls) {
        Vec3 velocity = Vec3::Zero();
        Fields(*item, "").read({"velocity_m_s", "at the start"}, velocity);
        const Vec3 along = velocity.norm() > 0 ? velocity.normalized().eval() : Vec3(0, 0, -1);
        const Vec3 set = speed.get<double>() * along;
        (*item)["velocity_m_s"] = {set.x(), set.y(), set.z()};
    }
}

void setTriangles(json& scene, const json& triangles) {
    for (json* body : items(scene, "bodies")) {
        if (!body->contains("shape") || !(*body)["shape"].is_object()) continue;
        json& shape = (*body)["shape"];
        if (shape.contains("generator")) shape["triangles"] = triangles;
        if (!shape.contains("box") || !shape["box"].is_object()) continue;
        shape["box"]["triangles"] = triangles;
        shape["box"].erase("edge_m");
    }
}

/// A word for a change of several values.
struct Change {
    Field field;
    void (*apply)(json& scene, const json& number);
};
const Change compound_changes[] = {
    {{"speed", "of the balls, or of the bodies, downwards, where there is no ball",
      Range::between(0, 100, "m/s")},
     setSpeed},
    {{"triangles", "of meshes that are made, not read from a file", Range::between(2000, 1e6)}, setTriangles},
};

/// What three numbers of that name are where a scene leaves them out; null for other names.
json defaultList(const std::string& name) {
    json list;
    const auto look = [&](const std::string& path, const Field& field, const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Vec3>)
            if (field.name == name || path == name) list = {value.x(), value.y(), value.z()};
    };
    const Scene scene;
    const BreakableBody body;
    const Ball ball;
    sherd::visitPaths(scene, look);
    sherd::visitPaths(ball, look);
    sherd::visitPaths(body, look);
    return list;
}

/// Materials that are given by name become objects with `like`, which can have fields.
void openMaterials(json& scene) {
    for (json* body : items(scene, "bodies"))
        if (body->contains("material") && (*body)["material"].is_string())
            (*body)["material"] = {{"like", (*body)["material"]}};
}

/// The outermost keys of a scene.
std::vector<std::string> outermostKeys() {
    std::vector<std::string> names = {"bodies", "balls", seed_field.name};
    const Scene scene;
    visitFields(scene, [&](const Field& field, const auto&) { names.emplace_back(field.name); });
    return names;
}

/// Refuses a single word that is no key of a scene, with the short keys there are.
void requireKnown(const std::string& path) {
    const std::vector<std::string> outermost = outermostKeys();
    if (path.find_first_of(".[") != std::string::npos) return;
    if (std::find(outermost.begin(), outermost.end(), path) != outermost.end()) return;
    std::vector<std::string> names = {seed_field.name};
    for (const Change& change : compound_changes) names.emplace_back(change.field.name);
    for (const ShortKey& key : short_keys) names.emplace_back(key.name);
    throw BadKey{"there is no key '" + path + "'; choose one of: " + sherd::listOf(names) +
                 ", or give a path as bodies[0].position_m (--help-all lists them)."};
}

void requirePossible(const Field& field, const json& value) {
    if (!value.is_number() || !field.range.allows(value.get<double>()))
        throw BadKey{std::string(field.name) + " is " + value.dump() + " but must be " + field.range.text() +
                     "."};
}

}  // namespace

void changeScene(json& scene, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    std::string path = assignment.substr(0, equals);
    if (equals == std::string::npos)
        throw BadKey{"'" + path + "' is not KEY=VALUE; the scene goes before --set."};
    const json value = parseSceneValue(assignment.substr(equals + 1));
    for (const Change& change : compound_changes) {
        if (change.field.name != path) continue;
        requirePossible(change.field, value);
        change.apply(scene, value);
        return;
    }
    for (const ShortKey& key : short_keys)
        if (key.name == path) path = key.path;
    requireKnown(path);
    if (path.find("].material.") != std::string::npos) openMaterials(scene);
    setAtPath(scene, path, value, defaultList);
}

std::string describeChanges() {
    constexpr std::size_t column = 26;
    std::string lines = "Keys for --set, and the paths that they stand for ([*]: every item):\n";
    const auto add = [&](const char* name, const std::string& meaning) {
        std::string head = std::string("  ") + name;
        head.resize(std::max(head.size() + 2, column), ' ');
        lines += head + meaning + "\n";
    };
    for (const ShortKey& key : short_keys) add(key.name, key.path);
    for (const Change& change : compound_changes)
        add(change.field.name, change.field.meaning + (" [" + change.field.range.text() + "]"));
    add(seed_field.name, seed_field.meaning + (" [" + seed_field.range.text() + "]"));
    return lines + "\nPaths for --set, and what they take:\n" + sherd::listFields(Scene()) +
           "\nOf a body, after \"bodies[0].\" (for its shape see bullet_demos/scenes/README.md):\n" +
           sherd::listFields(BreakableBody()) + "\nOf a ball, after \"balls[0].\":\n" +
           sherd::listFields(Ball());
}

}  // namespace demo
