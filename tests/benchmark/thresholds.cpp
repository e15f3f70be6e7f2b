// The speed from which a strike breaks a body, at several rates of steps and from several places in the step:
// the lowest and the highest, and in how many cases a faster strike breaks nothing. Speeds are 1.19 apart.
// All of it is at `preview`, on prepared bodies and without a budget.
//
//   thresholds [NAME]
//
// With a part of a name, strikes of that name only. Speeds at which the striker may go through the body
// within a step, without a trace, are left out.

#include <sherd/sherd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/floor_world.h"
#include "benchmark/value_or_exit.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

BreakableAsset prepared(BreakableAsset asset) {
    succeedOrExit(asset.prepare());
    return asset;
}

BreakableAsset boxOf(const Material& material, const Vec3& lower, const Vec3& upper) {
    return prepared(valueOrExit(BreakableAsset::fromMesh(shapes::box(lower, upper), material,
                                                         Settings::forQuality(Quality::preview))));
}

/// A body, and what flies at it along a line through a target on it.
struct StrikeCase {
    std::string name;
    BreakableAsset asset;
    bool on_floor;  ///< else in the air, without gravity
    std::function<std::unique_ptr<btCollisionShape>()> striker;
    double mass_kg;
    btVector3 target, from;  ///< m, the striker's centre before it flies, from the target
    btQuaternion turn = btQuaternion::getIdentity();
    double way_m;  ///< in a step, up to which it does not go through
};

auto ballOf(double radius_m) {
    return [radius_m]() -> std::unique_ptr<btCollisionShape> {
        return std::make_unique<btSphereShape>(btScalar(radius_m));
    };
}

std::unique_ptr<btCollisionShape> cube() {
    return std::make_unique<btBoxShape>(btVector3(0.04f, 0.04f, 0.04f));
}

bool breaks(const StrikeCase& strike, double speed_m_s, double rate_hz, double place_in_step) {
    FloorWorld scene;
    if (!strike.on_floor) {
        scene.world.removeRigidBody(&scene.floor);
        scene.world.setGravity(btVector3(0, 0, 0));
    }
    const auto shape = strike.striker();
    btVector3 inertia;
    shape->calculateLocalInertia(btScalar(strike.mass_kg), inertia);
    btRigidBody striker(btScalar(strike.mass_kg), nullptr, shape.get(), inertia);
    const btVector3 back = strike.from.normalized();
    const double way_m = strike.from.length() + speed_m_s / rate_hz * place_in_step;
    striker.setWorldTransform(btTransform(strike.turn, strike.target + back * btScalar(way_m)));
    bool broke = false;
    {
        FractureWorld fracture(&scene.world);
        succeedOrExit(fracture.setBudget(Budget::none()));
        double lowest = std::numeric_limits<double>::infinity();
        for (const Vec3& vertex : strike.asset.surface().vertices) lowest = std::min(lowest, vertex.z());
        const btVector3 up(0, 0, strike.on_floor ? btScalar(-lowest) : btScalar(0));
        valueOrExit(fracture.add(strike.asset, btTransform(btQuaternion::getIdentity(), up)));
        striker.translate(up);
        scene.world.addRigidBody(&striker);
        striker.setGravity(btVector3(0, 0, 0));
        striker.setLinearVelocity(-back * btScalar(speed_m_s));
        const int steps = static_cast<int>((way_m + 0.15) / speed_m_s * rate_hz) + 2;
        for (int step = 0; step < steps && !broke; ++step) {
            scene.world.stepSimulation(btScalar(1 / rate_hz), 0);
            for (const BlowEvent& event : fracture.takeEvents())
                broke = broke || event.outcome == Outcome::broke;
        }
    }
    scene.world.removeRigidBody(&striker);
    return broke;
}

