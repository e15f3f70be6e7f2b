#include "scenes/scene_file.h"

#include <algorithm>
#include <filesystem>

#include "generators/generators.h"
#include "scenes/box_mesh.h"
#include "scenes/json_fields.h"
#include "scenes/library_fields.h"
#include "scenes/scene_changes.h"
#include "scenes/scene_fields.h"
#include "scenes/scene_json.h"
#include "scenes/support_regions.h"

namespace demo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double largest_mesh = 1e6;  ///< triangles

void readBox(Fields& fields, Box& box) {
    fields.read({"size_m", "edge lengths", Range::between(1e-3, 100, "m")}, box.size_m);
    if (fields.has("edge_m") && fields.has("triangles"))
        fields.fail("edge_m", "and triangles say the same twice; keep one");
    const double finest_m = boxEdge(box.size_m, static_cast<int>(largest_mesh));
    fields.read({"edge_m", "legs of the triangles", Range::between(finest_m, 100, "m")}, box.edge_m);
    int triangles = 0;
    fields.read({"triangles", "about how many", Range::between(12, largest_mesh)}, triangles);
    if (triangles > 0) box.edge_m = boxEdge(box.size_m, triangles);
}

Generated readGenerated(Fields& fields) {
    Generated mesh;
    fields.read({"generator", "its name"}, mesh.name);
    fields.read({"triangles", "about how many", Range::between(2000, largest_mesh)}, mesh.triangles);
    const std::vector<std::string> names = sherd::generators::generatorNames();
    if (std::find(names.begin(), names.end(), mesh.name) == names.end())
        fields.fail("generator", "is \"" + mesh.name + "\"; choose one of: " + sherd::listOf(names));
    return mesh;
}

/// How the mesh of an OBJ is taken in.
void readRepair(Fields& fields, sherd::Repair& repair) {
    fields.read({"repair", "what may be changed in the mesh"}, repair.mode);
    fields.read({"scale", "multiplies the coordinates", Range::between(1e-6, 1e6)}, repair.scale);
    fields.read({"up_axis", "the axis of the mesh that points up"}, repair.up_axis);
    fields.read({"shell_thickness_m", "walls of a hollow body", Range::between(0, 100, "m")},
                repair.shell_thickness_m);
    fields.read({"wrap_detail", "what the wrap closes, over the size", Range::between(0.001, 0.1)},
                repair.wrap_detail);
}

void readShape(Fields& fields, Shape& shape, const fs::path& folder) {
    std::string path;
    fields.read({"obj", "path of a Wavefront OBJ"}, path);
    Box box;
    fields.object("box", [&](Fields& part) { readBox(part, box); });
    if (fields.has("obj") + fields.has("box") + fields.has("generator") != 1)
        throw BadKey{fields.path() + " must have one of obj, box and generator."};
    if (fields.has("obj")) {
        ObjFile file{(folder / path).lexically_normal().string(), {}};
        readRepair(fields, file.repair);
        shape = file;
    }
    if (fields.has("box")) shape = box;
    if (fields.has("generator")) shape = readGenerated(fields);
}

void readBody(Fields& fields, BreakableBody& body, const fs::path& folder, std::uint64_t seed) {
    if (!fields.has("shape")) fields.fail("shape", "is missing; it has one of obj, box and generator");
    fields.object("shape", [&](Fields& part) { readShape(part, body.shape, folder); });
    visitFields(body, [&](const Field& field, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, sherd::Material>) {
            readMaterial(fields, value, folder.string());
            body.look = lookOf(value);
        } else if constexpr (std::is_same_v<Value, sherd::Settings>)
            readSettings(fields, value, seed);
        else
            fields.read(field, value);
    });
    if (fields.has("painted_strength")) body.painted_strength.emplace();
    fields.object("painted_strength", [&](Fields& part) { part.readAll(*body.painted_strength); });
    readSupports(fields, body.supports);
    if (!body.supports.empty() && !(body.velocity.isZero(0) && body.spin.isZero(0)))
        fields.fail("supports", "hold the body where it is, so velocity_m_s and spin_rad_s must be zero");
    if (body.position.z() < 0)
        fields.fail("position_m[2]",
                    "must not be negative: it is the height of the lowest point over the floor");
}

void readWhole(Fields& fields, Scene& scene, const fs::path& folder) {
    fields.readAll(scene);
    std::uint64_t seed = 1;
    fields.read(seed_field, seed);
    fields.list("bodies", [&](Fields& item) { readBody(item, scene.bodies.emplace_back(), folder, seed); });
    if (scene.bodies.empty()) fields.fail("bodies", "must have at least one body that can break");
    fields.list("balls", [&](Fields& item) { item.readAll(scene.balls.emplace_back()); });
    const Vec3& towards = scene.camera.towards;
    if (towards.head<2>().norm() <= 1e-3 * towards.norm())
        fields.fail("camera.towards", "must not be straight up or down, nor zero");
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
        for (const auto& item : presets.items()) scene.presets.push_back(item.key());
        if (!preset.empty() && !presets.contains(preset))
            throw BadKey{"there is no preset '" + preset + "'; " +
                         (presets.empty() ? "this scene has none."
                                          : "choose one of: " + sherd::listOf(scene.presets) + ".")};
        if (!preset.empty()) layOver(text, presets[preset]);
        for (const std::string& change : changes) changeScene(text, change);
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
