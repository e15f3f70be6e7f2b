#include "film/gltf_file.h"

#include <cmath>
#include <cstdint>
#include <fstream>

#include "film/gltf_animation.h"
#include "film/gltf_buffer.h"
#include "film/gltf_meshes.h"

namespace demo {
namespace {

using nlohmann::ordered_json;

/// A file in the making.
struct Gltf {
    GltfBuffer buffer;
    GltfMeshes meshes{buffer};
    ordered_json nodes = ordered_json::array();
    GltfAnimation animation{buffer};
};

std::string nameOf(const Track& track, int number) {
    const char* kind = !track.body.asset ? "ball_" : track.is_fragment ? "fragment_" : "body_";
    return kind + std::to_string(number);
}

void addTrack(Gltf& gltf, const Track& track) {
    const int node = static_cast<int>(gltf.nodes.size());
    const GltfMotion motion(track);
    ordered_json said = {
        {"name", nameOf(track, node)},
        {"mesh", gltf.meshes.addBody(track.body)},
        {"translation", std::vector<float>(motion.places.begin(), motion.places.begin() + 3)},
        {"rotation", std::vector<float>(motion.turns.begin(), motion.turns.begin() + 4)}};
    if (!track.isThereAt(0)) said["scale"] = std::vector<int>(3, 0);
    gltf.nodes.push_back(std::move(said));
    gltf.animation.addMotion(node, motion);
    gltf.animation.addPresence(node, track);
}

/// The node above all others turns z upward into y upward, which glTF asks for.
int addRoot(Gltf& gltf) {
    std::vector<int> children(gltf.nodes.size());
    for (std::size_t i = 0; i < children.size(); ++i) children[i] = static_cast<int>(i);
    const double half = std::sqrt(0.5);
    gltf.nodes.push_back(
        {{"name", "z_up"}, {"rotation", std::vector<double>{-half, 0, 0, half}}, {"children", children}});
    return static_cast<int>(gltf.nodes.size()) - 1;
}

ordered_json documentOf(Gltf& gltf) {
    const int root = addRoot(gltf);
    ordered_json document = {{"asset", {{"version", "2.0"}, {"generator", "Sherd"}}},
                             {"scene", 0},
                             {"scenes", ordered_json::array({{{"nodes", ordered_json::array({root})}}})},
                             {"nodes", gltf.nodes},
                             {"meshes", gltf.meshes.meshes()},
                             {"materials", gltf.meshes.materials()}};
    if (const auto used = gltf.meshes.extensions(); !used.empty()) document["extensionsUsed"] = used;
    if (!gltf.animation.empty()) document["animations"] = ordered_json::array({gltf.animation.json()});
    document["accessors"] = gltf.buffer.accessors();
    document["bufferViews"] = gltf.buffer.views();
    document["buffers"] = ordered_json::array({{{"byteLength", gltf.buffer.bytes().size()}}});
    return document;
}

void writeNumber(std::ostream& out, std::size_t number) {
    const auto four_bytes = static_cast<std::uint32_t>(number);
    out.write(reinterpret_cast<const char*>(&four_bytes), sizeof four_bytes);
}

/// Chunks of a GLB are padded to multiples of four bytes.
void writeChunk(std::ostream& out, const char* type, std::string content, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    writeNumber(out, content.size());
    out.write(type, 4);
    out << content;
}

}  // namespace

sherd::Status writeGltf(const std::vector<Track>& tracks, const std::string& path) {
    Gltf gltf;
    gltf.nodes.push_back({{"name", "floor"}, {"mesh", gltf.meshes.addFloor()}});
    for (const Track& track : tracks) addTrack(gltf, track);
    std::string json = documentOf(gltf).dump();
    const std::string& bytes = gltf.buffer.bytes();
    constexpr std::size_t header = 12, chunk_header = 8;
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    std::ofstream out(path, std::ios::binary);
    out.write("glTF", 4);
    writeNumber(out, 2);
    writeNumber(out, header + 2 * chunk_header + padded(json.size()) + padded(bytes.size()));
    writeChunk(out, "JSON", std::move(json), ' ');
    writeChunk(out, "BIN\0", bytes, '\0');
    out.flush();
    if (!out) return sherd::Error{"Cannot write " + path + "; does its folder exist, and is the disk full?"};
    return sherd::success();
}

}  // namespace demo
