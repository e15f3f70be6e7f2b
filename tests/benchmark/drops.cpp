// How the pieces of broken bodies come to rest, for each collision shape: bodies fall on a floor in five
// orientations, and are watched for six seconds. Usage:
//   drops [--shapes NAME,NAME] [--height M] [--quality NAME] [--seed N] [--once] [--plain] [--each] [FILE.obj
//   ...]
// Without files: slab, cup, plate, aeroplane and a trough; files are repaired and scaled to 0.3 m. --once:
// pieces do not break again. --plain: the same pieces once more from where they were born, in a world without
// Sherd.
//
// Energy is kinetic and potential, of all pieces; a rise is that of one step after the first break, over the
// kinetic energy before it. Depth is that of the deepest vertex of a surface below the floor at the end, in
// particle spacings of the body that fell.

#include <btBulletDynamicsCommon.h>
#include <sherd/enum_names.h>
#include <sherd/sherd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "benchmark/drop_worlds.h"
#include "benchmark/value_or_exit.h"
#include "core/numerics/stopwatch.h"
#include "generators/generators.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

constexpr int steps = 1440;
constexpr double file_size_m = 0.3;

struct Options {
    std::vector<CollisionShape> shapes;
    double height_m = 1;
    Quality quality = Quality::preview;
    std::uint64_t seed = 1;
    bool once = false, plain = false, each = false;
    std::vector<std::string> files;
};

template <class Enum>
Enum named(const std::string& name) {
    for (const auto& entry : enum_names<Enum>)
        if (name == entry.name) return entry.value;
    std::fprintf(stderr, "%s is not known\n", name.c_str());
    std::exit(2);
}

const char* nameOf(CollisionShape shape) {
    for (const auto& entry : enum_names<CollisionShape>)
        if (entry.value == shape) return entry.name;
    return "";
}

Options optionsOf(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool has_value = i + 1 < argc;
        if (word == "--shapes" && has_value) {
            std::istringstream names(argv[++i]);
            for (std::string name; std::getline(names, name, ',');)
                options.shapes.push_back(named<CollisionShape>(name));
        } else if (word == "--height" && has_value)
            options.height_m = std::atof(argv[++i]);
        else if (word == "--quality" && has_value)
            options.quality = named<Quality>(argv[++i]);
        else if (word == "--seed" && has_value)
            options.seed = std::strtoull(argv[++i], nullptr, 10);
        else if (word == "--once")
            options.once = true;
        else if (word == "--plain")
            options.plain = true;
        else if (word == "--each")
            options.each = true;
        else
            options.files.push_back(word);
    }
    if (options.shapes.empty())
        for (const auto& entry : enum_names<CollisionShape>) options.shapes.push_back(entry.value);
    return options;
}

struct Body {
    std::string name;
    TriangleMesh surface;
};

std::vector<Body> bodiesOf(const Options& options) {
    std::vector<Body> bodies;
    for (const std::string& file : options.files) {
        const TriangleMesh raw = valueOrExit(readObj(file));
        Eigen::AlignedBox3d box;
        for (const Vec3& v : raw.vertices) box.extend(v);
        Repair repair = Repair::automatic();
        repair.scale = file_size_m / box.diagonal().norm();
        bodies.push_back(
            {std::filesystem::path(file).stem().string(), valueOrExit(repairMesh(raw, repair)).mesh});
    }
    if (!bodies.empty()) return bodies;
    bodies.push_back({"slab", shapes::slab(Vec3(0.3, 0.2, 0.02), 12, 8, 1)});
    for (const char* name : {"coffee_cup", "coffee_plate", "plane"})
        bodies.push_back({name, valueOrExit(generators::generate(name, 20000))});
    bodies.push_back({"trough", shapes::uShape(0.02, 0.1, 0.12, 0.15)});
    return bodies;
}

int partsOf(const btCollisionShape& shape) {
    return shape.isCompound() ? static_cast<const btCompoundShape&>(shape).getNumChildShapes() : 1;
}

struct Drop {
    bool broke = false;
    int pieces = 0, parts = 0, most_parts = 0, awake = 0, breaks = 0;
    double slept_s = 0;  // when the last piece fell asleep
    double depth = 0, rise = 0, shapes_ms = 0, step_ms = 0;
    double plain_rise = 0, plain_depth = 0;
    int plain_awake = 0;
};

