// What comes after the first break, by the rate of the steps: bodies after some seconds, the quartiles of
// their mass, how often wholes and pieces broke, and how fast the pieces are. Three scenes: cups that a ball
// flies through, a pane of glass and a wall of plaster that stand on a floor and are struck in the middle.
//
//   cascade [--scene NAME]... [--rate HZ]... [--seeds N] [--seconds S] [--quality NAME] [--cups N]
//           [--speed M_S] [--unbreakable-pieces] [--continuous M] [--budget] [--set FIELD=VALUE]...
//           [--events]
//
// Each seed is another pattern of cracks, and another place of the ball: where in a step it strikes is part
// of what is measured. Rows are means over the seeds. With `--unbreakable-pieces` what differs between
// rates is Bullet's own. With `--continuous` the bodies sweep spheres of that radius where they move by more
// than its double in a step (setCcdSweptSphereRadius), as the ball always does. `--budget` is that of a
// world's defaults; without it no blow waits. `--events` prints the blows that were solved.

#include <sherd/enum_names.h>
#include <sherd/sherd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "benchmark/floor_world.h"
#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

struct Options {
    std::vector<std::string> scenes{"cups", "pane", "wall"}, assignments;
    std::vector<double> rates_hz{60, 120, 240, 480};
    int seeds = 5, cups = 30;
    double seconds = 2, speed_m_s = 0;  // of the ball; 0: the scene's own
    double swept_radius_m = 0;
    std::string quality = "game";
    bool unbreakable_pieces = false, budget = false, events = false;
};

struct Ball {
    double mass_kg, radius_m, speed_m_s;  // along x
    Vec3 from;
};

/// What the ball flies at: one asset, at some places.
struct Scene {
    BreakableAsset asset;
    Ball ball;
    std::vector<btTransform> places;
};

BreakableAsset box(const Vec3& size, const Material& material, const Settings& settings) {
    const Vec3 half(size.x() / 2, size.y() / 2, 0);
    return valueOrExit(BreakableAsset::fromMesh(shapes::box(-half, half + Vec3(0, 0, size.z()), 1, 1, 1),
                                                material, settings));
}

Scene sceneNamed(const std::string& name, const Options& options) {
    Settings settings = Settings::forQuality(*valueNamed<Quality>(options.quality));
    if (options.unbreakable_pieces) settings.fracture.largest_generation = 1;
    succeedOrExit(settings.set(options.assignments));
    const btTransform origin(btQuaternion::getIdentity(), btVector3(0, 0, 0.001f));
    if (name == "pane")
        return {
            box(Vec3(0.02, 1, 1), Material::glass(), settings), {1, 0.05, 15, Vec3(-0.5, 0, 0.5)}, {origin}};
    if (name == "wall")
        return {
            box(Vec3(0.09, 1, 1), Material::plaster(), settings), {5, 0.1, 15, Vec3(-0.6, 0, 0.5)}, {origin}};
    Scene cups{
        valueOrExit(BreakableAsset::fromObj(SHERD_ASSETS "/coffee_cup.obj", Material::ceramic(), settings)),
        {2, 0.05, 12, Vec3(-0.3, 0.02, 0.06)},
        {}};
    constexpr int per_row = 6;
    constexpr btScalar spacing_m = 0.13f;
    const int rows = (options.cups + per_row - 1) / per_row;
    for (int i = 0; i < options.cups; ++i)
        cups.places.push_back(
            origin *
            btTransform(btQuaternion::getIdentity(),
                        spacing_m * btVector3(btScalar(i % per_row), btScalar(i / per_row - rows / 2), 0)));
    return cups;
}

/// What is left of one run; sums of several.
struct Left {
    double bodies = 0, quartiles_kg[3] = {}, wholes_broken = 0, pieces_broken = 0, solved = 0;
    double ball_m_s = 0;             ///< after a tenth of the way
    std::vector<double> energies_j;  ///< of the pieces' motion, a tenth, a quarter, a half and all of the way

    void add(const Left& other) {
        bodies += other.bodies;
        wholes_broken += other.wholes_broken;
        pieces_broken += other.pieces_broken;
        solved += other.solved;
        ball_m_s += other.ball_m_s;
        for (int q = 0; q < 3; ++q) quartiles_kg[q] += other.quartiles_kg[q];
        energies_j.resize(other.energies_j.size());
        for (std::size_t i = 0; i < energies_j.size(); ++i) energies_j[i] += other.energies_j[i];
    }
    static void printHeader() {
        std::puts(
            "    Hz  bodies    25 %    50 %    75 %, g  wholes  pieces  solved  ball, m/s  pieces' energy "
            "after "
            "1/10, 1/4, 1/2 and all, J");
    }
    void print(double rate_hz, int runs) const {
        std::printf("%6g %7.1f %7.2f %7.2f %10.2f %7.1f %7.1f %7.1f %10.2f ", rate_hz, bodies / runs,
                    1e3 * quartiles_kg[0] / runs, 1e3 * quartiles_kg[1] / runs, 1e3 * quartiles_kg[2] / runs,
                    wholes_broken / runs, pieces_broken / runs, solved / runs, ball_m_s / runs);
        for (const double energy : energies_j) std::printf(" %7.3f", energy / runs);
        std::puts("");
    }
};

double motionEnergy(const FractureWorld& fracture) {
    double sum = 0;
    for (const btRigidBody* body : fracture.bodies()) {
        if (body->getInvMass() == 0) continue;
        const btVector3 v = body->getLinearVelocity(), w = body->getAngularVelocity();
        sum +=
            0.5 * (v.length2() / body->getInvMass() + w.dot(body->getInvInertiaTensorWorld().inverse() * w));
    }
    return sum;
}

