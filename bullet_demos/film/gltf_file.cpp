#include "film/gltf_file.h"

#include <cmath>
#include <cstdint>
#include <fstream>

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
    ordered_json samplers = ordered_json::array(), channels = ordered_json::array();
};

struct Motion {
    std::vector<float> times, places, turns;
};

/// Neighbouring quaternions lie on the same side, so that what is between them is the shorter way.
Motion motionOf(const Track& track) {
    Motion motion;
    Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
    for (const Key& key : track.keys) {
        Eigen::Quaterniond turn = Eigen::Quaterniond(key.placed.linear()).normalized();
        if (turn.dot(before) < 0) turn.coeffs() = -turn.coeffs();
        before = turn;
        motion.times.push_back(static_cast<float>(key.time_s));
        for (int axis = 0; axis < 3; ++axis)
            motion.places.push_back(static_cast<float>(key.placed.translation()[axis]));
        for (int i = 0; i < 4; ++i) motion.turns.push_back(static_cast<float>(turn.coeffs()[i]));
    }
    return motion;
}

void addChannel(Gltf& gltf, int node, const char* path, int times, int values, const char* interpolation) {
    gltf.channels.push_back(
        {{"sampler", gltf.samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    gltf.samplers.push_back({{"input", times}, {"output", values}, {"interpolation", interpolation}});
}

void addMotion(Gltf& gltf, int node, const Motion& motion) {
    if (motion.times.size() < 2) return;
    const int times = gltf.buffer.addFloats(motion.times, 1);
    addChannel(gltf, node, "translation", times, gltf.buffer.addFloats(motion.places, 3), "LINEAR");
    addChannel(gltf, node, "rotation", times, gltf.buffer.addFloats(motion.turns, 4), "LINEAR");
}

/// Size 1 while the body is there, else 0.
void addPresence(Gltf& gltf, int node, const Track& track) {
    std::vector<float> times, sizes;
    const auto add = [&](double time_s, float size) {
        times.push_back(static_cast<float>(time_s));
        sizes.insert(sizes.end(), 3, size);
    };
    if (track.born_s() > 0) add(0, 0);
    add(track.born_s(), 1);
    if (track.is_replaced) add(track.keys.back().time_s, 0);
    if (times.size() < 2) return;
    addChannel(gltf, node, "scale", gltf.buffer.addFloats(times, 1), gltf.buffer.addFloats(sizes, 3), "STEP");
}

std::string nameOf(const Track& track, int number) {
    const char* kind = !track.body.asset ? "ball_" : track.born_s() > 0 ? "fragment_" : "body_";
    return kind + std::to_string(number);
}

void addTrack(Gltf& gltf, const Track& track) {
    const int node = static_cast<int>(gltf.nodes.size());
    const Motion motion = motionOf(track);
    ordered_json said = {
        {"name", nameOf(track, node)},
        {"mesh", gltf.meshes.addBody(track.body)},
        {"translation", std::vector<float>(motion.places.begin(), motion.places.begin() + 3)},
        {"rotation", std::vector<float>(motion.turns.begin(), motion.turns.begin() + 4)}};
    if (track.born_s() > 0) said["scale"] = std::vector<int>(3, 0);
    gltf.nodes.push_back(std::move(said));
    addMotion(gltf, node, motion);
    addPresence(gltf, node, track);
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
    if (!gltf.channels.empty()) {
        document["animations"] = ordered_json::array(
            {{{"name", "run"}, {"samplers", gltf.samplers}, {"channels", gltf.channels}}});
    }
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
