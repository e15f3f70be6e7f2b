#pragma once

#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/triangle_mesh.h>

#include <memory>
#include <string>

namespace sherd {

class BreakableSolid;  // internal: the sampled solid behind an asset

/// A solid that can break: a closed surface, what it is made of, and (once it was struck) its factored stress
/// problem. Cheap to copy; copies share everything, and any number of bodies may be made from one asset.
class BreakableAsset {
  public:
    /// Reads a Wavefront OBJ and checks it. The error says what is wrong with the file or the surface, where,
    /// and what to do.
    static Result<BreakableAsset> fromObj(const std::string& path, const Material& material,
                                          const Settings& settings = {});

    /// The same for a surface in memory.
    static Result<BreakableAsset> fromMesh(const TriangleMesh& surface, const Material& material,
                                           const Settings& settings = {});

    /// Assembles and factors the stress problem now rather than at the first blow.
    Status prepare() const;

    const TriangleMesh& surface() const;
    const Material& material() const;
    int particleCount() const;
    double mass() const;    ///< kg
    double volume() const;  ///< m^3

    explicit BreakableAsset(std::shared_ptr<const BreakableSolid> solid) : solid_(std::move(solid)) {}
    const std::shared_ptr<const BreakableSolid>& solid() const { return solid_; }

  private:
    std::shared_ptr<const BreakableSolid> solid_;
};

}  // namespace sherd
