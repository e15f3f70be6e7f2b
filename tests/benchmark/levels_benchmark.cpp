// Cost against accuracy of the levels that decide a blow: the gate and the reduced model of a prepared asset,
// and full solves with the qualities preview, game and film. Random blows on five bodies, as in
// reduced_model_benchmark. Truth is the full solve of film. Only prepared bodies know their vibrations: the
// gate and the reduced model are held against the full solve of their own body. Usage:
// levels_benchmark [BLOWS A BODY]
//
// A line a body and level, `body level ms error wrong decided`: ms a further blow, median; error of the
// largest principal stress in percent, median (the gate knows none: nan); decisions that are wrong at the
// quartiles of the true stresses, percent of those that the level makes; percent of the blows that hold which
// it decides.

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/loads/contact_loads.h"
#include "core/numerics/stopwatch.h"
#include "fracture/blow_bound.h"
#include "fracture/blow_damage.h"
#include "fracture/random_blows.h"
#include "generators/generators.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

/// Stress of blows on a solid, Pa, and what each took.
struct Answers {
    std::vector<double> stress_pa, ms;
};

Answers ask(const BreakableSolid& solid, const std::vector<Blow>& blows, bool reduced) {
    const Discretisation& sampling = *valueOrExit(solid.discretisation());
    FractureSettings fracture = solid.settings().fracture;
    fracture.use_reduced_model = reduced;
    Material strong = solid.material();
    strong.tensile_strength_pa = 1e30;
    const BodyStrength strength(strong, solid.strength().scatterLength(), {});
    if (!reduced && !solid.stressSolver()) std::exit(1);
    Answers answers;
    for (const Blow& blow : blows) {
        StageTimes times;
        const Stopwatch watch;
        const BlowDamage found = blowDamage({solid, sampling, fracture, 1}, blow, strength, times);
        answers.ms.push_back(watch.milliseconds());
        answers.stress_pa.push_back(found.damage.largest_stress_pa);
    }
    return answers;
}

/// The gate's bounds in the place of the stress.
Answers askGate(const BreakableSolid& solid, const std::vector<Blow>& blows) {
    const PeakTable& table = solid.reducedStress()->peaks;
    const ContactSettings& contact = solid.settings().fracture.contact;
    Answers answers;
    for (const Blow& blow : blows) {
        const Stopwatch watch;
        const auto quick = quickBound(solid, table, blow, contact);
        answers.ms.push_back(watch.milliseconds());
        const auto close =
            closeBound(solid, table, blow, strikeOf(struckBody(solid, blow), blow, contact), contact);
        double bound = std::numeric_limits<double>::infinity();
        for (const auto& one : {quick, close})
            if (one) bound = std::min(bound, one->equivalent_stress_pa);
        answers.stress_pa.push_back(bound);
    }
    return answers;
}

void print(const std::string& body, const char* level, const Answers& own, const Answers& truth,
           bool is_gate) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < own.stress_pa.size(); ++i)
        errors.push_back(100 * std::abs(own.stress_pa[i] / truth.stress_pa[i] - 1));
    int made = 0, wrong = 0, held = 0, decided = 0;
    for (const std::size_t quarters : {1, 2, 3}) {
        const double strength = betweenAtQuarter(truth.stress_pa, quarters);
        for (std::size_t i = 0; i < own.stress_pa.size(); ++i) {
            const bool holds = truth.stress_pa[i] <= strength, skips = own.stress_pa[i] <= strength;
            held += holds;
            decided += holds && (!is_gate || skips);
            made += !is_gate || skips;
            wrong += is_gate ? skips && !holds : skips != holds;
        }
    }
    std::printf("%s %s %.4f %.3f %.3f %.1f\n", body.c_str(), level, quantile(own.ms, 0.5),
                is_gate ? std::numeric_limits<double>::quiet_NaN() : quantile(errors, 0.5),
                made > 0 ? 100.0 * wrong / made : 0, 100.0 * decided / held);
    std::fflush(stdout);
}

void measure(const std::string& body, const TriangleMesh& surface, int count) {
    fracture_tests::RandomBlows random(surface, 5);
    std::vector<Blow> blows;
    for (int i = 0; i < count; ++i) blows.push_back(random.next());
    const auto solidOf = [&](Quality quality) {
        return valueOrExit(BreakableSolid::make(surface, Material::ceramic(), Settings::forQuality(quality)));
    };
    const auto prepared = solidOf(Quality::game);
    if (!prepared->prepare({}) || !prepared->reducedStress()) std::exit(1);
    const Answers with_vibrations = ask(*prepared, blows, false);
    print(body, "gate", askGate(*prepared, blows), with_vibrations, true);
    print(body, "reduced", ask(*prepared, blows, true), with_vibrations, false);
    const Answers film = ask(*solidOf(Quality::film), blows, false);
    print(body, "preview", ask(*solidOf(Quality::preview), blows, false), film, false);
    print(body, "game", ask(*solidOf(Quality::game), blows, false), film, false);
    print(body, "film", film, film, false);
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::max(4, std::atoi(argv[1])) : 40;
    measure("slab", valueOrExit(readObj(SHERD_TEST_DATA "/cases/slab_centre/surface.obj")), count);
    measure("block", shapes::slab(Vec3(0.2, 0.15, 0.1), 3, 3, 3), count);
    measure("cup", valueOrExit(generators::generate("coffee_cup", 20000)), count);
    measure("dish", valueOrExit(readObj(SHERD_TEST_DATA "/cases/dish_rim/surface.obj")), count);
    measure("aeroplane", valueOrExit(generators::generate("plane", 20000)), count);
}
