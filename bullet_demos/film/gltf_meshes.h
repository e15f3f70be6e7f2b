#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "film/gltf_buffer.h"
#include "film/recording.h"

namespace demo {

/// The meshes of a glTF file and the materials that they name.
class GltfMeshes {
  public:
    explicit GltfMeshes(GltfBuffer& buffer) : buffer_(buffer) {}

    /// Each returns the index of the mesh. Outside and crack faces of a body have materials of their own.
    int addBody(const BodyState& body);
    int addFloor();

    const nlohmann::ordered_json& meshes() const { return meshes_; }
    const nlohmann::ordered_json& materials() const { return materials_; }
    /// Names of the extensions that the materials use.
    std::vector<std::string> extensions() const;

  private:
    /// Indices of triangles, and the material that they have.
    using Part = std::pair<std::vector<std::uint32_t>, int>;

    int addSurface(const BodyState& body);
    int addBall(double diameter_m);
    int add(const char* name, const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
            const std::vector<Part>& parts);
    int material(const std::string& name, const Vec3& colour, double metallic, double roughness,
                 bool is_clear = false);

    GltfBuffer& buffer_;
    nlohmann::ordered_json meshes_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json materials_ = nlohmann::ordered_json::array();
    std::map<std::string, int> material_of_;  ///< by all that it says
};

}  // namespace demo