std::vector<StrikeCase> strikeCases() {
    const BreakableAsset cup = prepared(valueOrExit(BreakableAsset::fromObj(
        SHERD_ASSETS "/coffee_cup.obj", Material::ceramic(), Settings::forQuality(Quality::preview))));
    const BreakableAsset plate =
        boxOf(Material::plaster(), Vec3(-0.15, -0.15, -0.01), Vec3(0.15, 0.15, 0.01));
    const BreakableAsset wall = boxOf(Material::plaster(), Vec3(-0.02, -0.4, 0), Vec3(0.02, 0.4, 0.6));
    const BreakableAsset rod = boxOf(Material::ceramic(), Vec3(-0.01, -0.2, -0.01), Vec3(0.01, 0.2, 0.01));
    const BreakableAsset block =
        boxOf(Material::plaster(), Vec3(-0.06, -0.06, -0.06), Vec3(0.06, 0.06, 0.06));
    const btVector3 side(-0.3f, 0, 0), above(0, 0, 0.3f), slanting(0.3f, 0.1f, 0.15f),
        outside(0.3f, 0, 0.02f), aslant(0.05f, 0, 0.3f);
    const btQuaternion edge(btVector3(0, 0, 1), 0.6f), corner(btVector3(1, 0.3f, 0), 0.7f);
    const auto flat = btQuaternion::getIdentity();
    return {
        {"ball on a cup, floor", cup, true, ballOf(0.03), 0.3, {0, 0, 0.05f}, side, flat, 0.12},
        {"ball on a cup", cup, false, ballOf(0.03), 0.3, {0, 0.01f, 0.05f}, side, flat, 0.12},
        {"ball on a cup's lip", cup, true, ballOf(0.02), 0.3, {0.035f, 0, 0.09f}, above, flat, 0.11},
        {"box's edge on a cup", cup, false, cube, 0.5, {0, 0, 0.05f}, side, edge, 0.14},
        {"ball on a plate", plate, false, ballOf(0.03), 0.3, {0.03f, 0.02f, 0}, above, flat, 0.07},
        {"ball on a plate, floor", plate, true, ballOf(0.03), 0.3, {0.03f, 0.02f, 0}, above, flat, 0.07},
        {"ball slanting", plate, false, ballOf(0.03), 0.3, {0.03f, 0.02f, 0}, slanting, flat, 0.08},
        {"ball on a plate's edge", plate, false, ballOf(0.03), 0.3, {0.15f, 0.02f, 0}, outside, flat, 0.2},
        {"box flat on a plate", plate, false, cube, 0.5, {0.02f, 0, 0}, above, flat, 0.09},
        {"box's corner on a plate", plate, false, cube, 0.5, {0.02f, 0, 0}, above, corner, 0.1},
        {"ball on a wall, floor", wall, true, ballOf(0.05), 1, {0, 0.05f, 0.4f}, {-0.4f, 0, 0}, flat, 0.12},
        {"ball on a rod's end", rod, false, ballOf(0.02), 0.1, {0, 0.18f, 0}, side, flat, 0.055},
        {"ball on a rod's middle", rod, false, ballOf(0.02), 0.1, {0, 0, 0}, side, flat, 0.055},
        {"ball on a block, floor", block, true, ballOf(0.04), 1, {0, 0.01f, 0.06f}, aslant, flat, 0.18},
    };
}

void print(const StrikeCase& strike) {
    constexpr double slowest_m_s = 0.25, fastest_m_s = 26, apart = 1.19, beyond = 6;
    std::printf("%-24s", strike.name.c_str());
    int held = 0, cases = 0;
    for (const double rate_hz : {60.0, 120.0, 240.0, 960.0}) {
        double lowest = fastest_m_s, highest = 0;
        for (const double place : {0.0, 0.3, 0.55, 0.8}) {
            double first = 0;
            for (double speed = slowest_m_s; speed < fastest_m_s; speed *= apart) {
                if (first > 0 && (speed > beyond * first || speed / rate_hz > strike.way_m)) break;
                const bool broke = breaks(strike, speed, rate_hz, place);
                if (broke && first == 0) first = speed;
                if (first == 0) continue;
                ++cases;
                held += broke ? 0 : 1;
            }
            lowest = std::min(lowest, first);
            highest = std::max(highest, first);
        }
        std::printf("  %5.2f %5.2f", lowest, highest);
        std::fflush(stdout);
    }
    std::printf("  %3d of %d\n", held, cases);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string part = count > 1 ? arguments[1] : "";
    std::printf("%-24s  %11s  %11s  %11s  %11s  faster and held\n", "m/s", "60 Hz", "120 Hz", "240 Hz",
                "960 Hz");
    for (const StrikeCase& strike : strikeCases())
        if (strike.name.find(part) != std::string::npos) print(strike);
}
