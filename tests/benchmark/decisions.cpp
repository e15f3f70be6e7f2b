// Whether blows break a body or not, as a world decides it, against much finer solves: random blows on five
// bodies (1 to 4 contacts of one partner, half of them with supports). Truth is a full solve with cubic
// splines, as fine as `film`: on one flat face with the near field of the contacts (finite elements differ by
// 1 to 3 %), else with finer and finer grids around them until nine cells lie across each, read at its rim
// and opposite it as well, and extrapolated from the two finest. Of eight contacts on a mug, finite elements
// differ from that by 1 to 6 % at walls and fillets, and have 1 % less, 13 and 28 % more over the lip, where
// the near field of `game` has 0, 1 and 17 % less than they. Vibrations are left out: the finer grids do not
// know them.
// Usage: decisions [BLOWS A BODY [BODY]]
//
// A blow is decided by its largest stress per newton at three strengths, the quartiles of the true ones: how
// hard it strikes makes no blow easy to decide. Columns, for `game` and `preview`, by the reduced model and
// in full, without the near field of contacts and with it: decisions that agree; error of the largest stress,
// median and the highest tenth; ms a blow with its damage, median. `known`: contacts with a near field.

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/loads/contact_field.h"
#include "core/mlpg/splines/contact_remainder.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/pi.h"
#include "core/stress/elasticity.h"
#include "core/stress/loaded_places.h"
#include "core/stress/principal_stresses.h"
#include "core/stress/surface_traction.h"
#include "fracture/blow_damage.h"
#include "fracture/random_blows.h"
#include "generators/generators.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

constexpr double nothing_breaks = 1e30;  // Pa

/// Time of the processor that this thread took: the same beside other programs.
double processorMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Answers blows on one solid at one level: the largest stress, Pa/N.
class Answering {
  public:
    Answering(const BreakableSolid& solid, bool reduced)
        : solid_(solid),
          sampling_(*valueOrExit(solid.discretisation())),
          fracture_(solid.settings().fracture),
          strength_(unbreakable(solid.material()), solid.strength().scatterLength(), {}) {
        fracture_.use_reduced_model = reduced;
    }

    /// As a world asks, without vibrations.
    double ask(const Blow& blow, double& ms) const {
        const OnThisThreadAlone all_of_it;
        const double start = processorMilliseconds();
        ReducedModel::LocalSystem kept;
        const BlowForces forces = forcesOf(blow, kept);
        const double largest = largestStress(forces.loads, forces.contact, kept);
        ms = processorMilliseconds() - start;
        return largest;
    }

    /// The same with all that strikes as loads on the grid.
    double askWithoutNearField(const Blow& blow, double& ms) const {
        const OnThisThreadAlone all_of_it;
        const double start = processorMilliseconds();
        ReducedModel::LocalSystem kept;
        const BlowForces forces = forcesOf(blow, kept);
        ContactField contact;
        contact.others = forces.loads;
        const double largest = largestStress(forces.loads, contact, kept);
        ms = processorMilliseconds() - start;
        return largest;
    }

    /// Under 1 N of a blow.
    BlowForces forcesOf(const Blow& blow) const {
        ReducedModel::LocalSystem kept;
        return forcesOf(blow, kept);
    }
    /// Under what the supports answer to it, on the grid as it is; also at `places`.
    StressField stressOfAnswer(const BlowForces& forces, const std::vector<Vec3>& places) const {
        const std::vector<PointForce> answer(forces.loads.begin() + static_cast<long>(forces.strike.size()),
                                             forces.loads.end());
        return valueOrExit(valueOrExit(solid_.stressSolver())->solve(answer, places));
    }

    const Discretisation& sampling() const { return sampling_; }

  private:
    const ReducedStress* reduced() const {
        return fracture_.use_reduced_model ? solid_.reducedStress() : nullptr;
    }

    BlowForces forcesOf(const Blow& blow, ReducedModel::LocalSystem& kept) const {
        StageTimes times;
        const StressOfLoads energy = [&](const std::vector<PointForce>& loads, const ContactField&,
                                         double) -> Result<UnitResponse> {
            if (reduced())
                return UnitResponse{valueOrExit(reduced()->model.respond(loads, kept)).strain_energy_j};
            return UnitResponse{valueOrExit(valueOrExit(solid_.stressSolver())->strainEnergy(loads))};
        };
        return valueOrExit(blowForces(solid_, fracture_.contact, blow, energy, {solid_.spacing()}, times));
    }

