#pragma once

#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/damage/failure_criterion.h"
#include "core/loads/surface_tree.h"
#include "core/mlpg/reduced/reduced_stress.h"
#include "core/mlpg/solvers/coarse_model.h"
#include "core/mlpg/stress_solver.h"
#include "core/numerics/made_once.h"
#include "core/sampling/discretisation.h"
#include "fracture/baked_solid.h"
#include "fracture/body_strength.h"
#include "geometry/cutting/cuttable_solid.h"

namespace sherd {

/// The solid behind an asset: surface, constants, and what is made from them once and kept. Sampling and
/// factor are made when first needed; all else never changes. All members may be called from several
/// threads at once. A thread waits only for the one thing that it needs, while another thread makes it.
class BreakableSolid {
  public:
    /// Makes a solid of a surface that `checkSurface` accepts. The error says which constant or setting is
    /// out of range. On `supports` the displacement is zero; a solid without any is free.
    static Result<std::shared_ptr<const BreakableSolid>> make(TriangleMesh surface, const Material& material,
                                                              const Settings& settings,
                                                              std::vector<SurfaceRegion> supports = {});

    /// The solid that `baked` gave, prepared.
    static std::shared_ptr<const BreakableSolid> fromBaked(BakedSolid baked);
    /// What a file keeps of this solid; prepares it. The error says why it cannot be had.
    Result<BakedSolid> baked() const;

    const TriangleMesh& surface() const { return shared_->surface; }
    /// For what is near a contact; made at the first call.
    const SurfaceTree& surfaceTree() const;
    const Material& material() const { return material_; }
    const Settings& settings() const { return settings_; }
    /// The criterion that the material names.
    const FailureCriterion& failureCriterion() const;
    const Moments& moments() const { return moments_; }
    const std::vector<SurfaceRegion>& supports() const { return supports_; }
    bool isAnchored() const { return !supports_.empty(); }
    double mass() const { return material_.density_kg_m3 * moments_.volume; }
    double wallThickness() const { return wall_thickness_; }
    double boundingRadius() const { return bounding_radius_; }
    /// Particle spacing: the one given, or chosen from wall thickness and the limits of the settings.
    double spacing() const { return spacing_; }
    /// Between the points that stand for loads and supports on a part of the surface.
    double quadratureSpacing() const;

    /// Particles and cells; sampled at the first call. That of a solid from a file, or that was prepared
    /// before anything else asked for it, has no surface points.
    Result<std::shared_ptr<const Discretisation>> discretisation() const;
    /// The sampling that stress problems are made of and their stress is read at: the same with all that such
    /// a solid leaves out; it is sampled anew at the first call.
    Result<std::shared_ptr<const Discretisation>> completeDiscretisation() const;
    /// The factored stress problem; assembled and factored at the first call.
    Result<const StressSolver*> stressSolver() const;
    /// Makes what answers blows without a factor, or the factor where that cannot be.
    Status prepare(const Progress& progress) const;
    /// Makes what finds and cuts surfaces, milliseconds for which the first blow would wait; samples it.
    void prepareSurface() const;
    /// Makes what answers blows without a factor; the error says why that cannot be.
    Status makeReduced(const Progress& progress) const;
    /// What these made to answer blows without a factor; nullptr if it did not. Never waits.
    const ReducedStress* reducedStress() const;
    /// For a first look at a blow on a fragment. Not kept: it is made in milliseconds.
    Result<CoarseModel> makeCoarseModel() const;
    /// Whether `makeFragment` made it.
    bool isFragment() const { return is_fragment_; }
    /// The same anew, without the particles that are `damaged` (#particles). Not kept.
    Result<StressSolver> stressSolverWithout(const std::vector<char>& damaged,
                                             Precision precision = Precision::refined) const;
    /// From the material, the seed and the settings' strength field. Fragments have that of the whole.
    const BodyStrength& strength() const { return *strength_; }
    /// For cutting it; made at the first call.
    const CuttableSolid& cuttable(const Discretisation& sampling) const;
    /// Of its particles, see wall_axes.h; found at the first call.
    const std::vector<Vec3>& wallAxes(const Discretisation& sampling) const;
    /// Least elastic energy of a particle that fails, J, whatever the sampling makes of the solid.
    double smallestFailureEnergy() const;
    /// What the sampling took; 0 until it is done. Never waits.
    double sampleMilliseconds() const;
    /// Of the stress problem, 0 until it is made. Never waits.
    int unknownCount() const;
    /// Whether the factored stress problem is there already. Never waits.
    bool isFactored() const;
    /// Whether a blow finds the factored stress problem there already, or the reduced model, or is decided
    /// as if it did (`expectFactor`). Never waits.
    bool hasSolver() const;
    /// For who has the stress problem made on another thread: what comes of a blow must not depend on whether
    /// that is done.
    void expectFactor() const { shared_->expects_factor = true; }
    bool expectsFactor() const { return shared_->expects_factor; }
    /// Whether `prepare` is done. Never waits.
    bool prepared() const { return shared_->prepared; }

