// 30 cups and a ball of 12 m/s: prints what identifies the motion of all bodies, step by step, or runs itself
// several times and compares. Beyond Bullet's pool of 4096 contacts the allocator decides where contacts are,
// and each process has addresses of its own.
//
//   cups_reproducibility SHAPE              one run: step, bodies, contacts, hash of all bits so far
//   cups_reproducibility SHAPE RUNS         several processes; fails at the first step that differs
//   cups_reproducibility SHAPE RUNS STEPS   with another number of steps than 480

#include <sherd/enum_names.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "support/cup_room.h"

namespace {

constexpr double time_step_s = 1.0 / 240;

/// FNV-1a over the bits.
void mix(std::uint64_t& hash, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001B3ull;
}

void mixBody(std::uint64_t& hash, const btRigidBody& body) {
    btScalar matrix[16];
    body.getWorldTransform().getOpenGLMatrix(matrix);
    mix(hash, matrix, sizeof matrix);
    mix(hash, &body.getLinearVelocity(), 3 * sizeof(btScalar));
    mix(hash, &body.getAngularVelocity(), 3 * sizeof(btScalar));
}

bool shapeOf(const std::string& name, sherd::CollisionShape& shape) {
    for (const auto& known : sherd::enum_names<sherd::CollisionShape>) {
        if (name != known.name) continue;
        shape = known.value;
        return true;
    }
    return false;
}

int runOnce(sherd::CollisionShape shape, int steps) {
    sherd::CupRoom room;
    btDiscreteDynamicsWorld& world = room.world;
    {
        sherd::FractureWorld fracture(&world);
        sherd::Settings settings = sherd::Settings::forQuality(sherd::Quality::preview);
        settings.fracture.collision_shape = shape;
        const auto cup = sherd::BreakableAsset::fromObj(SHERD_ASSETS "/coffee_cup.obj",
                                                        sherd::Material::ceramic(), settings);
        if (!cup) {
            std::puts(cup.error().c_str());
            return 1;
        }
        if (const auto added = sherd::CupRoom::addCups(fracture, cup.value()); !added) {
            std::puts(added.error().c_str());
            return 1;
        }
        std::uint64_t hash = 0xCBF29CE484222325ull;
        for (int step = 0; step < steps; ++step) {
            world.stepSimulation(btScalar(time_step_s), 0);
            const auto& objects = world.getCollisionObjectArray();
            for (int i = 0; i < objects.size(); ++i) mixBody(hash, *btRigidBody::upcast(objects[i]));
            fracture.takeEvents();
            std::printf("%d %d %d %016llx\n", step, objects.size(), room.dispatcher.getNumManifolds(),
                        static_cast<unsigned long long>(hash));
        }
    }
    return 0;
}

/// The lines of one process.
std::vector<std::string> linesOf(const std::string& command) {
    std::vector<std::string> lines;
    std::FILE* output = popen(command.c_str(), "r");
    char line[256];
    while (output && std::fgets(line, sizeof line, output)) lines.emplace_back(line);
    if (!output || pclose(output) != 0) lines.clear();
    return lines;
}

int compare(const std::string& program, const std::string& shape, int runs, int steps) {
    const std::string command = "'" + program + "' " + shape + " 1 " + std::to_string(steps);
    std::vector<std::string> first;
    for (int run = 0; run < runs; ++run) {
        const std::vector<std::string> lines = linesOf(command);
        if (static_cast<int>(lines.size()) != steps) {
            std::printf("run %d ended after %zu of %d steps\n", run, lines.size(), steps);
            return 1;
        }
        if (run == 0) {
            first = lines;
            std::printf("run 0: step, bodies, contacts, bits: %s", lines.back().c_str());
        }
        for (int step = 0; step < steps; ++step)
            if (lines[step] != first[step]) {
                std::printf("run %d differs from the first:\n%s%s", run, first[step].c_str(),
                            lines[step].c_str());
                return 1;
            }
    }
    std::printf("%d runs of %d steps: the same bits\n", runs, steps);
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    sherd::CollisionShape shape{};
    const int runs = count > 2 ? std::atoi(arguments[2]) : 1,
              steps = count > 3 ? std::atoi(arguments[3]) : 480;
    if (count < 2 || !shapeOf(arguments[1], shape) || runs < 1 || steps < 1) {
        std::puts("usage: cups_reproducibility automatic|boxes|hull|convex_parts [RUNS [STEPS]]");
        return 2;
    }
    return runs == 1 ? runOnce(shape, steps) : compare(arguments[0], arguments[1], runs, steps);
}