    double largestStress(const std::vector<PointForce>& loads, const ContactField& contact,
                         ReducedModel::LocalSystem& kept) const {
        if (reduced()) {
            const Strength strength{solid_.failureCriterion(), solid_.material(),
                                    strength_.atPoints(reduced()->reading)};
            const auto response =
                contact.near.empty() ? valueOrExit(reduced()->model.respond(loads, kept))
                                     : valueOrExit(reduced()->model.respond(
                                           valueOrExit(contactRemainder(reduced()->model.problem(),
                                                                        reduced()->reading.points(),
                                                                        reduced()->reading.faces(), contact)),
                                           kept));
            return reduced()->reading.damage(response.unknowns, contact, 1, strength).largest_stress_pa;
        }
        StageTimes times;
        const StressSolver& solver = *valueOrExit(solid_.stressSolver());
        const StressField stress =
            contact.near.empty()
                ? valueOrExit(unitStress({solid_, sampling_, fracture_, 1}, solver, loads, times))
                : valueOrExit(solver.solveContact(contact));
        std::vector<Vec3> places;
        for (const SurfacePlace& place : contact.places) places.push_back(place.position);
        return damagedParticles(stress, 1, sampling_, strengthAtSamples(solid_, strength_), {}, places)
            .largest_stress_pa;
    }

    static Material unbreakable(Material material) {
        material.tensile_strength_pa = nothing_breaks;
        material.strength_scatter = 0;
        return material;
    }

    const BreakableSolid& solid_;
    const Discretisation& sampling_;
    FractureSettings fracture_;
    BodyStrength strength_;
};

double weightOf(const ContactPatch& patch) {
    double weight_m2 = 0;
    for (const PatchPart& part : patch.parts) weight_m2 += part.weight_m2;
    return weight_m2;
}

/// How much of a patch's traction presses on a face of it; 0 on what is none.
double pressedAt(const SurfacePlace& place, const ContactPatch& patch) {
    constexpr double same = 0.99;
    double pressed = 0;
    for (const PatchPart& part : patch.parts)
        if (part.normal.dot(place.normal) > same) pressed = std::max(pressed, part.pressed);
    return pressed;
}

/// What presses on a place of the surface, Pa.
Vec3 tractionAt(const SurfacePlace& place, const std::vector<ContactPatch>& patches) {
    Vec3 sum = Vec3::Zero();
    for (const ContactPatch& patch : patches) {
        const double weight_m2 = weightOf(patch);
        if (!(weight_m2 > 0)) continue;
        const double squared = (place.position - patch.spot.point).squaredNorm();
        sum += pressedAt(place, patch) * contactProfile(squared / (patch.radius_m * patch.radius_m)) /
               weight_m2 * patch.force;
    }
    return sum;
}

/// Whether the places about a contact tell more than a sample there.
bool isOnContact(const Vec3& x, const std::vector<ContactPatch>& patches) {
    return std::any_of(patches.begin(), patches.end(), [&](const ContactPatch& patch) {
        return (x - patch.spot.point).norm() < 1.3 * patch.radius_m;
    });
}

/// Whether all parts of a patch lie on the planes of its discs.
bool areFlat(const ContactPatch& patch, const std::vector<ContactDisc>& discs) {
    constexpr double same = 0.9999;
    return std::all_of(patch.parts.begin(), patch.parts.end(), [&](const PatchPart& part) {
        return std::any_of(discs.begin(), discs.end(),
                           [&](const ContactDisc& disc) { return part.normal.dot(disc.inward) < -same; });
    });
}

/// About the rims of contacts, and opposite them.
std::vector<SurfacePlace> placesAbout(const SurfaceTree& tree, const std::vector<ContactPatch>& patches) {
    std::vector<SurfacePlace> places;
    const auto add = [&](const SurfaceSpot& spot) {
        if (spot.triangle < 0) return;
        places.push_back({spot.point, areaVector(cornersOf(tree.surface(), spot.triangle)).normalized()});
    };
    for (const ContactPatch& patch : patches) {
        Vec3 outward = Vec3::Zero();
        for (const PatchPart& part : patch.parts) outward += part.weight_m2 * part.normal;
        if (!(outward.norm() > 0)) continue;
        outward.normalize();
        const Vec3 a = outward.unitOrthogonal(), b = outward.cross(a);
        constexpr int angles = 36;
        for (int ring = 10; ring <= 24; ++ring)  // twentieths of the radius
            for (int i = 0; i < angles; ++i) {
                const double angle = 2 * pi * i / angles, r = 0.05 * ring * patch.radius_m;
                const Vec3 x = patch.spot.point + r * (std::cos(angle) * a + std::sin(angle) * b);
                const SurfaceSpot spot = nearestSurfacePoint(tree, x, patch.push);
                if ((spot.point - x).norm() < 0.5 * patch.radius_m) add(spot);
            }
        add(wayOut(tree, patch.spot.point - 0.1 * patch.radius_m * outward, -outward));
    }
    return places;
}

