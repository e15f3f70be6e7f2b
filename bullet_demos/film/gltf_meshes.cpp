#include "film/gltf_meshes.h"

#include <algorithm>
#include <cmath>

#include "film/drawn_mesh.h"

namespace demo {
namespace {

using nlohmann::ordered_json;

std::vector<float> floatsOf(const std::vector<Vec3>& vectors) {
    std::vector<float> floats;
    for (const Vec3& v : vectors)
        for (int axis = 0; axis < 3; ++axis) floats.push_back(static_cast<float>(v[axis]));
    return floats;
}

/// Unit vectors along circles of latitude, pole to pole; the first and the last of a circle are the same.
struct UnitSphere {
    static constexpr int circles = 16, around = 32;
    std::vector<Vec3> points;
    std::vector<std::uint32_t> indices;

    UnitSphere() {
        const double pi = std::acos(-1.0);
        for (int i = 0; i <= circles; ++i) {
            const double polar = pi * i / circles;
            for (int j = 0; j <= around; ++j) {
                const double azimuth = 2 * pi * j / around;
                points.push_back(Vec3(std::sin(polar) * std::cos(azimuth),
                                      std::sin(polar) * std::sin(azimuth), std::cos(polar))
                                     .normalized());
            }
        }
        for (std::uint32_t i = 0; i < circles; ++i) {
            for (std::uint32_t j = 0; j < around; ++j) {
                const std::uint32_t a = i * (around + 1) + j, b = a + around + 1;
                if (i > 0) indices.insert(indices.end(), {a, b, a + 1});
                if (i + 1 < circles) indices.insert(indices.end(), {a + 1, b, b + 1});
            }
        }
    }
};

constexpr const char* transmission = "KHR_materials_transmission";

}  // namespace

int GltfMeshes::addBody(const BodyState& body) {
    return body.asset ? addSurface(body) : addBall(body.ball_diameter_m);
}

int GltfMeshes::addSurface(const BodyState& body) {
    const DrawnMesh drawn = drawnMesh(body.asset->surface());
    std::vector<Vec3> positions, normals;
    for (const DrawnVertex& vertex : drawn.vertices) {
        positions.push_back(vertex.position);
        normals.push_back(vertex.normal);
    }
    if (isClear(body.asset->material())) {
        const int glass = material("clear", body.look.outside.cwiseSqrt(), 0, 0.05, true);
        return add("body", positions, normals, {{drawn.outside, glass}, {drawn.crack, glass}});
    }
    const double roughness = 0.9 - 0.6 * std::sqrt(body.look.gloss);
    return add("body", positions, normals,
               {{drawn.outside, material("outside", body.look.outside, 0, roughness)},
                {drawn.crack, material("crack", body.look.crack, 0, 0.95)}});
}

int GltfMeshes::addBall(double diameter_m) {
    const UnitSphere sphere;
    std::vector<Vec3> positions;
    for (const Vec3& point : sphere.points) positions.push_back(diameter_m / 2 * point);
    const int steel = material("steel", Vec3(0.45, 0.46, 0.48), 1, 0.3);
    return add("ball", positions, sphere.points, {{sphere.indices, steel}});
}

int GltfMeshes::addFloor() {
    constexpr double half_m = 5;
    const std::vector<Vec3> corners = {
        {-half_m, -half_m, 0}, {half_m, -half_m, 0}, {half_m, half_m, 0}, {-half_m, half_m, 0}};
    const int stone = material("floor", Vec3(0.40, 0.39, 0.37), 0, 0.9);
    return add("floor", corners, std::vector<Vec3>(4, Vec3::UnitZ()), {{{0, 1, 2, 0, 2, 3}, stone}});
}

int GltfMeshes::add(const char* name, const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
                    const std::vector<Part>& parts) {
    const ordered_json attributes = {{"POSITION", buffer_.addVertices(floatsOf(positions), 3)},
                                     {"NORMAL", buffer_.addVertices(floatsOf(normals), 3)}};
    ordered_json primitives = ordered_json::array();
    for (const auto& [indices, material] : parts) {
        if (indices.empty()) continue;
        const int accessor = buffer_.addIndices(indices);
        primitives.push_back(ordered_json::object(
            {{"attributes", attributes}, {"indices", accessor}, {"material", material}}));
    }
    meshes_.push_back(ordered_json::object({{"name", name}, {"primitives", primitives}}));
    return static_cast<int>(meshes_.size()) - 1;
}

int GltfMeshes::material(const std::string& name, const Vec3& colour, double metallic, double roughness,
                         bool is_clear) {
    const std::vector<double> base = {colour.x(), colour.y(), colour.z(), 1};
    const ordered_json surface = {
        {"baseColorFactor", base}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}};
    ordered_json said = {{"name", name}, {"pbrMetallicRoughness", surface}};
    if (is_clear) said["extensions"] = {{transmission, {{"transmissionFactor", 0.95}}}};
    const auto [found, is_new] = material_of_.try_emplace(said.dump(), static_cast<int>(materials_.size()));
    if (is_new) materials_.push_back(said);
    return found->second;
}

std::vector<std::string> GltfMeshes::extensions() const {
    const bool some_clear = std::any_of(materials_.begin(), materials_.end(),
                                        [](const auto& one) { return one.contains("extensions"); });
    return some_clear ? std::vector<std::string>{transmission} : std::vector<std::string>{};
}

}  // namespace demo
