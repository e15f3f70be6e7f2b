#pragma once

#include <sherd/material.h>
#include <sherd/repair.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <cstdint>
#include <functional>
#include <future>
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

    /// Reads what `save` or `sherd bake` wrote: an asset that is prepared, and whose bodies break as those of
    /// the one that was saved do, bit for bit (with the same BLAS on the same kind of processor). It takes
    /// some milliseconds; nothing is sampled, solved or factored. What a blow cannot be answered without (see
    /// `prepare`) is made then. What finds and cuts its surface is made when the first body is added, in some
    /// tens of milliseconds, or before that by `prepareOnThread`.
    ///
    /// A file belongs to the version of its format that the library writes. The version rises when anything
    /// changes that a file holds, and files of another one are refused: keep the mesh, and bake it again. The
    /// error names the file and says whether it is missing, empty, cut short, of another version, or changed
    /// since it was written.
    static Result<BreakableAsset> load(const std::string& path);

    /// Whether another asset has the same surface, material, settings and supports: whether what `load` gave
    /// is what the program would bake now. Repairs are not compared, nor is a strength that a function of
    /// the app's gives.
    bool isSameAs(const BreakableAsset& other) const;

    /// Writes the asset for `load`: surface with all attributes, material, settings, supports, repairs and
    /// warnings, and what `prepare` makes, which is made now if it is not there. About 10 MB at
    /// Quality::game. A file of that name is replaced only when the new one is complete.
    ///
    /// From any thread, as `prepare`. Numbers are stored with their lowest byte first, and only processors of
    /// that kind can write and read them. The error says why the file cannot be written, or what of the asset
    /// a file cannot hold: functions in the settings, trial functions other than splines, and finer grids
    /// around contacts (StressSettings::resample_contacts).
    Status save(const std::string& path) const;

    /// The same body, held by the world on parts of its surface: these do not move in the stress of a blow.
    /// Bodies made of it are static (see BreakableOptions::supports). It is sampled and prepared apart from
    /// this asset, once for all bodies and assets that hold it on the same supports: what one call returned
    /// is what the next one returns, for as long as somebody keeps it. The error says which support touches
    /// no surface, that one of them holds all of it, or that they hold the body by no more than a line.
    Result<BreakableAsset> anchored(const std::vector<SurfaceRegion>& supports) const;

    /// Samples the solid and makes what answers blows in milliseconds, now: a reduced model of its stress,
    /// about 10 MB, in some seconds. Blows on its bodies that fall before that is done, and all blows on an
    /// asset that is not prepared, factor its stress problem instead (half a second to seconds and 40 to 200
    /// MB, once). The reduced model's largest stress is within about 1 % of the full solve's. Where it cannot
    /// be made (trial functions other than splines, resampled contacts, tiny or very slender solids) or is
    /// not wanted (FractureSettings::use_reduced_model) the factor is made instead. `progress` is told the
    /// share that is done, 0 to 1, on the thread that prepares. The error says why that cannot be; blows
    /// would say the same.
    ///
    /// May be called from any thread while a world steps with bodies of this asset; the thread holds its own
    /// copy of the asset. It takes all cores at the priority of the calling thread, so that steps take longer
    /// meanwhile: `prepareOnThread` does not. FractureWorld::add and `particleCount` wait for the sampling
    /// only. Functions of the settings (strength field, guide field) are not called here, but in blows.
    Status prepare(const std::function<void(double done)>& progress = {}) const;

    /// The same on a thread of its own, which with its helpers takes only what time other threads leave (on
    /// Linux). Keep the future: its destructor waits for the end.
    [[nodiscard]] std::future<Status> prepareOnThread(std::function<void(double done)> progress = {}) const;

    /// Whether `prepare` is done, which `save` does too, or `load` gave the asset. Never waits; from any
    /// thread.
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
    int unknownCount() const;   ///< of the stress problem; 0 until it is prepared or factored
    double mass() const;        ///< kg
    double volume() const;      ///< m^3
    /// The material's tensile strength at the point x (m, asset frame), Pa, as it is scattered and as the
    /// strength field has it. It belongs to the point: all qualities have the same, and a fragment has what
    /// the body that it came from had there, to the last bit. Calls the strength field, and throws what that
    /// throws, or std::invalid_argument where it is out of range.
    double tensileStrength(const Vec3& x) const;

    // Internal.
    /// Of a surface that nothing was changed in, and that nothing is to be said of: a fragment.
    explicit BreakableAsset(std::shared_ptr<const BreakableSolid> solid);
    const std::shared_ptr<const BreakableSolid>& solid() const { return solid_; }
    /// The asset of one body, which has a seed of its own.
    BreakableAsset ofBody(std::uint64_t seed) const;

  private:
    BreakableAsset(std::shared_ptr<const BreakableSolid> solid, std::shared_ptr<const RepairReport> repairs,
                   std::shared_ptr<const std::vector<std::string>> warnings);

    std::shared_ptr<const BreakableSolid> solid_;
    std::shared_ptr<const RepairReport> repairs_;
    std::shared_ptr<const std::vector<std::string>> warnings_;
};

}  // namespace sherd
