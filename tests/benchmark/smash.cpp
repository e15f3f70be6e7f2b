// A room of crockery: 30 stoneware cups of one prepared asset stand on a floor, and a steel ball of 2 kg
// flies through them at 12 m/s. Prints what the steps took, what was solved, and what is left; and what plain
// Bullet takes to step bodies of the same shapes from the same places (`Replay`).
//
//   smash [--rate HZ] [--seconds S] [--quality NAME] [--set FIELD=VALUE]... [--paced] [--no-budget] [--steps
//   FILE] [--blows FILE]
//
// `--paced` waits after each step for the time that it simulates, as a game does. `--set` is that of the
// command line (fracture.collision_shape=hull); `--steps` writes one line a step,
// `--blows` one a blow that was solved. With
// `--set fracture.check_with_full_solve=true` it counts the breaks that the cheaper levels missed, and
// those that a full solve would not have had.

#include <sherd/enum_names.h>
#include <sherd/sherd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/replay.h"
#include "benchmark/value_or_exit.h"
#include "support/cup_room.h"
#include "support/resident_memory.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

struct Options {
    double rate_hz = 60, seconds = 2;
    std::string quality = "game", steps_file, blows_file;
    std::vector<std::string> assignments;
    bool paced = false, no_budget = false;
};

double now() {
    using namespace std::chrono;
    return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

struct Blows {
    BlowCounts by;
    long missed = 0, falsely = 0, broke = 0, held = 0, failed = 0, dropped = 0;
    std::vector<double> ms, stepping_ms;  // the latter on the thread that steps

    void add(const BlowEvent& event) {
        if (event.outcome == Outcome::dropped) {
            ++dropped;
            return;
        }
        ++by.at(event.level);
        ++(event.outcome == Outcome::broke ? broke : event.outcome == Outcome::held ? held : failed);
        missed += event.outcome == Outcome::held && event.full_solve_outcome == Outcome::broke;
        falsely += event.outcome == Outcome::broke && event.full_solve_outcome == Outcome::held;
        ms.push_back(event.ms.total());
        stepping_ms.push_back(ms.back() - event.ms_elsewhere.total());
    }
    void print(const char* what) const {
        std::printf(
            "%-14s %5lld coarse %5lld reduced %5lld full: %5ld broke %5ld held %3ld failed %3ld dropped, %ld "
            "missed, %ld falsely broken\n"
            "                 ms: median %.2f, 90 %% %.2f, longest %.1f; on the thread that steps %.2f, "
            "%.2f, %.1f\n",
            what, by.coarse, by.reduced, by.full, broke, held, failed, dropped, missed, falsely,
            quantile(ms, 0.5), quantile(ms, 0.9), quantile(ms, 1), quantile(stepping_ms, 0.5),
            quantile(stepping_ms, 0.9), quantile(stepping_ms, 1));
    }
};

template <class Times>
void printTimes(const Times& times) {
    for (const auto& field : time_fields<Times>)
        if (times.*field.value >= 0.5) std::printf("  %s %.0f", field.name, times.*field.value);
    std::puts("");
}

void printBlow(const BlowEvent& event, int step, std::ofstream& file) {
    file << step << ' ' << nameOf(event.outcome) << ' ' << nameOf(event.level) << ' ' << event.asset.mass()
         << " kg, " << event.waited_s << " s waited, " << event.fragments.size() << " fragments, ms:";
    for (const auto& field : time_fields<StageTimes>)
        if (event.ms.*field.value >= 0.5) file << ' ' << field.name << ' ' << event.ms.*field.value;
    file << '\n';
}

void run(const Options& options) {
    Settings settings = Settings::forQuality(*valueNamed<Quality>(options.quality));
    succeedOrExit(settings.set(options.assignments));
    const BreakableAsset cup =
        valueOrExit(BreakableAsset::fromObj(SHERD_ASSETS "/coffee_cup.obj", Material::ceramic(), settings));
    succeedOrExit(cup.prepare());

    CupRoom room;
    const double memory_before = residentBytes();
    {
        FractureWorld fracture(&room.world);
        succeedOrExit(CupRoom::addCups(fracture, cup));
        if (options.no_budget) succeedOrExit(fracture.setBudget(Budget::none()));
        const int steps = static_cast<int>(options.seconds * options.rate_hz + 0.5);
        Replay replay(room.world);
        std::vector<double> step_ms, own_ms;
        double wall = 0;
        Blows on_cups, on_fragments;
        double ball_after = 0, dropped = 0;
        std::vector<std::pair<int, int>> sizes;  // objects and manifolds
        std::ofstream blows(options.blows_file);
        const auto start = std::chrono::steady_clock::now();
        for (int step = 0; step < steps; ++step) {
            const double whole_before = fracture.times().whole, from = now();
            room.world.stepSimulation(btScalar(1 / options.rate_hz), 0);
            step_ms.push_back(now() - from);
            wall += step_ms.back();
            replay.note(room.world);
            if (options.paced)
                std::this_thread::sleep_until(start +
                                              std::chrono::duration<double>((step + 1) / options.rate_hz));
            own_ms.push_back(step_ms.back() - (fracture.times().whole - whole_before));
            for (const BlowEvent& event : fracture.takeEvents()) {
                (event.asset.solid() == cup.solid() ? on_cups : on_fragments).add(event);
                dropped += event.dropped_mass_kg;
                if (blows) printBlow(event, step, blows);
            }
            if (ball_after == 0 &&
                room.ball.getWorldTransform().getOrigin().x() > CupRoom::spacing_m * CupRoom::per_row)
                ball_after = room.ball.getLinearVelocity().length();
            sizes.emplace_back(room.world.getNumCollisionObjects(), room.dispatcher.getNumManifolds());
        }
        std::vector<double> masses;
        double mass = dropped;
        int asleep = 0;
        for (const btRigidBody* body : fracture.bodies()) {
            const double own = body->getInvMass() > 0 ? 1 / double(body->getInvMass()) : 0;
            mass += own;
            masses.push_back(own);
            asleep += !body->isActive();
        }
        double own = 0;
        for (const double ms : own_ms) own += ms;
        const double memory = residentBytes() - memory_before;  // with what is kept for the replay
        const std::vector<double> plain_ms = replay.play(1 / options.rate_hz);
        const double plain = std::accumulate(plain_ms.begin(), plain_ms.end(), 0.0);
        if (!options.steps_file.empty()) {
            std::ofstream file(options.steps_file);
            for (std::size_t i = 0; i < step_ms.size(); ++i)
                file << i << ' ' << step_ms[i] << ' ' << own_ms[i] << ' ' << plain_ms[i] << ' '
                     << sizes[i].first << ' ' << sizes[i].second << '\n';
        }
        const WorldTimes times = fracture.times();
        const BlowCounts counts = fracture.counts();
        std::printf(
            "%g Hz, %g s, %s: wall %.2f s, Sherd %.2f s, Bullet's own %.2f s; steps: median %.2f, "
            "longest %.1f ms (Bullet's own %.2f, %.1f)\n",
            options.rate_hz, options.seconds, options.quality.c_str(), wall / 1000, times.whole / 1000,
            own / 1000, quantile(step_ms, 0.5), quantile(step_ms, 1), quantile(own_ms, 0.5),
            quantile(own_ms, 1));
        std::printf("plain Bullet steps the same bodies in %.2f s: with Sherd it takes %.2f times as long\n",
                    plain / 1000, wall / plain);
        std::printf(
            "memory + %.0f MB; %zu bodies (%d asleep), %.4f kg of %.4f; masses %.4f %.4f %.4f g; ball "
            "%.3f m/s behind the cups\n",
            memory / 1e6, masses.size(), asleep, mass, CupRoom::count * cup.mass(),
            1e3 * quantile(masses, 0.25), 1e3 * quantile(masses, 0.5), 1e3 * quantile(masses, 0.75),
            ball_after);
        std::printf(
            "blows %lld: gate %lld, coarse %lld, reduced %lld, full %lld; foreseen %lld, in vain %lld\n",
            counts.seen, counts.gate, counts.coarse, counts.reduced, counts.full, counts.foreseen,
            counts.foreseen_in_vain);
        on_cups.print("  on cups");
        on_fragments.print("  on fragments");
        std::printf("blows, ms:");
        printTimes(times.blows);
        std::printf("on other threads, ms:");
        printTimes(times.workers);
        std::printf("steps, ms:");
        printTimes(times.steps);
    }
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    CLI::App app{"30 cups and a ball: what a room of crockery costs."};
    app.add_option("--rate", options.rate_hz, "steps a second")->check(CLI::PositiveNumber);
    app.add_option("--seconds", options.seconds, "simulated time, s")->check(CLI::PositiveNumber);
    app.add_option("--quality", options.quality)->check(CLI::IsMember({"preview", "game", "film"}));
    app.add_option("--set", options.assignments, "a setting by its path, FIELD=VALUE");
    app.add_flag("--paced", options.paced, "wait after each step for its time, as a game does for its frame");
    app.add_flag("--no-budget", options.no_budget, "decide every blow in its step");
    app.add_option("--steps", options.steps_file, "file with a line a step");
    app.add_option("--blows", options.blows_file, "file with a line a blow that was solved");
    CLI11_PARSE(app, count, arguments);
    run(options);
    return 0;
}
