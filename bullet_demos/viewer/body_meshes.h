#pragma once

#include <sherd/sherd.h>

#include <map>
#include <memory>

#include "render/mesh.h"

namespace demo {

/// What a surface is drawn with; its edges are sharp where faces meet at more than half a right angle.
render::MeshData toMeshData(const sherd::TriangleMesh& surface);

/// The meshes of assets on the graphics card, made when an asset is first drawn. Those that a frame did not
/// ask for are given up at its end.
class BodyMeshes {
  public:
    const render::Mesh& of(const sherd::BreakableAsset& asset);
    void endFrame();

  private:
    struct Entry {
        sherd::BreakableAsset asset;  ///< keeps the surface at its place, which is the key
        std::unique_ptr<render::Mesh> mesh;
        bool used = true;
    };
    std::map<const sherd::TriangleMesh*, Entry> entries_;
};

}  // namespace demo
