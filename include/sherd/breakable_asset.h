#pragma once

#include <sherd/material.h>
#include <sherd/repair.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace sherd {

class BreakableSolid;  // internal: the sampled solid behind an asset

/// A solid that can break: a closed surface in metres, what it is made of, and (once it was struck) its
/// factored stress problem. Cheap to copy; copies share everything, and any number of bodies may be made from
/// one asset.
class BreakableAsset {
  public:
    /// Reads a Wavefront OBJ and checks it, or mends it where `repair` allows that. The error says everything
    /// that is wrong with the file or the surface, where, and what to do.
    static Result<BreakableAsset> fromObj(const std::string& path, const Material& material,
                                          const Settings& settings = {}, const Repair& repair = {});

    /// The same for a surface in memory.
    static Result<BreakableAsset> fromMesh(const TriangleMesh& surface, const Material& material,
                                           const Settings& settings = {}, const Repair& repair = {});

    /// The same body, held by the world on parts of its surface: these do not move in the stress of a blow.
    /// Bodies made of it are static (see BreakableOptions::supports). It is sampled and prepared apart from
    /// this asset; bodies that are held alike should be made of one. The error says which support touches no
    /// surface, or that they hold the body by no more than a line.
    Result<BreakableAsset> anchored(const std::vector<SurfaceRegion>& supports) const;

    /// Samples the solid, and assembles and factors its stress problem, now rather than at the first blow.
    /// The error says why that cannot be; blows would say the same.
    ///
    /// May be called from any thread while a world steps with bodies of this asset; the thread holds its own
    /// copy of the asset. A blow that needs this asset's factor waits for it: to avoid that, add the bodies
    /// only when `prepared`. FractureWorld::add and `particleCount` wait for the sampling only. Functions of
    /// the settings (strength field, guide field) are not called here, but in blows.
    Status prepare() const;

    /// Whether that is done. Never waits; from any thread.
    bool prepared() const;

    // These, too, may be called from any thread.
    const TriangleMesh& surface() const;
    /// What was changed in the mesh that the asset was made from.
    const RepairReport& repairs() const { return *repairs_; }
    /// What is probably not meant: a size that a slip in the file's unit explains better. The event of the
    /// first blow on each body says the same. Empty for fragments.
    const std::vector<std::string>& warnings() const { return *warnings_; }
    const Material& material() const;
    const Settings& settings() const;
    const std::vector<SurfaceRegion>& supports() const;  ///< empty: nothing holds it
    int particleCount() const;  ///< samples the solid at the first call; 0 if that cannot be
    double mass() const;        ///< kg
    double volume() const;      ///< m^3

    // Internal.
    explicit BreakableAsset(std::shared_ptr<const BreakableSolid> solid, const RepairReport& repairs = {},
                            std::vector<std::string> warnings = {})
        : solid_(std::move(solid)),
          repairs_(std::make_shared<const RepairReport>(repairs)),
          warnings_(std::make_shared<const std::vector<std::string>>(std::move(warnings))) {}
    const std::shared_ptr<const BreakableSolid>& solid() const { return solid_; }

  private:
    std::shared_ptr<const BreakableSolid> solid_;
    std::shared_ptr<const RepairReport> repairs_;
    std::shared_ptr<const std::vector<std::string>> warnings_;
};

}  // namespace sherd
