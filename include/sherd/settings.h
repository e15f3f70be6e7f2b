#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sherd {

// The defaults suit most bodies. `sherd/fields.h` lists the fields with their ranges, `sherd/enum_names.h`
// the names of the choices. "Asset frame" means the coordinates that a body's surface is given in. "Paper" is
// N. Liu, X. He, S. Li, G. Wang, Meshless simulation of brittle fracture, Computer Animation and Virtual
// Worlds 22 (2011).

/// How finely a solid is sampled.
struct SamplingSettings {
    /// Distance between particles. At 0 it is chosen from the wall thickness, within the limits below.
    double spacing_m = 0;
    // These five limits, and the coarsening of fragments, hold where the spacing is chosen. Where they cannot
    // all hold, the factor's come first, then the largest count, the smallest count and the layers.
    double layers_across_wall = 4;  ///< particles across a wall, about; the wall is StressModelReport's
    int smallest_count = 600;       ///< particles; thick bodies get more than the layers ask for
    int largest_count = 20000;      ///< particles, about
    /// How many millions of numbers the factor of the stiffness matrix may store: each takes 4 bytes,
    /// or 8 where the matrix is too ill-conditioned, and a solve reads all of them twice. Spline trial
    /// functions only.
    double largest_factor_millions = 9;
    /// The same limit where walls would otherwise get less than one particle across; not below it.
    double largest_factor_if_thin_millions = 14;
    /// Spacing of fragments over that of the whole, 1 to 4. Only large ones are factored ahead
    /// (Budget::prepared_fragments), on others the first blow pays for that: at 2 the largest ones take a
    /// third of the time that they take at 1.3, and 2 blows in 100 are decided in another way. Small
    /// fragments are finer than the whole all the same.
    double fragment_coarsening = 2;
    /// Integration cells per particle spacing and direction, 1 to 4.
    int cells_per_spacing = 2;
    /// Order of the moments that cut cells are integrated with: 0, 2, 4 or 6. The library sets it to twice
    /// the degree of the splines.
    int moment_order = 4;
    /// A grid cell of which a smaller share is solid gets no particle of its own; its material goes to a
    /// neighbour's.
    double smallest_fill = 0.25;

    Status validate() const;
};

/// Test function of the local weak form (paper, Eq. 5). MLPG: the meshless local Petrov-Galerkin method. All
/// three go with mls; gmls and spline go with galerkin alone, and mls has no cubic basis.
enum class TestFunction {
    /// MLPG5, as in the paper: the flux over the faces of sub-domains, here ones that tile the solid. The
    /// matrix is unsymmetric.
    heaviside,
    /// MLPG5 to the letter, to compare with: whole cubes, 96 Gauss points a particle. Slow.
    heaviside_paper,
    /// The trial functions themselves. The matrix is symmetric, and moments balance as well as forces.
    galerkin,
};

/// Trial functions of the displacement.
enum class TrialFunction {
    /// Moving least squares, paper Eq. 6-10: 3 unknowns a particle.
    mls,
    /// Generalised moving least squares, paper Eq. 11, with gradients as unknowns: 12 unknowns a particle.
    gmls,
    /// Moving least squares with B-splines as weights on a complete lattice: the shape functions are the
    /// B-splines themselves, of degree 1, 2 or 3 for a linear, quadratic or cubic basis.
    spline,
};

/// Polynomials that the trial functions reproduce.
enum class Basis { linear, quadratic, cubic };
constexpr int splineDegree(Basis basis) {
    return 1 + static_cast<int>(basis);
}
constexpr int largest_spline_degree = splineDegree(Basis::cubic);

/// How the stress problem is discretised.
struct StressSettings {
    TestFunction test_function = TestFunction::galerkin;
    TrialFunction trial_function = TrialFunction::spline;
    Basis basis = Basis::quadratic;
    /// How often the grid is made finer where it is too coarse for loads or for a high stress (paper, section
    /// 5), 0 to 4. Spline trial functions only.
    int resampling_rounds = 2;
    /// How far a finer grid reaches beyond the loads, at least, in cells of the coarser grid.
    double resampling_margin = 2;
    /// How many cells across a load are fine enough: no finer grid is made around it then. With 4 the largest
    /// stress at the rim of a contact comes out up to a quarter too low; 9 are right to 2 to 8 %.
    double resampling_cells = 4;
    /// How wrong a high stress may be, as a share of the largest tension, until the grid is made finer there:
    /// the traction that it has on the surface, where nothing acts.
    double resampling_error = 0.1;
    /// Whether blows in a world are resampled as well. It sharpens the stress at contacts, and at fillets and
    /// roots below the spacing; it takes longer than the rest of a blow. A StressModel always resamples.
    bool resample_contacts = false;
    /// Radius of the supports of mls and gmls, in particle spacings. At 0 it is 1.4 for gmls, 2.2 for mls
    /// with a linear basis and 2.8 with a quadratic one.
    double support_radius = 0;

    Status validate() const;
};

