#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "film/gltf_buffer.h"
#include "film/recording.h"

namespace demo {

/// The keys of a track as glTF has them.
struct GltfMotion {
    std::vector<float> times, places, turns;

    explicit GltfMotion(const Track& track);
};

/// The animation of a glTF file.
class GltfAnimation {
  public:
    explicit GltfAnimation(GltfBuffer& buffer) : buffer_(buffer) {}

    /// Moves and turns a node from key to key.
    void addMotion(int node, const GltfMotion& motion);
    /// Gives a node size 1 while the body of the track is there, else 0.
    void addPresence(int node, const Track& track);

    bool empty() const { return channels_.empty(); }
    nlohmann::ordered_json json() const;

  private:
    void addChannel(int node, const char* path, int times, int values, const char* interpolation);

    GltfBuffer& buffer_;
    nlohmann::ordered_json samplers_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json channels_ = nlohmann::ordered_json::array();
};

}  // namespace demo
