// How long the step stands still in which a prepared body breaks: break_benchmark [FILE.obj [COUNT [SPEED
// [SECONDS [QUALITY]]]]]. The body stands on a floor, a steel ball of 2 kg strikes it from COUNT sides, at
// 240 Hz; what breaks of it breaks on for SECONDS. Prints the stages of the breaks, medians in milliseconds,
// and the blows on its fragments; without a file the cup, 20 sides, 12 m/s, 0.5 s and `game`.

#include <sherd/enum_names.h>
#include <sherd/sherd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
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
    std::vector<double> totals, pieces;

    void add(const BlowEvent& event) {
        ms.push_back(event.ms);
        totals.push_back(event.ms.total());
        pieces.push_back(static_cast<double>(event.fragments.size()));
    }
    void print(const char* what) const {
        std::printf("%s: %zu, %.0f pieces; ms: median %.2f, 90 %% %.2f, longest %.1f;", what, totals.size(),
                    median(pieces), median(totals), quantile(totals, 0.9), quantile(totals, 1));
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

    Blows broken, held, of_fragments;
    for (int side = 0; side < sides; ++side) {
        FloorWorld room;
        const double radius = std::cbrt(3 * 2.0 / (4 * pi * 7800));
        btSphereShape ball_shape{static_cast<btScalar>(radius)};
        btVector3 inertia;
        ball_shape.calculateLocalInertia(2, inertia);
        btRigidBody ball{2, nullptr, &ball_shape, inertia};
        FractureWorld fracture(&room.world);
        const Vec3 stands(-0.5 * (low.x() + high.x()), -0.5 * (low.y() + high.y()), 0.001 - low.z());
        valueOrExit(fracture.add(
            asset, btTransform(btQuaternion::getIdentity(),
                               btVector3(btScalar(stands.x()), btScalar(stands.y()), btScalar(stands.z())))));
        const double angle = 2.399963 * side;  // the golden angle: no two sides alike
        const double height = std::max(radius * 1.05, size.z() * (side % 5 + 1) / 6.0);
        const Vec3 from = (across + radius + 0.01) * Vec3(std::cos(angle), std::sin(angle), 0);
        ball.setWorldTransform(
            btTransform(btQuaternion::getIdentity(),
                        btVector3(btScalar(from.x()), btScalar(from.y()), btScalar(height))));
        const Vec3 velocity = -speed * from.normalized();
        ball.setLinearVelocity(btVector3(btScalar(velocity.x()), btScalar(velocity.y()), 0));
        room.world.addRigidBody(&ball);
        for (int step = 0; step < 240 * seconds; ++step) {
            room.world.stepSimulation(btScalar(1.0 / 240), 0);
            for (const BlowEvent& event : fracture.takeEvents()) {
                if (event.outcome != Outcome::broke && event.outcome != Outcome::held) continue;
                const bool whole = event.asset.solid() == asset.solid();
                (!whole ? of_fragments : event.outcome == Outcome::broke ? broken : held).add(event);
            }
        }
        room.world.removeRigidBody(&ball);
    }
    broken.print("broken");
    held.print("held");
    of_fragments.print("blows on fragments");
}
