#include <sherd/breakable_asset.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

#include "core/numerics/thread_priority.h"
#include "fracture/baked_asset.h"
#include "fracture/breakable_solid.h"
#include "fracture/supports.h"
#include "geometry/shells.h"

namespace sherd {

namespace {

/// One for all: every fragment has it, and there may be very many. Never destroyed, as worlds may end last.
template <class T>
const std::shared_ptr<const T>& emptyOne() {
    static const auto& empty = *new std::shared_ptr<const T>(std::make_shared<const T>());
    return empty;
}

}  // namespace

BreakableAsset::BreakableAsset(std::shared_ptr<const BreakableSolid> solid)
    : BreakableAsset(std::move(solid), emptyOne<RepairReport>(), emptyOne<std::vector<std::string>>()) {}

BreakableAsset::BreakableAsset(std::shared_ptr<const BreakableSolid> solid,
                               std::shared_ptr<const RepairReport> repairs,
                               std::shared_ptr<const std::vector<std::string>> warnings)
    : solid_(std::move(solid)), repairs_(std::move(repairs)), warnings_(std::move(warnings)) {}

Result<BreakableAsset> BreakableAsset::fromObj(const std::string& path, const Material& material,
                                               const Settings& settings, const Repair& repair) {
    const Result<TriangleMesh> surface = readObj(path);
    if (!surface) return Error{surface.error()};
    Result<BreakableAsset> asset = fromMesh(surface.value(), material, settings, repair);
    if (!asset) return Error{path + ": " + asset.error()};
    return asset;
}

namespace {

/// Of numbers that no brittle material has, but that its table has in another unit. One that is scaled with
/// the density (Material::withDensity) is right: sound is no faster in it than in others.
std::vector<std::string> unitWarnings(const Material& material) {
    std::vector<std::string> warnings;
    const auto warn = [&](const char* name, double value, double least, const char* unit) {
        if (value >= least) return;
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << "The material's " << name << " is " << value << ", less than that of any usual one; is it in "
             << unit << "?";
        warnings.push_back(text.str());
    };
    constexpr double lightest_kg_m3 = 5;
    const double lighter = std::min(1.0, material.density_kg_m3 / lightest_kg_m3);
    warn("youngs_modulus_pa", material.youngs_modulus_pa, 1e6 * lighter, "Pa, not in GPa or MPa");
    warn("tensile_strength_pa", material.tensile_strength_pa, 500 * lighter, "Pa, not in MPa");
    constexpr double fastest_m_s = 30000;  // sound, in any material
    if (material.youngs_modulus_pa > fastest_m_s * fastest_m_s * material.density_kg_m3)
        warn(
            "density_kg_m3", material.density_kg_m3, lightest_kg_m3,
            "kg/m^3, not in g/cm^3? That of a body of the program's own (makeBreakable) is its mass over its "
            "volume: if it is to be as light as that, Material::withDensity makes it break at the speeds at "
            "which a heavy one does. Is that as it should be");
    return warnings;
}

}  // namespace

Result<BreakableAsset> BreakableAsset::fromMesh(const TriangleMesh& surface, const Material& material,
                                                const Settings& settings, const Repair& repair) {
    Result<RepairedMesh> sound = repairMesh(surface, repair);
    if (!sound) return Error{sound.error()};
    auto solid = BreakableSolid::make(std::move(sound.value().mesh), material, settings);
    if (!solid) return Error{solid.error()};
    std::vector<std::string> warnings;
    constexpr double heaviest_usual_kg = 20000;
    const double kilograms = solid.value()->mass();
    if (const std::string size = sizeWarning(solid.value()->surface()); !size.empty())
        warnings.push_back(size);
    else if (kilograms > heaviest_usual_kg)
        warnings.push_back(
            "The body weighs " + std::to_string(std::lround(kilograms)) +
            " kg; if its mesh or shape is not in metres, scale it (Repair::scale does while a file is "
            "read).");
    if (const int solids = solidCount(solid.value()->surface()); solids > 1)
        warnings.push_back("The body is " + std::to_string(solids) +
                           " solids that do not touch: they move as one until a blow breaks it. Give each a "
                           "body of its own if they are things of their own, or close the gaps if they are "
                           "one.");
    for (std::string& unit : unitWarnings(material)) warnings.push_back(std::move(unit));
    return BreakableAsset(std::move(solid).value(),
                          std::make_shared<const RepairReport>(std::move(sound).value().report),
                          std::make_shared<const std::vector<std::string>>(std::move(warnings)));
}

Status BreakableAsset::save(const std::string& path) const {
    Result<BakedSolid> solid = solid_->baked();
    if (!solid) return Error{solid.error()};
    BakedAsset baked{std::move(solid).value(), *repairs_, *warnings_};
    return saveBaked(baked, path);
}

Result<BreakableAsset> BreakableAsset::load(const std::string& path) {
    Result<BakedAsset> read = loadBaked(path);
    if (!read) return Error{read.error()};
    BakedAsset& baked = read.value();
    return BreakableAsset(BreakableSolid::fromBaked(std::move(baked.solid)),
                          std::make_shared<const RepairReport>(baked.repairs),
                          std::make_shared<const std::vector<std::string>>(std::move(baked.warnings)));
}

Result<BreakableAsset> BreakableAsset::anchored(const std::vector<SurfaceRegion>& supports) const {
    if (supports.empty())
        return Error{"no support was given to hold the body on; name parts of its surface (SurfaceRegion)"};
    const auto points = pointsOfSupports(surface(), supports, solid_->spacing());
    if (!points) return Error{points.error()};
    if (supportsThatHold(surface(), supports, solid_->spacing(), solid_->wallThickness()).empty())
        return Error{
            "the supports hold the body by no more than a line or a point, about which it can turn; give "
            "them more of its surface"};
    if (const SurfaceRegion* support = supportThatHoldsAll(surface(), supports, points.value()))
        return Error{"nothing can come loose of the body, since " + describe(*support) +
                     " holds all of its surface; name the parts by which it is held, in m and in the "
                     "coordinates of its mesh"};
    return BreakableAsset(solid_->anchoredTogether(supports), repairs_, warnings_);
}

Status BreakableAsset::prepare(const std::function<void(double done)>& progress) const {
    return solid_->prepare(progress);
}

std::future<Status> BreakableAsset::prepareOnThread(std::function<void(double done)> progress) const {
    return std::async(std::launch::async, [asset = *this, progress = std::move(progress)] {
        yieldToOtherThreads();
        return asset.prepare(progress);
    });
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
double BreakableAsset::tensileStrength(const Vec3& x) const {
    return solid_->strength().at().at(x);
}
bool BreakableAsset::isSameAs(const BreakableAsset& other) const {
    if (solid_ == other.solid_) return true;
    const TriangleMesh &own = surface(), &others = other.surface();
    return own.vertices == others.vertices && own.triangles == others.triangles &&
           own.kinds == others.kinds && own.texture_coordinates == others.texture_coordinates &&
           own.normals == others.normals && own.material == others.material &&
           own.materials == others.materials && own.colours == others.colours &&
           material().toJson() == other.material().toJson() &&
           settings().toJson() == other.settings().toJson() && supports() == other.supports();
}
BreakableAsset BreakableAsset::ofBody(std::uint64_t seed) const {
    return BreakableAsset(solid_->ofBody(seed), repairs_, warnings_);
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

int BreakableAsset::unknownCount() const {
    return solid_->unknownCount();
}

}  // namespace sherd