Drop dropOnFloor(const BreakableAsset& asset, CollisionShape shape, int orientation, const Options& options) {
    World bullet;
    FractureWorld fracture(&bullet.world);
    BodyOptions body_options(startOf(asset.surface(), orientation));
    body_options.velocity = btVector3(0, 0, btScalar(-std::sqrt(2 * gravity_m_s2 * options.height_m)));
    body_options.fracture = asset.settings().fracture;
    body_options.fracture->collision_shape = shape;
    body_options.fracture->seed = options.seed;
    if (options.once) body_options.fracture->rest_after_break_s = 1e9;
    valueOrExit(fracture.add(asset, body_options));
    Drop drop;
    double scale = kineticEnergy(*fracture.bodies().front()), before = 0;
    std::unique_ptr<PlainTwin> twin;
    int twin_steps = 0;
    std::vector<double> plain_ms;
    for (int step = 0; step < steps; ++step) {
        const double sherd_before = fracture.times().whole;
        const Stopwatch watch;
        bullet.step();
        const double ms = watch.milliseconds() - (fracture.times().whole - sherd_before);
        const bool had_broken = drop.broke;
        for (const BlowEvent& event : fracture.takeEvents()) {
            if (event.outcome != Outcome::broke) continue;
            ++drop.breaks;
            drop.broke = true;
            drop.shapes_ms += event.ms.bodies;
        }
        const std::vector<btRigidBody*> bodies = fracture.bodies();
        const double now = energy(bodies);
        if (had_broken) {
            drop.rise = std::max(drop.rise, (now - before) / scale);
            plain_ms.push_back(ms);
            const bool any = std::any_of(bodies.begin(), bodies.end(), [](auto* b) { return b->isActive(); });
            if (any) drop.slept_s = (step + 1) * time_step_s;
        } else if (drop.broke && options.plain) {
            twin = std::make_unique<PlainTwin>(fracture, shape);
            twin_steps = steps - step - 1;
        }
        before = now;
    }
    const double spacing = asset.solid()->spacing();
    for (const btRigidBody* piece : fracture.bodies()) {
        ++drop.pieces;
        const int parts = partsOf(*piece->getCollisionShape());
        drop.parts += parts;
        drop.most_parts = std::max(drop.most_parts, parts);
        drop.awake += piece->isActive();
        const TriangleMesh& surface = fracture.asset(piece)->surface();
        drop.depth = std::max(drop.depth, depthOf(surface, fracture.assetTransform(piece)) / spacing);
    }
    if (!plain_ms.empty()) {  // the busiest second: pieces sleep later
        plain_ms.resize(std::min<std::size_t>(plain_ms.size(), 240));
        std::nth_element(plain_ms.begin(), plain_ms.begin() + plain_ms.size() / 2, plain_ms.end());
        drop.step_ms = plain_ms[plain_ms.size() / 2];
    }
    if (twin) {
        const PlainTwin::Rest rest = twin->run(twin_steps);
        drop.plain_awake = rest.awake;
        drop.plain_depth = rest.depth / spacing;
        drop.plain_rise = rest.rise / scale;
    }
    return drop;
}

struct Totals {
    int drops = 0, restless = 0, sunk = 0, rising = 0, pieces = 0, parts = 0;
    double worst_depth = 0, worst_rise = 0, shapes_ms = 0, step_ms = 0;
    int plain_restless = 0;
    double plain_rise = 0, plain_depth = 0;
};

void printDrop(const std::string& name, const char* shape, int orientation, const Drop& drop) {
    std::printf(
        "%s %s %d: breaks %d pieces %d parts %d (%d) awake %d slept %.2f s depth %.2f rise %.3f %% bodies "
        "%.2f "
        "ms step %.3f ms | plain: awake %d depth %.2f rise %.3f %%\n",
        name.c_str(), shape, orientation, drop.breaks, drop.pieces, drop.parts, drop.most_parts, drop.awake,
        drop.slept_s, drop.depth, 100 * drop.rise, drop.shapes_ms, drop.step_ms, drop.plain_awake,
        drop.plain_depth, 100 * drop.plain_rise);
    std::fflush(stdout);
}

void add(const Drop& drop, Totals& totals) {
    ++totals.drops;
    totals.restless += drop.awake > 0;
    totals.sunk += drop.depth > 0.3;
    totals.rising += drop.rise > 1e-3;
    totals.pieces += drop.pieces;
    totals.parts += drop.parts;
    totals.worst_depth = std::max(totals.worst_depth, drop.depth);
    totals.worst_rise = std::max(totals.worst_rise, drop.rise);
    totals.shapes_ms += drop.shapes_ms;
    totals.step_ms += drop.step_ms;
    totals.plain_restless += drop.plain_awake > 0;
    totals.plain_rise = std::max(totals.plain_rise, drop.plain_rise);
    totals.plain_depth = std::max(totals.plain_depth, drop.plain_depth);
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = optionsOf(argc, argv);
    std::vector<Totals> totals(options.shapes.size());
    for (const Body& body : bodiesOf(options)) {
        const auto asset = valueOrExit(BreakableAsset::fromMesh(body.surface, Material::ceramic(),
                                                                Settings::forQuality(options.quality)));
        for (std::size_t s = 0; s < options.shapes.size(); ++s)
            for (int orientation = 0; orientation < orientations; ++orientation) {
                const Drop drop = dropOnFloor(asset, options.shapes[s], orientation, options);
                if (options.each) printDrop(body.name, nameOf(options.shapes[s]), orientation, drop);
                if (drop.broke) add(drop, totals[s]);
            }
    }
    std::printf(
        "| shape | drops | not asleep | deeper than 0.3 | rises above 0.1 %% | pieces | parts | bodies, ms | "
        "step, ms | "
        "worst depth | worst rise | plain: not asleep | depth | rise "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t s = 0; s < options.shapes.size(); ++s) {
        const Totals& t = totals[s];
        std::printf(
            "| %s | %d | %d | %d | %d | %d | %d | %.1f | %.3f | %.2f | %.3f %% | %d | %.2f | %.3f %% |\n",
            nameOf(options.shapes[s]), t.drops, t.restless, t.sunk, t.rising, t.pieces, t.parts, t.shapes_ms,
            t.step_ms / std::max(t.drops, 1), t.worst_depth, 100 * t.worst_rise, t.plain_restless,
            t.plain_depth, 100 * t.plain_rise);
    }
    return 0;
}
