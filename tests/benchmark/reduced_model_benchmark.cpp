// How far the reduced model of a prepared asset can be trusted, and what it takes: random blows on five
// bodies (1 to 4 contacts of one partner, half of them with supports), each solved by the reduced model and
// fully, at `game`. A blow is decided at three strengths, the quartiles of the largest stresses of all blows
// of a body. Usage: reduced_model_benchmark [BLOWS A BODY]
//
// Columns: decisions that agree; overlap of the damaged particles (intersection over union, median and the
// lowest tenth of those that damage anything); error of the largest stress, median and the highest tenth; ms
// a blow with its damage, median, of the reduced model and of a full solve whose factor is there; seconds to
// prepare; of the blows that hold at the three strengths, those that the gate decides by the stress alone; ms
// a blow of its quick bound and, where that did not do, of its close one, median; the least of all bounds
// over the stress of the full solve: above 1, there is no strength at which the gate is wrong.

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

/// Answers blows on one solid at one level.
class Solved {
  public:
    Solved(const BreakableSolid& solid, const Discretisation& sampling, bool reduced)
        : solid_(solid), sampling_(sampling), fracture_(solid.settings().fracture) {
        fracture_.use_reduced_model = reduced;
    }

    BlowDamage ask(const Blow& blow, double strength_pa, double& ms) const {
        Material even = solid_.material();
        even.tensile_strength_pa = strength_pa;
        even.strength_scatter = 0;
        const BodyStrength strength(even, solid_.strength().scatterLength(), {});
        StageTimes times;
        BlowDamage found = blowDamage({solid_, sampling_, fracture_, 1}, blow, strength, times);
        ms = times.solve + times.stress + times.damage;
        return found;
    }

  private:
    const BreakableSolid& solid_;
    const Discretisation& sampling_;
    FractureSettings fracture_;
};

/// The gate's bounds of one blow.
struct Gate {
    double quick_pa = std::numeric_limits<double>::infinity(), close_pa = quick_pa;
    double quick_ms = 0, close_ms = 0;

    Gate(const BreakableSolid& solid, const Blow& blow) {
        const PeakTable& table = solid.reducedStress()->peaks;
        const ContactSettings& contact = solid.settings().fracture.contact;
        Stopwatch watch;
        if (const auto bound = quickBound(solid, table, blow, contact))
            quick_pa = bound->equivalent_stress_pa;
        quick_ms = watch.milliseconds();
        watch = Stopwatch();
        const Strike strike = strikeOf(struckBody(solid, blow), blow, contact);
        if (const auto bound = closeBound(solid, table, blow, strike, contact))
            close_pa = bound->equivalent_stress_pa;
        close_ms = watch.milliseconds();
    }
    double bound() const { return std::min(quick_pa, close_pa); }
};

double largestOf(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

void compare(const std::string& name, const TriangleMesh& surface, int count) {
    const auto solid = valueOrExit(BreakableSolid::make(surface, Material::ceramic(), {}));
    const Stopwatch watch;
    if (const Status prepared = solid->prepare({}); !prepared || !solid->reducedStress()) {
        std::printf("| %s | no reduced model |\n", name.c_str());
        return;
    }
    const double prepare_s = 1e-3 * watch.milliseconds();
    if (!solid->stressSolver()) std::exit(1);
    const Discretisation& sampling = *valueOrExit(solid->discretisation());
    const Solved fast(*solid, sampling, true), full(*solid, sampling, false);
    const double strong = 1e30;
    std::vector<Blow> blows;
    std::vector<double> fast_pa, full_pa, errors, fast_ms, full_ms, full_equivalent, quick_ms, close_ms;
    std::vector<Gate> gates;
    double margin = std::numeric_limits<double>::infinity();
    fracture_tests::RandomBlows random(surface, 5);
    int reduced = 0;
    for (int i = 0; i < count; ++i) {
        blows.push_back(random.next());
        double ms = 0;
        const BlowDamage a = fast.ask(blows.back(), strong, ms);
        reduced += a.level == Level::reduced;
        fast_ms.push_back(ms);
        const BlowDamage b = full.ask(blows.back(), strong, ms);
        full_ms.push_back(ms);
        fast_pa.push_back(a.damage.largest_stress_pa);
        full_pa.push_back(b.damage.largest_stress_pa);
        errors.push_back(std::abs(fast_pa.back() / full_pa.back() - 1));
        full_equivalent.push_back(strong * largestOf(b.damage.overstress));
        gates.emplace_back(*solid, blows.back());
        quick_ms.push_back(gates.back().quick_ms);
        close_ms.push_back(gates.back().close_ms);
        if (full_equivalent.back() > 0)
            margin = std::min(margin, gates.back().bound() / full_equivalent.back());
    }
    int same = 0, decisions = 0;
    std::vector<double> overlaps, breaking_ms;
    int held = 0, by_gate = 0;
    for (const std::size_t quarters : {1, 2, 3}) {
        const double strength = betweenAtQuarter(full_pa, quarters);
        for (int i = 0; i < count; ++i) {
            const bool holds = full_equivalent[i] <= strength;
            held += holds;
            by_gate += holds && gates[i].bound() <= strength;
            ++decisions;
            same += (fast_pa[i] > strength) == (full_pa[i] > strength);
            if (!(full_pa[i] > strength)) continue;
            double ms = 0;
            const auto b = full.ask(blows[i], strength, ms).damage;
            const auto a = fast.ask(blows[i], strength, ms).damage;
            breaking_ms.push_back(ms);
            int both = 0, any = 0;
            for (std::size_t p = 0; p < a.damaged.size(); ++p) {
                both += a.damaged[p] && b.damaged[p];
                any += a.damaged[p] || b.damaged[p];
            }
            overlaps.push_back(any > 0 ? static_cast<double>(both) / any : 1);
        }
    }
    std::printf(
        "| %s | %d of %d | %.1f %% | %.2f, %.2f | %.2f %%, %.2f %% | %.1f | %.1f | %.1f | %.1f | "
        "%.0f %% | %.3f, %.3f | %.2f |\n",
        name.c_str(), reduced, count, 100.0 * same / decisions, quantile(overlaps, 0.5),
        quantile(overlaps, 0.1), 100 * quantile(errors, 0.5), 100 * quantile(errors, 0.9),
        quantile(fast_ms, 0.5), quantile(breaking_ms, 0.5), quantile(full_ms, 0.5), prepare_s,
        100.0 * by_gate / held, quantile(quick_ms, 0.5), quantile(close_ms, 0.5), margin);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::max(4, std::atoi(argv[1])) : 60;
    std::printf(
        "| body | by the reduced model | same decision | overlap | stress error | ms held | ms breaking | ms "
        "full | "
        "s to prepare | held, by the gate | ms gate | least bound |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    compare("slab", valueOrExit(readObj(SHERD_TEST_DATA "/cases/slab_centre/surface.obj")), count);
    compare("block", shapes::slab(Vec3(0.2, 0.15, 0.1), 3, 3, 3), count);
    compare("cup", valueOrExit(generators::generate("coffee_cup", 20000)), count);
    compare("dish", valueOrExit(readObj(SHERD_TEST_DATA "/cases/dish_rim/surface.obj")), count);
    compare("aeroplane", valueOrExit(generators::generate("plane", 20000)), count);
}
