// How scenes break first, by either crack pattern: share of the crack area within 20 degrees of radial or
// ring about the blow, pieces that are hooked into their neighbours, how flat cracks are, and the sizes of
// the pieces. Usage: crack_patterns SEEDS SCENE.json ... [-- KEY=VALUE ...]   (changes to all scenes, as
// --set of the demo takes them)

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "scenes/scene_file.h"
#include "support/break_measures.h"
#include "world/scene_world.h"

namespace {

using namespace demo;
using namespace sherd_tests;

struct FirstBreak {
    std::vector<TriangleMesh> pieces;  // in the frame of the whole
    Vec3 contact = Vec3::Zero(), direction = Vec3::UnitZ();
    double cluster_ms = 0, surface_ms = 0;
};

FirstBreak breakOf(const Scene& scene, const SceneAssets& assets) {
    SceneWorld world(scene, assets);
    FirstBreak first;
    for (double seconds = 0; seconds < scene.duration_s; seconds += scene.time_step_s) {
        const auto placed = world.states().front().placed;
        world.step();
        if (world.fracture().bodies().size() <= scene.bodies.size()) continue;
        for (const btRigidBody* body : world.fracture().bodies())
            first.pieces.push_back(world.fracture().asset(body)->surface());
        for (const auto& event : world.fracture().takeEvents()) {
            if (event.outcome != sherd::Outcome::broke) continue;
            first.contact = placed.inverse() * event.position;
            first.direction = placed.linear().transpose() * event.normal;
            first.cluster_ms = event.ms.cluster, first.surface_ms = event.ms.surface;
            break;
        }
        break;
    }
    return first;
}

void measure(Scene scene, int seeds) {
    double aligned = 0, flat = 0, cluster = 0, surface = 0, count = 0, hooked = 0, worst = 0;
    std::vector<double> sizes;
    int breaks = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        for (BreakableBody& body : scene.bodies)
            body.settings.strength.seed = body.settings.fracture.seed = static_cast<std::uint64_t>(seed);
        const auto assets = makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
        if (!assets) return void(std::puts(assets.error().c_str()));
        const FirstBreak first = breakOf(scene, assets.value());
        if (first.pieces.empty()) continue;
        ++breaks;
        AlignedShare share(first.contact, first.direction);
        double volume = 0;
        for (const TriangleMesh& piece : first.pieces) volume += volumeOf(piece);
        for (const TriangleMesh& piece : first.pieces) {
            const auto faces = crackFaces(piece);
            for (const CrackFace& face : faces) share.add(face);
            const double own = hookedShare(faces);
            hooked += own > 0.05;
            worst = std::max(worst, own);
            sizes.push_back(volumeOf(piece) / volume);
        }
        aligned += share.value();
        flat += flatness(first.pieces);
        count += static_cast<double>(first.pieces.size());
        cluster += first.cluster_ms, surface += first.surface_ms;
    }
    if (breaks == 0) return void(std::printf("%-14s no break\n", scene.name.c_str()));
    const SizeLaws laws = sizeLaws(sizes);
    std::printf(
        "%-14s %5.1f pieces, aligned %4.1f %%, hooked %4.1f %% (worst %2.0f %%), flat %.3f, sizes %.1f "
        "decades (%.1f without the least and the largest 2 %%) ^-%.2f, power law %+.3f a piece over one "
        "size, cluster %.2f ms, surface %.1f ms\n",
        scene.name.c_str(), count / breaks, 100 * aligned / breaks, 100 * hooked / count, 100 * worst,
        flat / breaks, laws.all_decades, laws.decades, laws.exponent, laws.power_law - laws.one_size,
        cluster / breaks, surface / breaks);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::puts("Usage: crack_patterns SEEDS SCENE.json ... [-- KEY=VALUE ...]"), 1;
    std::vector<std::string> files, changes;
    bool is_change = false;
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--")
            is_change = true;
        else
            (is_change ? changes : files).push_back(word);
    }
    for (const std::string& file : files) {
        const auto scene = readScene(file, "", changes);
        if (!scene) return std::puts(scene.error().c_str()), 1;
        measure(scene.value(), std::atoi(argv[1]));
    }
}
