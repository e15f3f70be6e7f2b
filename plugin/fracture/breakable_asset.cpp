#include <sherd/breakable_asset.h>

#include "fracture/breakable_solid.h"
#include "geometry/surface_checks.h"

namespace sherd {

Result<BreakableAsset> BreakableAsset::fromObj(const std::string& path, const Material& material,
                                               const Settings& settings) {
    const Result<TriangleMesh> surface = readObj(path);
    if (!surface) return Error{surface.error()};
    Result<BreakableAsset> asset = fromMesh(surface.value(), material, settings);
    if (!asset) return Error{path + ": " + asset.error()};
    return asset;
}

Result<BreakableAsset> BreakableAsset::fromMesh(const TriangleMesh& surface, const Material& material,
                                                const Settings& settings) {
    if (const Status sound = checkSurface(surface); !sound) return Error{sound.error()};
    auto solid = BreakableSolid::make(surface, material, settings);
    if (!solid) return Error{solid.error()};
    return BreakableAsset(std::move(solid).value());
}

Status BreakableAsset::prepare() const {
    const auto solver = solid_->stressSolver();
    if (!solver) return Error{solver.error()};
    return success();
}

bool BreakableAsset::prepared() const {
    return solid_->prepared();
}

const TriangleMesh& BreakableAsset::surface() const {
    return solid_->surface();
}
const Material& BreakableAsset::material() const {
    return solid_->material();
}
const Settings& BreakableAsset::settings() const {
    return solid_->settings();
}
double BreakableAsset::mass() const {
    return solid_->mass();
}
double BreakableAsset::volume() const {
    return solid_->moments().volume;
}

int BreakableAsset::particleCount() const {
    const auto sampling = solid_->discretisation();
    return sampling ? static_cast<int>(sampling.value()->particles.size()) : 0;
}

}  // namespace sherd
