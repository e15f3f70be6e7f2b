#include "scenes/scene_file.h"

#include <algorithm>
#include <filesystem>

#include "generators/generators.h"
#include "scenes/box_mesh.h"
#include "scenes/json_fields.h"
#include "scenes/library_fields.h"
#include "scenes/scene_json.h"

namespace demo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double largest_mesh = 1e6;  ///< triangles

void readTouch(Fields& fields, Touch& touch) {
    fields.read("friction", touch.friction, {0, 10});
    fields.read("restitution", touch.restitution, {0, 1});
}

void readLook(Fields& fields, Look& look) {
    fields.read("outside", look.outside, {0, 1});
    fields.read("crack", look.crack, {0, 1});
    fields.read("gloss", look.gloss, {0, 1});
}

void readPaintedStrength(Fields& fields, PaintedStrength& painted) {
    constexpr double least = 1e-3, most = 1e3;
    fields.read("black", painted.black, {least, most});
    fields.read("white", painted.white, {least, most});
}

void readBox(Fields& fields, Box& box) {
    fields.read("size_m", box.size_m, {1e-3, 100, "m"});
    if (fields.has("edge_m") && fields.has("triangles"))
        fields.fail("edge_m", "and triangles say the same twice; keep one");
    fields.read("edge_m", box.edge_m, {boxEdge(box.size_m, static_cast<int>(largest_mesh)), 100, "m"});
    int triangles = 0;
    fields.read("triangles", triangles, {12, largest_mesh});
    if (triangles > 0) box.edge_m = boxEdge(box.size_m, triangles);
}

Generated readGenerated(Fields& fields) {
    Generated mesh;
    fields.read("generator", mesh.name);
    fields.read("triangles", mesh.triangles, {2000, largest_mesh});
    const std::vector<std::string> names = sherd::generators::generatorNames();
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    if (std::find(names.begin(), names.end(), mesh.name) == names.end())
        fields.fail("generator", "is \"" + mesh.name + "\"; choose one of: " + list);
    return mesh;
}

void readShape(Fields& fields, Shape& shape, const fs::path& folder) {
    std::string path;
    fields.read("obj", path);
    Box box;
    fields.object("box", [&](Fields& part) { readBox(part, box); });
    if (fields.has("obj") + fields.has("box") + fields.has("generator") != 1)
        throw BadKey{fields.path() + " must have one of obj, box and generator."};
    if (fields.has("obj")) shape = ObjFile{(folder / path).lexically_normal().string()};
    if (fields.has("box")) shape = box;
    if (fields.has("generator")) shape = readGenerated(fields);
}

void readBody(Fields& fields, BreakableBody& body, const fs::path& folder) {
    if (!fields.has("shape")) fields.fail("shape", "is missing; it has one of obj, box and generator");
    fields.object("shape", [&](Fields& part) { readShape(part, body.shape, folder); });
    readMaterial(fields, body.material);
    readSettings(fields, body.settings);
    if (fields.has("painted_strength")) body.painted_strength.emplace();
    fields.object("painted_strength",
                  [&](Fields& part) { readPaintedStrength(part, *body.painted_strength); });
    fields.object("touch", [&](Fields& part) { readTouch(part, body.touch); });
    fields.object("look", [&](Fields& part) { readLook(part, body.look); });
    fields.read("turn_deg", body.turn_deg, {-360, 360, "degrees"});
    fields.read("position_m", body.position, {-1000, 1000, "m"});
    if (body.position.z() < 0)
        fields.fail("position_m[2]",
                    "must not be negative: it is the height of the lowest point over the floor");
    fields.read("velocity_m_s", body.velocity, {-1000, 1000, "m/s"});
    fields.read("spin_rad_s", body.spin, {-1000, 1000, "rad/s"});
}

void readBall(Fields& fields, Ball& ball) {
    fields.read("diameter_m", ball.diameter_m, {0.001, 10, "m"});
    fields.read("density_kg_m3", ball.density_kg_m3, {1, 1e5, "kg/m^3"});
    fields.object("touch", [&](Fields& part) { readTouch(part, ball.touch); });
    fields.read("position_m", ball.position, {-1000, 1000, "m"});
    fields.read("velocity_m_s", ball.velocity, {-1000, 1000, "m/s"});
}

void readCamera(Fields& fields, Camera& camera) {
    fields.read("towards", camera.towards, {-1000, 1000});
    if (camera.towards.head<2>().norm() <= 1e-3 * camera.towards.norm())
        fields.fail("towards", "must not be straight up or down, nor zero");
    fields.read("width_deg", camera.width_deg, {5, 120, "degrees"});
}

void readWhole(Fields& fields, Scene& scene, const fs::path& folder) {
    fields.read("summary", scene.summary);
    fields.list("bodies", [&](Fields& item) { readBody(item, scene.bodies.emplace_back(), folder); });
    if (scene.bodies.empty()) fields.fail("bodies", "must have at least one body that can break");
    fields.list("balls", [&](Fields& item) { readBall(item, scene.balls.emplace_back()); });
    fields.object("floor", [&](Fields& part) { readTouch(part, scene.floor); });
    fields.object("camera", [&](Fields& part) { readCamera(part, scene.camera); });
    fields.read("gravity_m_s2", scene.gravity, {-1000, 1000, "m/s^2"});
    fields.read("duration_s", scene.duration_s, {0.01, 60, "s"});
    fields.read("after_picture_s", scene.after_picture_s, {0, 60, "s"});
    fields.read("time_step_s", scene.time_step_s, {1e-4, 1.0 / 30, "s"});
    int seed = 1;
    fields.read("seed", seed, {0, 1e9});
    for (BreakableBody& body : scene.bodies) body.settings.fracture.seed = static_cast<std::uint64_t>(seed);
}

/// Takes the presets out of a scene.
json takePresets(json& scene) {
    if (!scene.is_object() || !scene.contains("presets")) return json::object();
    json presets = scene["presets"];
    scene.erase("presets");
    if (!presets.is_object())
        throw BadKey{"presets must be an object in braces, not " + presets.dump() + "."};
    return presets;
}

}  // namespace

sherd::Result<Scene> readScene(const std::string& path, const std::string& preset,
                               const std::vector<std::string>& changes) {
    try {
        json text = parseSceneFile(path);
        const json presets = takePresets(text);
        Scene scene;
        scene.name = fs::path(path).stem().string();
        std::string names;
        for (const auto& item : presets.items()) {
            scene.presets.push_back(item.key());
            names += (names.empty() ? "" : ", ") + item.key();
        }
        if (!preset.empty() && !presets.contains(preset))
            throw BadKey{"there is no preset '" + preset + "'; " +
                         (names.empty() ? "this scene has none." : "choose one of: " + names + ".")};
        if (!preset.empty()) layOver(text, presets[preset]);
        for (const std::string& change : changes) setByPath(text, change);
        const fs::path folder = fs::path(path).parent_path();
        Fields::readObject(text, "", [&](Fields& fields) { readWhole(fields, scene, folder); });
        return scene;
    } catch (const BadKey& bad) {
        return sherd::Error{path + ": " + bad.sentence};
    } catch (const json::exception& failure) {
        return sherd::Error{path + ": " + failure.what()};
    }
}

}  // namespace demo