/// Where a solid is strong and where it is weak, beside what its material says.
struct StrengthSettings {
    /// Of how the material's strength scatters from place to place. Bodies with a seed of their own
    /// (BreakableOptions::seed) scatter each in a way of their own, for each value of this one.
    std::uint64_t seed = 1;
    /// What the strength at x (m, asset frame) is multiplied with, above 0; empty: 1 everywhere. An artist's
    /// way to say where a body breaks (paper, section 6.2); `strengthFromColours` makes one of a painted
    /// mesh. Called during a blow, on the thread that steps, for every point where stress is read: some ten
    /// thousand a body, once, and again for its fragments. If it throws, the blow fails and the body stays
    /// whole.
    std::function<double(const Vec3& x)> field;
    /// What `field` is nowhere below; 0: not known, and then weak blows are solved too. Where it is known, a
    /// blow that is too weak for any place of the body is skipped. A smaller value of the field makes the
    /// blow fail.
    double field_minimum = 0;

    Status validate() const;
};

/// How impulses become loads: by a Hertz contact, with these limits.
struct ContactSettings {
    /// Elastic constants of a partner that is not breakable itself. The defaults suit rock.
    double partner_youngs_modulus_pa = 5e10;
    double partner_poisson_ratio = 0.25;
    /// Duration of a contact, at least.
    double shortest_contact_s = 2e-5;
    /// Radius of the loaded patch, and of the curvature that the contact is given, at least this fraction of
    /// the wall thickness.
    double smallest_patch = 0.25;
    /// Radius of the loaded patch, at most this fraction of the radius of the sphere about the centre of mass
    /// that holds the body.
    double largest_patch = 0.5;

    Status validate() const;
};

/// A direction at every point along which fragments grow (paper, section 6.2 and Eq. 18). Asset frame.
struct GuideField {
    enum class Kind {
        none,      ///< no direction is preferred
        constant,  ///< `direction`: the grain of wood
        /// Away from the axis of the blow, as in glass. Cracks go straight through, along the axis, too.
        radial,
        custom,  ///< what the function `custom` returns
    };
    Kind kind = Kind::none;
    Vec3 direction = Vec3::UnitZ();  ///< of any length
    /// The direction at x (m) after a blow at `contact` (m), of any length; zero: none is preferred there.
    /// Called in a blow, on the stepping thread. If it throws or is not finite, the body stays whole.
    std::function<Vec3(const Vec3& x, const Vec3& contact)> custom;
    /// Cost of a distance along the field relative to the same distance across it, 0 to 1 (lambda of Eq. 18).
    /// A particle belongs to the fragment whose seed it reaches at the least cost: at 0 fragments run through
    /// the whole damaged part along the field; at 1 the field does nothing.
    double cost_along = 0.2;

    Status validate() const;
};

/// How the damaged part of a body is split into clusters (paper, section 6.2).
enum class CrackPattern {
    /// Cracks cut the damaged part in two, and again, until there are as many pieces as are wanted. Each runs
    /// straight through, where it costs least: it is short, and the largest tension of the blow acts at right
    /// angles to it. Pieces grow with the distance from the blow. With CollisionShape::boxes: `seeds`.
    stress,
    /// The paper's: every particle belongs to the nearest of seeds (Eq. 18); the stress says only how dense
    /// these are.
    seeds,
};

/// What becomes of pieces below `FractureSettings::smallest_fragment_m3`.
enum class Debris {
    unbreakable,  ///< bodies as the others, that never break again
    merged,   ///< parts of the neighbour that they share most surface with; by the volume of particles, so
              ///< that a piece may still come out a few percent smaller
    dropped,  ///< never enter the world (the largest piece always does); the event says how much mass they
              ///< had
};

/// What stands for a body in collisions: for bodies of `FractureWorld::add` and for all fragments. A body
/// that `makeBreakable` is given keeps the shape that it has; its fragments get what is set here.
enum class CollisionShape {
    /// A box where a whole body is one, one convex hull where a piece is nearly convex, a few where it is
    /// hollow or bent (`largest_collision_part_count`): a hollow stays open, a shallow one is closed.
    automatic,
    /// Filled cells of the sampling, merged: hollows stay open, surfaces are stairs of about half a particle
    /// spacing. Pieces do not come to rest on stairs, and steps take ten times as long.
    boxes,
    /// One convex hull (or that box), the quickest: hollows are closed, so nothing falls into a cup.
    hull,
    /// Hulls of up to 24 parts, which follow the surface more closely than those of `automatic`.
    convex_parts,
};

