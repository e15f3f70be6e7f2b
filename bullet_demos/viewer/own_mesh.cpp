#include "viewer/own_mesh.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "viewer/looks.h"
#include "viewer/mesh_import.h"

namespace demo {
namespace {

double longestSide(const sherd::TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices) box.extend(vertex);
    return box.sizes().maxCoeff();
}

sherd::Repair repairOf(const Choices& choices, const sherd::TriangleMesh& mesh) {
    const OwnMesh& own = choices.own_mesh;
    sherd::Repair repair = own.repair ? sherd::Repair::automatic() : sherd::Repair();
    const double longest = longestSide(mesh);
    repair.scale = own.size_m > 0 && longest > 0 ? own.size_m / longest : own.scale;
    repair.shell_thickness_m = own.shell_thickness_m;
    repair.up_axis = own.up_axis.value_or(usualUpAxis(choices.file));
    return repair;
}

/// A sentence about the mesh, with the viewer's options in the place of the fields of Repair that it names.
std::string withOptions(const std::string& sentence) {
    return sherd::withNames(sentence, {{"Repair::automatic()", "--repair"},
                                       {"Repair::scale", "--scale, or --size"},
                                       {"Repair::shell_thickness_m", "--shell"}});
}

Scene sceneAround(const Choices& choices) {
    Scene scene;
    scene.name = std::filesystem::path(choices.file).stem().string();
    scene.summary = "a mesh of your own";
    scene.camera.towards = Vec3(0.3, 1, -0.45);
    BreakableBody body;
    body.position.z() = choices.own_mesh.drop_height_m;
    scene.bodies = {body};
    return scene;
}

}  // namespace

sherd::Result<Loaded> loadOwnMesh(const Choices& choices) {
    const auto mesh = importMesh(choices.file);
    if (!mesh) return sherd::Error{mesh.error()};
    Choices with_material = choices;
    if (with_material.material.empty()) with_material.material = choices.own_mesh.material;
    Loaded loaded{sceneAround(choices), {}, {}};
    const sherd::Status chosen = chooseMaterials(loaded.scene, with_material);
    if (!chosen) return sherd::Error{chosen.error()};
    if (!choices.preset.empty())
        return sherd::Error{"There is no preset '" + choices.preset + "': a mesh has none, scenes do."};
    if (const sherd::Status set = loaded.scene.bodies.front().settings.set(choices.changes); !set)
        return sherd::Error{"--set, of a mesh: " + set.error()};
    const BreakableBody& body = loaded.scene.bodies.front();
    auto asset = sherd::BreakableAsset::fromMesh(mesh.value(), body.material, body.settings,
                                                 repairOf(choices, mesh.value()));
    if (!asset)
        return sherd::Error{
            choices.file + ": " + withOptions(asset.error()) +
            (choices.own_mesh.repair ? "" : " In the panel --repair is the box `repair the mesh`.") +
            (choices.own_mesh.shell_thickness_m > 0 && !choices.own_mesh.repair ? " A shell needs that, too."
                                                                                : "")};
    if (asset.value().particleCount() == 0)
        return sherd::Error{choices.file + ": " + asset.value().prepare().error()};
    for (const std::string& sentence : asset.value().repairs().sentences())
        loaded.said.push_back(withOptions(sentence));
    for (const std::string& warning : asset.value().warnings()) loaded.said.push_back(withOptions(warning));
    loaded.assets.bodies.push_back(std::move(asset).value());
    return loaded;
}

}  // namespace demo
