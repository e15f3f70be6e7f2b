// Where the first blow goes on a body that was not prepared: wall thickness, choice of the spacing, sampling,
// spline space and ties, assembly, factor, solve with recovery, as a world solves it (`game`, no resampling).
// Usage: first_blow_benchmark [REPEATS] [OBJ ...]; without files: the slab of tests/data/cases, the cup, the
// plate and the aeroplane of the demos.
//
// Medians of the repeats, by the clock and on all processors together. Peak and energy of a push onto the end
// of the body are there to see that a change of the code left them alone.

#include <sherd/settings.h>
#include <sherd/stress_field.h>
#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/mlpg/pinned_system.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/mlpg/stress_solver.h"
#include "core/numerics/stopwatch.h"
#include "core/sampling/sample_solid.h"
#include "fracture/spacing.h"
#include "generators/generators.h"
#include "geometry/mass_properties.h"
#include "geometry/surface_checks.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

struct Body {
    std::string name;
    TriangleMesh surface;
};

/// A push onto the end of the body along its longest side.
std::vector<PointForce> pushOnTheEnd(const Discretisation& solid) {
    Eigen::AlignedBox3d box;
    for (const SurfacePoint& point : solid.surface_points) box.extend(point.position);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const double reach = box.max()[axis] - 0.05 * box.sizes()[axis];
    std::vector<PointForce> loads;
    for (const SurfacePoint& point : solid.surface_points)
        if (point.position[axis] > reach) loads.push_back({point.position, -1e6 * point.area});
    return loads;
}

/// Of one stage or of all, ms: by the clock, and on all processors together.
struct Spent {
    double wall_ms = 0, processor_ms = 0;
};

class SpentWatch {
  public:
    Spent spent() const {
        return {watch_.milliseconds(), 1e3 * static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC};
    }

  private:
    Stopwatch watch_;
    std::clock_t start_ = std::clock();
};

constexpr std::array stages = {"wall", "choice", "sampling", "splines", "assembly", "factor", "solve"};

struct FirstBlow {
    std::array<Spent, stages.size()> spent;
    double spacing_m = 0, peak_pa = 0, energy_j = 0;
    int unknowns = 0;
    long long factor_entries = 0;
};

FirstBlow firstBlow(const TriangleMesh& surface) {
    FirstBlow blow;
    auto timed = [&, stage = std::size_t{0}](const auto& work) mutable {
        const SpentWatch watch;
        auto result = work();
        blow.spent[stage++] = watch.spent();
        return result;
    };
    const Material material = Material::ceramic();
    const Settings settings = Settings::forQuality(Quality::game);
    const double wall = timed([&] { return wallThickness(surface); });
    const double volume = solidMoments(surface).volume;
    blow.spacing_m = timed([&] { return valueOrExit(spacingOfSolid(surface, settings, volume, wall)); });
    const auto solid = timed([&] {
        return std::make_shared<const Discretisation>(
            valueOrExit(sampleSolid(surface, blow.spacing_m, settings.sampling)));
    });
    const SplineProblem problem =
        timed([&] { return valueOrExit(makeSplineProblem(solid, material, settings.stress.basis, {}, {})); });
    BlockMatrix stiffness = timed([&] { return stiffnessOf(problem); });
    const PinnedSystem system = timed([&] {
        return valueOrExit(PinnedSystem::factor(stiffness, pinnedUnknowns(problem, stiffness),
                                                problem.space->highest_cells, Precision::refined));
    });
    blow.unknowns = stiffness.size();
    blow.factor_entries = system.solver().factorEntries();

    StressSettings plain = settings.stress;
    plain.resampling_rounds = 0;
    const StressSolver solver = valueOrExit(StressSolver::build(solid, material, plain));
    const std::vector<PointForce> push = pushOnTheEnd(*solid);
    const StressField field = timed([&] { return valueOrExit(solver.solve(push)); });
    blow.energy_j = field.strain_energy_j;
    for (const SymmetricTensor& stress : field.surface)
        blow.peak_pa = std::max(blow.peak_pa, largestPrincipal(stress));
    return blow;
}

std::vector<Body> publicBodies() {
    return {{"slab", valueOrExit(readObj(SHERD_TEST_DATA "/cases/slab_centre/surface.obj"))},
            {"cup", valueOrExit(generators::generate("coffee_cup", 20000))},
            {"plate", valueOrExit(generators::generate("coffee_plate", 30000))},
            {"plane", valueOrExit(generators::generate("plane", 20000))}};
}

void printStage(const char* name, const std::vector<FirstBlow>& blows, std::size_t first, std::size_t last) {
    std::vector<double> wall, processor;
    for (const FirstBlow& blow : blows) {
        wall.push_back(0);
        processor.push_back(0);
        for (std::size_t stage = first; stage < last; ++stage) {
            wall.back() += blow.spent[stage].wall_ms;
            processor.back() += blow.spent[stage].processor_ms;
        }
    }
    std::printf("| %-8s | %8.1f | %8.1f |\n", name, median(wall), median(processor));
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 5;
    std::vector<Body> bodies;
    for (int i = 2; i < argc; ++i) bodies.push_back({argv[i], valueOrExit(readObj(argv[i]))});
    if (bodies.empty()) bodies = publicBodies();
    for (const Body& body : bodies) {
        std::vector<FirstBlow> blows;
        for (int i = 0; i < repeats; ++i) blows.push_back(firstBlow(body.surface));
        const FirstBlow& blow = blows.front();
        std::printf("%s: spacing %.6g m, %d unknowns, %.2f M entries, peak %.10g Pa, energy %.10g J\n",
                    body.name.c_str(), blow.spacing_m, blow.unknowns,
                    1e-6 * static_cast<double>(blow.factor_entries), blow.peak_pa, blow.energy_j);
        std::printf("| stage | wall ms | processor ms |\n|---|---|---|\n");
        for (std::size_t stage = 0; stage < stages.size(); ++stage)
            printStage(stages[stage], blows, stage, stage + 1);
        printStage("all", blows, 0, stages.size());
    }
}