SymmetricTensor sumOf(SymmetricTensor a, const SymmetricTensor& b) {
    a += b;
    return a;
}

/// A value from two grids, of which the cells of one are half as long: extrapolated, as the error goes with
/// the square of the length. None where the two are further from each other than `far`: there a cut leaves
/// slivers of cells, whose stress means nothing, or the surface has a sharp re-entrant edge, where it grows
/// from grid to grid without end.
std::optional<double> extrapolated(double finer, double coarser, double far) {
    if (!(std::abs(finer - coarser) < far * finer)) return {};
    return finer + (finer - coarser) / 3;
}

/// The largest stress of a blow, Pa/N, with finer grids around what strikes, not around the points that stand
/// for its supports; `known`, `contacts`: how many have a near field, and
/// how many there are.
double trueStress(const std::vector<std::shared_ptr<const BreakableSolid>>& zoomed, const Answering& unzoomed,
                  const Blow& blow, int& known, int& contacts) {
    const BlowForces forces = unzoomed.forcesOf(blow);
    const ContactBody body = struckBody(*zoomed[0], blow);
    const ContactSettings& settings = zoomed[0]->settings().fracture.contact;
    const auto patches = contactPatches(body, strikeOf(body, blow, settings), settings);
    bool flat = true;
    for (const ContactPatch& patch : patches) {
        const std::vector<ContactDisc> discs = contactDiscs(body.surface, patch);
        known += !discs.empty();
        flat = flat && discs.size() == 1 && areFlat(patch, discs);
        ++contacts;
    }
    if (flat) {
        double ms = 0;
        return unzoomed.ask(blow, ms);
    }
    const Elasticity elasticity(zoomed[0]->material());
    std::vector<SurfacePlace> places = placesAbout(body.surface, patches);
    const std::size_t about = places.size();
    // Elsewhere the surface is read where film reads it. The finer grids' own points lie closer together also
    // far from contacts, some in slivers of cells, whose stress means nothing.
    for (const SurfacePoint& point : unzoomed.sampling().surface_points)
        if (!isOnContact(point.position, patches)) places.push_back({point.position, point.normal});
    std::vector<Vec3> positions;
    for (const SurfacePlace& place : places) positions.push_back(place.position);
    const StressField answer = unzoomed.stressOfAnswer(forces, positions);
    const Discretisation& sampling = unzoomed.sampling();
    const LoadedPlaces held(
        {forces.loads.begin() + static_cast<long>(forces.strike.size()), forces.loads.end()},
        sampling.spacing);
    const auto tensionAt = [&](const SurfacePlace& place, const SymmetricTensor& raw) {
        if (place.normal.isZero() || held.isNear(place.position)) return largestPrincipal(raw);
        return largestPrincipal(withTraction(raw, place.normal, tractionAt(place, patches), elasticity));
    };
    const auto tensionsOn = [&](const StressField& stress) {
        std::vector<double> tensions;
        for (std::size_t i = 0; i < stress.particles.size(); ++i)
            tensions.push_back(largestPrincipal(sumOf(stress.particles[i], answer.particles[i])));
        for (std::size_t i = 0; i < places.size(); ++i)
            tensions.push_back(tensionAt(places[i], sumOf(stress.points[i], answer.points[i])));
        return tensions;
    };
    // The finest grids may be too finely cut by the surface to be solved on.
    std::vector<std::vector<double>> on_grids;
    for (const auto& solid : zoomed)
        if (const auto stress = valueOrExit(solid->stressSolver())->solve(forces.strike, positions);
            stress && on_grids.size() < 2)
            on_grids.push_back(tensionsOn(stress.value()));
    if (on_grids.empty()) std::exit(1);
    const std::size_t first = answer.particles.size();
    double largest = 0;
    for (std::size_t i = 0; i < on_grids.front().size(); ++i) {
        const double finer = on_grids.front()[i], coarser = on_grids.back()[i];
        // Contacts are steep; elsewhere a grid as fine as film's is nearly there, but on an edge.
        const bool is_about_contact = i >= first && i < first + about;
        const auto value = extrapolated(finer, coarser, is_about_contact ? 0.2 : 0.1);
        largest = std::max(largest, value.value_or(is_about_contact ? std::min(finer, coarser) : 0));
    }
    return largest;
}