    /// The same solid held on `supports` instead of its own; sampled and factored anew.
    std::shared_ptr<const BreakableSolid> anchored(std::vector<SurfaceRegion> supports) const;
    /// The same solid without a factored stress problem of its own yet; all else is made once for both.
    std::shared_ptr<const BreakableSolid> unsolved() const;
    /// One like it, for all who hold the solid alike for as long as one of them does.
    std::shared_ptr<const BreakableSolid> anchoredTogether(const std::vector<SurfaceRegion>& supports) const;
    /// The same solid as that of one body: its strength scatters in another way for each seed. All else that
    /// is made once is made for both.
    std::shared_ptr<const BreakableSolid> ofBody(std::uint64_t seed) const;
    /// A piece of this solid: same material, settings and limits, and those supports that hold it.
    std::shared_ptr<const BreakableSolid> makeFragment(TriangleMesh surface) const;

  private:
    BreakableSolid(const BreakableSolid&) = default;
    BreakableSolid(TriangleMesh surface, const Material& material, const Settings& settings);
    explicit BreakableSolid(BakedSolid baked);

    struct Sampled {
        Result<std::shared_ptr<const Discretisation>> discretisation;
        double ms = 0;
        bool is_complete = true;  ///< else it lacks what only the making of a stress problem needs
    };
    /// What the solids of all bodies of an asset share. A sampling or factorisation that failed is kept as
    /// its sentence, and not tried again.
    struct Shared {
        explicit Shared(TriangleMesh its_surface) : surface(std::move(its_surface)) {}

        const TriangleMesh surface;
        MadeOnce<SurfaceTree> tree;
        MadeOnce<CuttableSolid> cuttable;
        MadeOnce<std::vector<Vec3>> wall_axes;
        MadeOnce<Sampled> sampled;
        MadeOnce<Result<std::shared_ptr<const ReducedStress>>> reduced;
        MadeOnce<double> smallest_failure_energy;
        std::atomic<bool> prepared{false}, expects_factor{false};
        MadeOnce<Sampled> complete;  ///< where `sampled` is not
        std::mutex holding;
        std::vector<std::weak_ptr<const BreakableSolid>> held;  ///< by `anchoredTogether`
    };

    std::shared_ptr<Shared> shared_;
    std::shared_ptr<MadeOnce<Result<StressSolver>>> solver_ =
        std::make_shared<MadeOnce<Result<StressSolver>>>();
    Material material_;
    Settings settings_;
    std::vector<SurfaceRegion> supports_;
    Moments moments_;
    double bounding_radius_ = 0, wall_thickness_ = 0;
    double spacing_ = 0, spacing_of_whole_ = 0;  ///< the latter of what it is a fragment of
    std::shared_ptr<const BodyStrength> strength_;
    bool is_fragment_ = false;

    Sampled sampled() const;
    Result<StressSolver> solverOn(const Result<std::shared_ptr<const Discretisation>>& sampled,
                                  const std::vector<char>& damaged, Precision precision) const;
    /// Makes the strength, which scatters over that distance.
    void scatterOver(double length_m);
    /// Of the material that fails together at least, m^3: of a particle, or of a wall that is thinner than
    /// those.
    double cellVolume() const;
};

}  // namespace sherd
