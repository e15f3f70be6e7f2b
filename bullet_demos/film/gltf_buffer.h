#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace demo {

/// The numbers of a glTF file: one buffer, and a list of accessors that say where in it something stands.
class GltfBuffer {
  public:
    /// Adds a list of scalars (`width` 1), vectors (3) or quaternions (4), and returns the index of its
    /// accessor.
    int addFloats(const std::vector<float>& values, int width);
    /// The same for what belongs to the vertices of a mesh.
    int addVertices(const std::vector<float>& values, int width);
    int addIndices(const std::vector<std::uint32_t>& indices);

    const std::string& bytes() const { return bytes_; }
    const nlohmann::ordered_json& accessors() const { return accessors_; }
    const nlohmann::ordered_json& views() const { return views_; }

  private:
    int add(const void* data, std::size_t size, nlohmann::ordered_json accessor, int target);

    std::string bytes_;
    nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
};

}  // namespace demo