struct Answers {
    std::vector<double> pa_n, ms;
};

void print(const std::string& name, const std::string& level, const Answers& own,
           const std::vector<double>& truth) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < truth.size(); ++i)
        errors.push_back(100 * std::abs(own.pa_n[i] / truth[i] - 1));
    int same = 0;
    for (const std::size_t quarters : {1, 2, 3}) {
        const double strength = betweenAtQuarter(truth, quarters);
        for (std::size_t i = 0; i < truth.size(); ++i)
            same += (own.pa_n[i] > strength) == (truth[i] > strength);
    }
    std::printf("| %s | %s | %.1f %% | %.1f %%, %.1f %% | %.2f |\n", name.c_str(), level.c_str(),
                100.0 * same / (3.0 * static_cast<double>(truth.size())), quantile(errors, 0.5),
                quantile(errors, 0.9), quantile(own.ms, 0.5));
    std::fflush(stdout);
}

/// As fine as film, with functions that no preset has: none is judged by its own.
Settings cubic() {
    Settings settings = Settings::forQuality(Quality::film);
    settings.stress.basis = Basis::cubic;
    settings.sampling.layers_across_wall = 6;
    settings.sampling.smallest_count = 2000;
    settings.stress.resampling_error = 0.1;
    return settings;
}

void compare(const std::string& name, const TriangleMesh& surface, int count) {
    fracture_tests::RandomBlows random(surface, 5);
    std::vector<Blow> blows;
    for (int i = 0; i < count; ++i) blows.push_back(random.next());
    Settings finer = cubic();
    const auto fine = valueOrExit(BreakableSolid::make(surface, Material::ceramic(), finer));
    finer.stress.resample_contacts = true;
    finer.stress.resampling_cells = 9;
    std::vector<std::shared_ptr<const BreakableSolid>> zoomed;
    for (const int rounds : {4, 3, 2}) {
        finer.stress.resampling_rounds = rounds;
        zoomed.push_back(valueOrExit(BreakableSolid::make(surface, Material::ceramic(), finer)));
    }
    const Answering answering(*fine, false);
    std::vector<double> true_pa_n;
    int known = 0, contacts = 0;
    for (const Blow& blow : blows) true_pa_n.push_back(trueStress(zoomed, answering, blow, known, contacts));
    std::printf("| %s | known: %d of %d | | | |\n", name.c_str(), known, contacts);
    Answers cubic_answers;
    for (const Blow& blow : blows) {
        double ms = 0;
        cubic_answers.pa_n.push_back(answering.ask(blow, ms));
        cubic_answers.ms.push_back(ms);
    }
    print(name, "cubic, with", cubic_answers, true_pa_n);
    for (const Quality quality : {Quality::game, Quality::preview}) {
        const auto solid =
            valueOrExit(BreakableSolid::make(surface, Material::ceramic(), Settings::forQuality(quality)));
        if (!solid->prepare({}) || !solid->stressSolver()) std::exit(1);
        for (const bool reduced : {true, false}) {
            const Answering level(*solid, reduced);
            Answers without, with;
            for (const Blow& blow : blows) {
                double ms = 0;
                without.pa_n.push_back(level.askWithoutNearField(blow, ms));
                without.ms.push_back(ms);
                with.pa_n.push_back(level.ask(blow, ms));
                with.ms.push_back(ms);
            }
            const std::string title = std::string(quality == Quality::game ? "game" : "preview") +
                                      (reduced ? ", reduced" : ", full");
            print(name, title + ", without", without, true_pa_n);
            print(name, title + ", with", with, true_pa_n);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::max(4, std::atoi(argv[1])) : 60;
    const std::string only = argc > 2 ? argv[2] : "";
    std::printf("| body | level | same decision | stress error | ms |\n|---|---|---|---|---|\n");
    const auto body = [&](const char* name, const TriangleMesh& surface) {
        if (only.empty() || only == name) compare(name, surface, count);
    };
    body("slab", valueOrExit(readObj(SHERD_TEST_DATA "/cases/slab_centre/surface.obj")));
    body("block", shapes::slab(Vec3(0.2, 0.15, 0.1), 3, 3, 3));
    body("cup", valueOrExit(generators::generate("coffee_cup", 20000)));
    body("dish", valueOrExit(readObj(SHERD_TEST_DATA "/cases/dish_rim/surface.obj")));
    body("aeroplane", valueOrExit(generators::generate("plane", 20000)));
}