/// How a body breaks. Two bodies of one asset may differ in these; fragments have those of the body that
/// they came from.
struct FractureSettings {
    /// Of where cracks run. Another seed, another break; the same seeds, the same break bit for bit.
    std::uint64_t seed = 1;
    ContactSettings contact;
    /// How often the stress of a blow is solved at most, each time without the particles that are damaged by
    /// then, until no more are (paper, section 6.1). Spline trial functions only. By default the damage of
    /// the first solve counts: every further one takes as long as a first blow, and leaves the blow's energy
    /// to more damaged material, in fewer pieces.
    int damage_waves = 1;
    /// Clusters that the damaged part is split into; each undamaged part is one piece more. At 0 they are as
    /// many as the strain energy pays for.
    int fragment_count = 0;
    /// Fraction of the strain energy that goes into crack faces, above 0 and at most 1: as many pieces are
    /// planned. Cracks that come out larger are cut as long as they cost no more than four times that, or all
    /// of the energy (CrackPattern::stress).
    double energy_into_cracks = 0.05;
    /// Pieces of one break at most, the undamaged ones included; `fragment_count` is not above it. A body of
    /// several solids breaks into these at least.
    int largest_fragment_count = 20;
    /// Of what is damaged fewer pieces are made where they would be smaller than this on average, and a body
    /// below it never breaks. Pieces that come out smaller all the same are debris. At 0 it is 1/200 of the
    /// body that was whole at first; fragments keep it.
    double smallest_fragment_m3 = 0;
    Debris debris = Debris::unbreakable;
    CrackPattern crack_pattern = CrackPattern::stress;
    GuideField guide;  ///< with either pattern
    /// How far crack faces are displaced at most, as a fraction of the particle spacing, 0 to 0.5. Both sides
    /// of a crack fit.
    double crack_roughness = 0;
    /// Hulls and convex parts of neighbouring fragments may overlap when they are made. Such pairs collide,
    /// but only what they sink deeper into each other later pushes them apart.
    CollisionShape collision_shape = CollisionShape::automatic;
    /// Convex hulls that stand for one body at most, with CollisionShape::automatic.
    int largest_collision_part_count = 8;
    /// Fragments cannot break for this time after they were made. A very large value lets them never break.
    /// Those that supports hold come out of these all the same (same_blow_s).
    double rest_after_break_s = 0;
    /// For this time after they were made, fragments cannot be broken by what belongs to the same blow: the
    /// bodies that touched the one that broke, what came of these, and other fragments as young as they are.
    /// What else strikes them does so as it would strike any body. Fragments that supports still hold stand
    /// in the way of what broke the whole: what is twice as heavy as one or more tears it out of its supports
    /// in one piece (Outcome::broke with one fragment, Level::gate); what is half as heavy as the part of it
    /// that lies within the striker's own size, or more, breaks it at once; and what is lighter is stopped.
    double same_blow_s = 0.05;
    /// How often a body may break in turn: at 1 its fragments never break, at 2 theirs never do. At 0 there
    /// is no limit.
    int largest_generation = 0;
    /// Whether blows on a prepared asset are decided by its reduced model (BreakableAsset::prepare), which
    /// takes milliseconds, or fully.
    bool use_reduced_model = true;
    /// Whether blows on fragments are looked at on a coarse grid first (Level::coarse), which takes a part of
    /// the time of a full solve and decides most blows that hold. Splines up to quadratic ones only.
    bool use_coarse_model = true;
    /// For finding out how far cheap decisions can be trusted: every blow that something else than a full
    /// solve decides is solved fully as well, and its event says what came of that
    /// (`BlowFigures::full_solve_outcome`). Changes nothing in the world, and costs a full solve a blow.
    bool check_with_full_solve = false;

    Status validate() const;
};

/// How much accuracy a scene needs; the README shows what each costs.
enum class Quality {
    preview,  ///< which parts are loaded, and about how much
    game,     ///< the defaults
    film,     ///< as right as fine finite elements
};

/// What an asset is made with. All but `fracture` belongs to the asset, and all its bodies share it.
struct Settings {
    /// The defaults with the sampling and the stress solve of a quality.
    static Settings forQuality(Quality quality);

    /// Reads a JSON file with the fields of these structs by name, `{"sampling": {"spacing_m": 0.02}}`; the
    /// rest of `sampling` and `stress` are those of the quality that `"quality"` names, `game` without it.
    /// Functions cannot be given. The error names the file and the field, and says what is possible there.
    static Result<Settings> fromJsonFile(const std::string& path);

    /// Reads the same from text. `key` is where it stands in a larger file ("bodies[0].settings"), for the
    /// error.
    static Result<Settings> fromJson(const std::string& text, const std::string& key = "");

    /// All fields as a JSON object, but functions and what the library sets itself. `fromJson` reads it
    /// back bit for bit, unless the guide field is `custom`, which only a program can set.
    std::string toJson() const;

    /// Sets fields by their paths: "sampling.spacing_m=0.02", "stress.basis=cubic",
    /// "fracture.guide.direction=[0,1,0]". A value is JSON; what is no JSON is text. The error says which
    /// path or value is not possible, and what is; then no field is changed.
    Status set(const std::vector<std::string>& assignments);

    SamplingSettings sampling;
    StressSettings stress;
    StrengthSettings strength;
    /// Of the bodies that are given none of their own (BodyOptions::fracture).
    FractureSettings fracture;

    /// The error says which field is out of range, and which values are possible.
    Status validate() const;
};

}  // namespace sherd
