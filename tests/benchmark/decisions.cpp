// Whether blows break a body or not, as a world decides it, against much finer solves: random blows on five
// bodies (1 to 4 contacts of one partner, half of them with supports). Truth is the full solve of `film`,
// with finer grids around those contacts whose near field is not known in closed form (it is on flat faces of
// bodies that lie behind them). Usage: decisions [BLOWS A BODY]
//
// A blow is decided by its largest stress per newton at three strengths, the quartiles of the true ones: how
// hard it strikes makes no blow easy to decide. Columns, for `game` and `preview`, by the reduced model and
// in full, without the near field of contacts and with it: decisions that agree; error of the largest stress,
// median and the highest tenth; ms a blow with its damage, median. `known`: blows with a near field.

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/mlpg/splines/contact_remainder.h"
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

    /// As a world asks. `known`: whether some near field was.
    double ask(const Blow& blow, double& ms, bool& known) const {
        StageTimes times;
        const double start = processorMilliseconds();
        const BlowDamage found = blowDamage({solid_, sampling_, fracture_, 1}, blow, strength_, times);
        ms = processorMilliseconds() - start;
        known = !found.forces.contact.near.empty();
        return found.damage.largest_stress_pa / found.forces.pulse.peak_force_n;
    }

    /// The same with all that strikes as loads on the grid.
    double askWithoutNearField(const Blow& blow, double& ms) const {
        const auto forces = ask(blow);
        const double start = processorMilliseconds();
        double largest = 0;
        if (fracture_.use_reduced_model && solid_.reducedStress()) {
            const ReducedStress& reduced = *solid_.reducedStress();
            const auto response = valueOrExit(reduced.model.respond(forces));
            const Strength strength{solid_.failureCriterion(), solid_.material(),
                                    strength_.atPoints(reduced.reading)};
            largest =
                reduced.reading.damage(response.unknowns, {{}, {}, forces}, 1, strength).largest_stress_pa;
        } else {
            StageTimes times;
            const StressField stress = valueOrExit(unitStress(
                {solid_, sampling_, fracture_, 1}, *valueOrExit(solid_.stressSolver()), forces, times));
            largest = damagedParticles(stress, 1, sampling_, strengthAtSamples(solid_, strength_))
                          .largest_stress_pa;
        }
        ms = processorMilliseconds() - start;
        return largest;
    }

  private:
    static Material unbreakable(Material material) {
        material.tensile_strength_pa = nothing_breaks;
        material.strength_scatter = 0;
        return material;
    }

    std::vector<PointForce> ask(const Blow& blow) const {
        StageTimes times;
        return blowDamage({solid_, sampling_, fracture_, 1}, blow, strength_, times).forces.loads;
    }

    const BreakableSolid& solid_;
    const Discretisation& sampling_;
    FractureSettings fracture_;
    BodyStrength strength_;
};

struct Answers {
    std::vector<double> pa_n, ms;
};

void print(const std::string& name, const std::string& level, const Answers& own,
           const std::vector<double>& truth) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < truth.size(); ++i)
        errors.push_back(100 * std::abs(own.pa_n[i] / truth[i] - 1));
    int same = 0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const double strength = quantile(truth, share) * (1 + 1e-9);
        for (std::size_t i = 0; i < truth.size(); ++i)
            same += (own.pa_n[i] > strength) == (truth[i] > strength);
    }
    std::printf("| %s | %s | %.1f %% | %.1f %%, %.1f %% | %.2f |\n", name.c_str(), level.c_str(),
                100.0 * same / (3.0 * static_cast<double>(truth.size())), quantile(errors, 0.5),
                quantile(errors, 0.9), quantile(own.ms, 0.5));
    std::fflush(stdout);
}

void compare(const std::string& name, const TriangleMesh& surface, int count) {
    fracture_tests::RandomBlows random(surface, 5);
    std::vector<Blow> blows;
    for (int i = 0; i < count; ++i) blows.push_back(random.next());
    Settings film = Settings::forQuality(Quality::film);
    const auto fine = valueOrExit(BreakableSolid::make(surface, Material::ceramic(), film));
    film.stress.resample_contacts = true;
    const auto zoomed = valueOrExit(BreakableSolid::make(surface, Material::ceramic(), film));
    const Answering truth(*fine, false), zoom(*zoomed, false);
    std::vector<double> true_pa_n;
    int known_count = 0;
    for (const Blow& blow : blows) {
        double ms = 0;
        bool known = false;
        double largest = truth.ask(blow, ms, known);
        known_count += known;
        if (!known) largest = zoom.ask(blow, ms, known);
        true_pa_n.push_back(largest);
    }
    std::printf("| %s | known: %d of %d | | | |\n", name.c_str(), known_count, count);
    for (const Quality quality : {Quality::game, Quality::preview}) {
        const auto solid =
            valueOrExit(BreakableSolid::make(surface, Material::ceramic(), Settings::forQuality(quality)));
        if (!solid->prepare({}) || !solid->stressSolver()) std::exit(1);
        for (const bool reduced : {true, false}) {
            const Answering level(*solid, reduced);
            Answers without, with;
            for (const Blow& blow : blows) {
                bool known = false;
                double ms = 0;
                without.pa_n.push_back(level.askWithoutNearField(blow, ms));
                without.ms.push_back(ms);
                with.pa_n.push_back(level.ask(blow, ms, known));
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
    const int count = argc > 1 ? std::atoi(argv[1]) : 60;
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
