#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <cstdint>
#include <functional>

namespace sherd {

/// How finely a solid is sampled.
struct SamplingSettings {
    double spacing_m = 0;  ///< distance between particles; 0: from the wall thickness and the limits below
    double layers_across_wall = 4;  ///< particles across a wall, at most, when the spacing is chosen
    int smallest_count = 600;       ///< particles of a compact body, at least, when the spacing is chosen
    int largest_count = 20000;      ///< about this many particles at most, when the spacing is chosen
    /// Millions of numbers that the factor of the stiffness matrix may store, when the spacing is chosen:
    /// each takes 8 bytes, and a solve reads all of them twice. Splines only.
    double largest_factor_millions = 9;
    double largest_factor_if_thin_millions =
        14;                     ///< the same where walls would get less than one particle across
    int cells_per_spacing = 2;  ///< integration cells per particle spacing and direction, 1 to 4
    int moment_order = 4;  ///< of the cells' moments; an asset sets it to twice the degree of its splines
    double smallest_fill = 0.25;  ///< a cell filled by less gets no particle of its own

    Status validate() const;
};

/// Test function of the local weak form (paper, Eq. 5).
enum class TestFunction {
    heaviside,  ///< MLPG5, the paper: flux over the faces of sub-domains, which tile the solid; unsymmetric
    heaviside_paper,  ///< MLPG5 to the letter, to compare with: whole cubes, 96 Gauss points a particle; slow
    galerkin,         ///< the trial functions themselves: symmetric, and moments balance as well as forces
};

/// What a particle carries.
enum class TrialFunction {
    mls,     ///< moving least squares, paper Eq. 6-10: 3 unknowns a particle
    gmls,    ///< generalised moving least squares, paper Eq. 11, with gradients as unknowns: 12 unknowns a
             ///< particle
    spline,  ///< moving least squares with B-splines as weights on a complete lattice (Eq. 6-10): the shape
             ///< functions are the B-splines themselves; degree 1, 2, 3 for basis linear, quadratic, cubic
};

enum class Basis { linear, quadratic, cubic };
inline int splineDegree(Basis basis) {
    return 1 + static_cast<int>(basis);
}

/// How the stress problem is discretised.
struct StressSettings {
    TestFunction test_function = TestFunction::galerkin;
    TrialFunction trial_function = TrialFunction::spline;
    Basis basis = Basis::quadratic;
    /// How often the grid is made finer around loads that it is too coarse for (paper, section 5), 0 to 4.
    /// Splines only.
    int resampling_rounds = 2;
    double resampling_margin =
        2;  ///< of the finer grid beyond the loads, in cells of the coarser one, at least
    double support_radius =
        0;  ///< in particle spacings; 0: the form's own default (gmls 1.4, mls 2.2, quadratic 2.8)

    Status validate() const;
};

/// How impulses become loads.
struct ContactSettings {
    double partner_youngs_modulus_pa = 5e10;  ///< of whatever strikes and is not breakable (stone)
    double partner_poisson_ratio = 0.25;
    double shortest_contact_s = 2e-5;
    double longest_contact_s = 1e-2;
    double smallest_patch = 0.25;  ///< radius of the load patch, at least this fraction of the wall thickness
    double largest_patch = 0.5;    ///< radius of the load patch, at most this fraction of the body's radius

    Status validate() const;
};

/// A direction at every point along which fragments grow (paper, section 6.2 and Eq. 18). Asset frame.
struct GuideField {
    enum class Kind {
        none,      ///< no direction is preferred
        constant,  ///< `direction`: the grain of wood
        radial,    ///< away from the axis of the blow: glass. Cracks go straight through, along the axis, too
        custom,    ///< what `custom` returns
    };
    Kind kind = Kind::none;
    Vec3 direction = Vec3::UnitZ();  ///< of any length
    /// The direction at x (m) after a blow at `contact` (m), of any length; zero: none is preferred there.
    std::function<Vec3(const Vec3& x, const Vec3& contact)> custom;
    /// Lambda of Eq. 18, 0 to 1: what a distance along the field counts for, against one across it. At 0
    /// fragments run through the whole damaged part; at 1 the field does nothing.
    double penalty = 0.2;

