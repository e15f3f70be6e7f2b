#include <sherd/breakable_asset.h>

#include "fracture/breakable_solid.h"
#include "fracture/supports.h"

namespace sherd {

Result<BreakableAsset> BreakableAsset::fromObj(const std::string& path, const Material& material,
                                               const Settings& settings, const Repair& repair) {
    const Result<TriangleMesh> surface = readObj(path);
    if (!surface) return Error{surface.error()};
    Result<BreakableAsset> asset = fromMesh(surface.value(), material, settings, repair);
    if (!asset) return Error{path + ": " + asset.error()};
    return asset;
}

Result<BreakableAsset> BreakableAsset::fromMesh(const TriangleMesh& surface, const Material& material,
                                                const Settings& settings, const Repair& repair) {
    Result<RepairedMesh> sound = repairMesh(surface, repair);
    if (!sound) return Error{sound.error()};
    auto solid = BreakableSolid::make(std::move(sound.value().mesh), material, settings);
    if (!solid) return Error{solid.error()};
    std::vector<std::string> warnings;
    if (const std::string size = sizeWarning(solid.value()->surface()); !size.empty())
        warnings.push_back(size);
    return BreakableAsset(std::move(solid).value(), sound.value().report, std::move(warnings));
}

Result<BreakableAsset> BreakableAsset::anchored(const std::vector<SurfaceRegion>& supports) const {
    if (supports.empty())
        return Error{"no support was given to hold the body on; name parts of its surface (SurfaceRegion)"};
    if (const auto points = pointsOfSupports(surface(), supports, solid_->spacing()); !points)
        return Error{points.error()};
    if (supportsThatHold(surface(), supports, solid_->spacing()).empty())
        return Error{
            "the supports hold the body by no more than a line or a point, about which it can turn; give "
            "them "
            "more of its surface"};
    return BreakableAsset(solid_->anchored(supports), *repairs_, *warnings_);
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
const std::vector<SurfaceRegion>& BreakableAsset::supports() const {
    return solid_->supports();
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
