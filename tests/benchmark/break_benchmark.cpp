// How long the step stands still in which a prepared body breaks: break_benchmark [FILE.obj [COUNT [SPEED
// [SECONDS [QUALITY]]]]]. The body stands on a floor, a steel ball of 2 kg strikes it from COUNT sides, at
// 240 Hz; what breaks of it breaks on for SECONDS. Prints the stages of the breaks, medians in milliseconds,
// and the blows on its fragments; without a file the cup, 20 sides, 12 m/s, 0.5 s and `game`. Then the ball
// flies for 0.2 s before, and each step waits for real time, as in a game: how many blows were foreseen, what
// the steps took in which the body broke, foreseen or not, and the longest other step.

#include <sherd/enum_names.h>
#include <sherd/sherd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "benchmark/floor_world.h"
#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/numerics/pi.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

/// Blows that were solved.
struct Blows {
    std::vector<StageTimes> ms;
    std::vector<double> totals, stepping, pieces;  // `stepping`: on the thread that steps

    void add(const BlowEvent& event) {
        ms.push_back(event.ms);
        totals.push_back(event.ms.total());
        stepping.push_back(totals.back() - event.ms_elsewhere.total());
        pieces.push_back(static_cast<double>(event.fragments.size()));
    }
    void print(const char* what) const {
        std::printf(
            "%s: %zu, %.0f pieces; ms: median %.2f, 90 %% %.2f, longest %.1f, on the thread that steps %.2f, "
            "%.2f, %.1f;",
            what, totals.size(), median(pieces), median(totals), quantile(totals, 0.9), quantile(totals, 1),
            median(stepping), quantile(stepping, 0.9), quantile(stepping, 1));
        for (const auto& field : time_fields<StageTimes>) {
            std::vector<double> of_stage;
            for (const StageTimes& one : ms) of_stage.push_back(one.*field.value);
            if (quantile(of_stage, 0.9) >= 0.1) std::printf("  %s %.2f", field.name, median(of_stage));
        }
        std::puts("");
    }
};

}  // namespace

int main(int count, char** arguments) {
    const std::string file = count > 1 ? arguments[1] : SHERD_ASSETS "/coffee_cup.obj";
    const int sides = count > 2 ? std::atoi(arguments[2]) : 20;
    const double speed = count > 3 ? std::atof(arguments[3]) : 12;
    const double seconds = count > 4 ? std::atof(arguments[4]) : 0.5;
    const std::string quality = count > 5 ? arguments[5] : "game";
    const Settings settings = valueOrExit(Settings::fromJson("{\"quality\": \"" + quality + "\"}"));
    const BreakableAsset asset = valueOrExit(BreakableAsset::fromObj(file, Material::ceramic(), settings));
    succeedOrExit(asset.prepare());
    Vec3 low = asset.surface().vertices.front(), high = low;
    for (const Vec3& vertex : asset.surface().vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const Vec3 size = high - low;
    const double across = 0.5 * std::hypot(size.x(), size.y());

    Blows broken, held, of_fragments, paced_of_fragments;
    std::vector<double> breaking_ms, other_ms;  // steps of the runs in which blows are foreseen
    long long foreseen = 0;
    const auto strikeFrom = [&](int side, bool ahead) {
        FloorWorld room;
        const double radius = std::cbrt(3 * 2.0 / (4 * pi * 7800));
        btSphereShape ball_shape{static_cast<btScalar>(radius)};
        btVector3 inertia;
        ball_shape.calculateLocalInertia(2, inertia);
        btRigidBody ball{2, nullptr, &ball_shape, inertia};
        FractureWorld fracture(&room.world);
        Budget budget;
        if (!ahead) budget.foresight_s = 0;
        succeedOrExit(fracture.setBudget(budget));
        const Vec3 stands(-0.5 * (low.x() + high.x()), -0.5 * (low.y() + high.y()), 0.001 - low.z());
        valueOrExit(fracture.add(
            asset, btTransform(btQuaternion::getIdentity(),
                               btVector3(btScalar(stands.x()), btScalar(stands.y()), btScalar(stands.z())))));
        const double angle = 2.399963 * side;  // the golden angle: no two sides alike
        const double height = std::max(radius * 1.05, size.z() * (side % 5 + 1) / 6.0);
        const double flight_s = ahead ? 0.2 : 0;
        const Vec3 from =
            (across + radius + 0.01 + speed * flight_s) * Vec3(std::cos(angle), std::sin(angle), 0);
        ball.setWorldTransform(
            btTransform(btQuaternion::getIdentity(),
                        btVector3(btScalar(from.x()), btScalar(from.y()), btScalar(height))));
        const Vec3 velocity = -speed * from.normalized();
        ball.setLinearVelocity(btVector3(btScalar(velocity.x()), btScalar(velocity.y()),
                                         btScalar(0.5 * gravity_m_s2 * flight_s)));  // falls back by then
        room.world.addRigidBody(&ball);
        constexpr std::chrono::duration<double> step_time(1.0 / 240);
        for (int step = 0; step < 240 * (flight_s + seconds); ++step) {
            const auto begin = std::chrono::steady_clock::now();
            room.world.stepSimulation(btScalar(step_time.count()), 0);
            const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
            bool whole_broke = false;
            for (const BlowEvent& event : fracture.takeEvents()) {
                if (event.outcome != Outcome::broke && event.outcome != Outcome::held) continue;
                const bool whole = event.asset.solid() == asset.solid();
                whole_broke = whole_broke || (whole && event.outcome == Outcome::broke);
                if (!whole)
                    (ahead ? paced_of_fragments : of_fragments).add(event);
                else if (!ahead)
                    (event.outcome == Outcome::broke ? broken : held).add(event);
            }
            if (!ahead) continue;
            (whole_broke ? breaking_ms : other_ms).push_back(took.count());
            std::this_thread::sleep_until(begin + step_time);
        }
        foreseen += fracture.counts().foreseen;
        room.world.removeRigidBody(&ball);
    };
    for (int side = 0; side < sides; ++side) strikeFrom(side, false);
    for (int side = 0; side < sides; ++side) strikeFrom(side, true);
    broken.print("broken");
    held.print("held");
    of_fragments.print("blows on fragments");
    paced_of_fragments.print("blows on fragments where steps wait for real time");
    std::printf(
        "%lld foreseen; ms: steps in which the whole breaks: median %.2f, longest %.1f; longest other %.1f\n",
        foreseen, median(breaking_ms), quantile(breaking_ms, 1), quantile(other_ms, 1));
}