    Status validate() const;
};

/// What becomes of pieces below `FractureSettings::smallest_fragment_m3`.
enum class Debris {
    unbreakable,  ///< bodies as the others, that never break again
    merged,       ///< parts of the neighbour that they share most with
    dropped,      ///< out of the world at once; the event says how much mass went with them
};

/// What stands for a body in collisions: for bodies of `FractureWorld::add` and for all fragments. A body
/// that `makeBreakable` is given keeps the shape that it has; its fragments get what is set here.
enum class CollisionShape {
    boxes,  ///< filled cells of the sampling, merged: hollows stay open, surfaces are stairs of about half a
            ///< particle spacing
    hull,   ///< one convex hull, the quickest: hollows are closed, so nothing falls into a cup
    convex_parts,  ///< hulls of up to 24 parts that follow the surface: hollows stay open, faces are smooth
};

/// How damaged material becomes fragments.
struct FractureSettings {
    std::uint64_t seed = 1;
    /// What the strength at x (m, asset frame) is multiplied with, above 0; empty: 1 everywhere. An artist's
    /// way to say where a body breaks (paper, section 6.2); `strengthFromColours` makes one of a painted
    /// mesh.
    std::function<double(const Vec3& x)> strength_field;
    /// What `strength_field` is nowhere below; 0: not known. Where it is known, a blow that is too weak for
    /// any place of the body is skipped; the field itself is asked only once a blow is solved. A field that
    /// is found below it fails the blow with a sentence.
    double strength_field_minimum = 0;
    /// How often the stress is solved at most, each time without the particles that are damaged by then,
    /// until no more are (paper, section 6.1). Splines only. 1: the damage of the first solve counts, which
    /// is the default since every further wave takes as long as a first blow, and leaves the blow's energy to
    /// more damaged material, in fewer pieces: the cup of the demo breaks into 17, 9 and 5 with 1, 2 and 4
    /// waves, in 2, 3.5 and 6 s; on walls little changes.
    int damage_waves = 1;
    /// Whether blows are resampled around their contacts, as often as the stress settings say. It sharpens
    /// the stress right at the contact only, and takes longer than the rest of a blow.
    bool resample_contacts = false;
    int fragment_count =
        0;  ///< clusters that the damaged part is split into; 0: what the strain energy pays for
    double energy_into_cracks = 0.05;  ///< fraction of the strain energy that goes into crack faces, 0 to 1
    int largest_fragment_count = 36;
    double smallest_fragment_m3 = 0;  ///< smaller pieces are debris; 0: 1/200 of the first body
    Debris debris = Debris::unbreakable;
    GuideField guide;
    double crack_roughness =
        0;  ///< of crack faces, as a fraction of the particle spacing, 0 to 0.5; same on both sides
    /// Hulls and convex parts of neighbouring fragments may overlap: such pairs collide, but are not pushed
    /// apart by more than what they go deeper into each other later.
    CollisionShape collision_shape = CollisionShape::boxes;
    double rest_after_break_s = 0.01;  ///< fragments are unbreakable for so long after their birth

    Status validate() const;
};

/// How much accuracy a scene needs; the README shows what each costs.
enum class Quality {
    preview,  ///< which parts are loaded, and about how much
    game,     ///< the defaults
    film,     ///< as right as fine finite elements
};

struct Settings {
    /// The defaults with the sampling and the stress solve of a quality.
    static Settings forQuality(Quality quality);

    SamplingSettings sampling;
    StressSettings stress;
    ContactSettings contact;
    FractureSettings fracture;

    Status validate() const;
};

}  // namespace sherd