void printEvent(const BlowEvent& event, double time_s) {
    std::printf("    %.4f s: %s by %s, %.4f g at (%.3f %.3f %.3f), %.1f N in %.2g s, %.2f MPa, %zu pieces\n",
                time_s, nameOf(event.outcome), nameOf(event.level), 1e3 * event.asset.mass(),
                event.position.x(), event.position.y(), event.position.z(), event.peak_force_n,
                event.contact_time_s, event.largest_stress_pa / 1e6, event.fragments.size());
}

Left run(const Scene& scene, const Options& options, double rate_hz, unsigned seed) {
    FloorWorld room(30);
    std::mt19937_64 random(seed);
    const auto jitter = [&](double size) { return size * (double(random()) / double(random.max()) - 0.5); };
    const double back = jitter(0.2), aside = jitter(0.01), above = jitter(0.01);
    const Vec3 start = scene.ball.from + Vec3(back, aside, above);
    btSphereShape sphere{btScalar(scene.ball.radius_m)};
    const auto inertia = btScalar(0.4 * scene.ball.mass_kg * scene.ball.radius_m * scene.ball.radius_m);
    btRigidBody ball(btScalar(scene.ball.mass_kg), nullptr, &sphere, btVector3(inertia, inertia, inertia));
    ball.translate(btVector3(btScalar(start.x()), btScalar(start.y()), btScalar(start.z())));
    ball.setLinearVelocity(btVector3(btScalar(scene.ball.speed_m_s), 0, 0));
    ball.setCcdMotionThreshold(btScalar(scene.ball.radius_m / 2));
    ball.setCcdSweptSphereRadius(btScalar(scene.ball.radius_m / 2));
    room.world.addRigidBody(&ball);
    Left left;
    {
        FractureWorld fracture(&room.world);
        if (!options.budget) succeedOrExit(fracture.setBudget(Budget::none()));
        for (std::size_t i = 0; i < scene.places.size(); ++i) {
            BodyOptions body(scene.places[i]);
            body.seed = 1000 * seed + i;
            btRigidBody& added = *valueOrExit(fracture.add(scene.asset, body));
            added.setCcdMotionThreshold(btScalar(2 * options.swept_radius_m));
            added.setCcdSweptSphereRadius(btScalar(options.swept_radius_m));
        }
        const int steps = static_cast<int>(options.seconds * rate_hz + 0.5);
        for (int step = 1; step <= steps; ++step) {
            room.world.stepSimulation(btScalar(1 / rate_hz), 0);
            for (const BlowEvent& event : fracture.takeEvents()) {
                if (event.outcome == Outcome::broke)
                    ++(event.generation == 0 ? left.wholes_broken : left.pieces_broken);
                if (options.events) printEvent(event, step / rate_hz);
            }
            if (step == steps / 10) left.ball_m_s = ball.getLinearVelocity().length();
            if (step == steps / 10 || step == steps / 4 || step == steps / 2 || step == steps)
                left.energies_j.push_back(motionEnergy(fracture));
        }
        std::vector<double> masses;
        for (const btRigidBody* body : fracture.bodies())
            masses.push_back(body->getInvMass() > 0 ? 1 / double(body->getInvMass()) : 0);
        left.bodies = static_cast<double>(masses.size());
        for (int q = 0; q < 3; ++q) left.quartiles_kg[q] = quantile(masses, (q + 1) / 4.0);
        const BlowCounts counts = fracture.counts();
        left.solved = static_cast<double>(counts.coarse + counts.solved());
    }
    room.world.removeRigidBody(&ball);
    return left;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    CLI::App app{"What comes after the first break, by the rate of the steps."};
    app.add_option("--scene", options.scenes)->check(CLI::IsMember({"cups", "pane", "wall"}));
    app.add_option("--rate", options.rates_hz, "steps a second")->check(CLI::PositiveNumber);
    app.add_option("--seeds", options.seeds, "runs a rate")->check(CLI::PositiveNumber);
    app.add_option("--seconds", options.seconds, "simulated time, s")->check(CLI::PositiveNumber);
    app.add_option("--quality", options.quality)->check(CLI::IsMember({"preview", "game", "film"}));
    app.add_option("--cups", options.cups, "how many cups there are")->check(CLI::PositiveNumber);
    app.add_option("--set", options.assignments, "a setting by its path, FIELD=VALUE");
    app.add_flag("--unbreakable-pieces", options.unbreakable_pieces, "pieces never break");
    app.add_option("--continuous", options.swept_radius_m,
                   "of the spheres that the bodies sweep, m; 0: none");
    app.add_flag("--budget", options.budget, "that of a world's defaults; else no blow waits");
    app.add_flag("--events", options.events, "print the blows that were solved");
    app.add_option("--speed", options.speed_m_s, "of the ball, m/s; 0: the scene's own");
    CLI11_PARSE(app, count, arguments);
    for (const std::string& name : options.scenes) {
        Scene scene = sceneNamed(name, options);
        if (options.speed_m_s > 0) scene.ball.speed_m_s = options.speed_m_s;
        succeedOrExit(scene.asset.prepare());
        std::printf("%s, %s, %g s, mean of %d seeds\n", name.c_str(), options.quality.c_str(),
                    options.seconds, options.seeds);
        Left::printHeader();
        for (const double rate_hz : options.rates_hz) {
            Left all;
            for (int seed = 1; seed <= options.seeds; ++seed)
                all.add(run(scene, options, rate_hz, static_cast<unsigned>(seed)));
            all.print(rate_hz, options.seeds);
            std::fflush(stdout);
        }
    }
    return 0;
}
