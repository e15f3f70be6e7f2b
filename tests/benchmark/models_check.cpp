// What becomes of meshes as they come: reads OBJ files, repairs each, drops it on a floor, and looks at the
// pieces. Prints a table row a model: models_check [--height M] [--shell M] [--wrap] [--no-fall] FILE.obj ...
// Every mesh is scaled so that its box's diagonal is 0.3 m.

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/floor_world.h"
#include "support/piece_checks.h"

namespace {

using namespace sherd;

constexpr double size_m = 0.3;
constexpr double largest_volume_error = 1e-6;

struct Options {
    double height_m = 5;
    double shell_m = 0;
    bool wrap = false, fall = true;
    std::vector<std::string> files;
};

Options optionsOf(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--height" && i + 1 < argc)
            options.height_m = std::stod(argv[++i]);
        else if (word == "--shell" && i + 1 < argc)
            options.shell_m = std::stod(argv[++i]);
        else if (word == "--wrap")
            options.wrap = true;
        else if (word == "--no-fall")
            options.fall = false;
        else
            options.files.push_back(word);
    }
    return options;
}

double diagonalOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : mesh.vertices) box.extend(v);
    return box.diagonal().norm();
}

/// The mesh's faults by their first words: "open", "not a manifold" and so on.
std::string faultsOf(const std::string& refusal) {
    const std::pair<const char*, const char*> names[] = {
        {"has no area", "flat"},    {"belongs to", "crowded edges"},   {"is open", "open"},
        {"not oriented", "turned"}, {"single point", "pinched"},       {"intersects itself", "crossing"},
        {"inside out", "inverted"}, {"lies inside another", "nested"}, {"encloses no volume", "no volume"}};
    std::string faults;
    for (const auto& [words, name] : names) {
        const bool said = refusal.find(words) != std::string::npos;
        const bool crowded = std::strcmp(name, "crowded edges") == 0;
        if (!said || (crowded && refusal.find("not a manifold: the edge") == std::string::npos)) continue;
        faults += (faults.empty() ? "" : ", ") + std::string(name);
    }
    return faults.empty() ? "sound" : faults;
}

std::string mendsOf(const RepairReport& report) {
    std::string text;
    const auto say = [&](int count, const char* what) {
        if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    say(report.merged_vertices, "merged");
    say(report.doubled_triangles, "doubled");
    say(report.flat_triangles, "flat");
    say(report.turned_triangles, "turned");
    say(report.parted_places, "parted");
    say(report.filled_holes, "holes");
    say(report.crossings, "crossings");
    say(report.united_parts, "united");
    say(report.empty_parts, "empty");
    if (report.wrapped) text += text.empty() ? "wrapped" : ", wrapped";
    if (report.hollowed) text += text.empty() ? "hollowed" : ", hollowed";
    return text.empty() ? "-" : text;
}

struct Fall {
    int pieces = 0, unsound = 0;
    double volume_error = 0;  // of all pieces together, relative
    std::string fault;        // of the first piece that has one, or why nothing broke
};

/// Falls from `height_m`, tilted: it starts just above the floor with the speed that it has there by then.
Fall dropOnFloor(const BreakableAsset& asset, double height_m) {
    benchmarks::FloorWorld bullet;
    FractureWorld fracture(&bullet.world);
    const Eigen::Matrix3d tilt =
        (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.3, Vec3::UnitY())).toRotationMatrix();
    Eigen::AlignedBox3d box;
    for (const Vec3& v : asset.surface().vertices) box.extend(tilt * v);
    // Over the middle of the floor, wherever the mesh has its origin.
    const Vec3 start_at(-box.center().x(), -box.center().y(), 0.01 - box.min().z());
    const Eigen::Quaterniond q(tilt);
    const btTransform start(
        btQuaternion(btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())),
        btVector3(btScalar(start_at.x()), btScalar(start_at.y()), btScalar(start_at.z())));
    Fall fall;
    const auto body = fracture.add(asset, start);
    if (!body) return {0, 0, 0, body.error()};
    body.value()->setLinearVelocity(btVector3(0, 0, btScalar(-std::sqrt(2 * 9.81 * height_m))));
    for (int step = 0; step < 48 && fall.pieces == 0; ++step) {
        bullet.world.stepSimulation(btScalar(1. / 240), 0);
        for (const BlowEvent& event : fracture.takeEvents()) {
            if (event.outcome != Outcome::broke) fall.fault = event.message;
            fall.volume_error = std::max(fall.volume_error, event.volume_error_rel);
            for (const btRigidBody* fragment : event.fragments) {
                ++fall.pieces;
                const std::string fault = fragment_support::faultOf(fracture.asset(fragment)->surface());
                if (fault.empty()) continue;
                if (fall.unsound++ == 0) fall.fault = fault;
            }
        }
    }
    return fall;
}

/// A row of the table; whether the model was accepted and broke into sound pieces.
bool check(const std::string& file, const Options& options) {
    const std::string name = std::filesystem::path(file).stem().string();
    const auto raw = readObj(file);
    if (!raw) {
        std::printf("| %s | | %s | | | | | | | |\n", name.c_str(), raw.error().c_str());
        return false;
    }
    Repair none, repair = Repair::automatic();
    none.scale = repair.scale = size_m / diagonalOf(raw.value());
    if (options.wrap) repair.mode = Repair::Mode::wrap;
    repair.shell_thickness_m = options.shell_m;
    const auto as_it_is = repairMesh(raw.value(), none);
    const auto start = std::chrono::steady_clock::now();
    const auto repaired = repairMesh(raw.value(), repair);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("| %s | %zu | %s | ", name.c_str(), raw.value().triangles.size(),
                faultsOf(as_it_is.error()).c_str());
    if (!repaired) {
        std::printf("REFUSED: %s | %.1f | | | | | |\n", repaired.error().c_str(), seconds);
        return false;
    }
    const RepairReport& report = repaired.value().report;
    std::printf("%s | %.1f | %zu | %.2f / %.2f | ", mendsOf(report).c_str(), seconds,
                repaired.value().mesh.triangles.size(), 100 * report.largest_distance_m / report.size_m,
                100 * report.largest_loss_m / report.size_m);
    std::fflush(stdout);
    if (!options.fall) {
        const std::string fault = fragment_support::faultOf(repaired.value().mesh);
        std::printf("| | %s |\n", fault.c_str());
        return fault.empty();
    }
    const auto asset = BreakableAsset::fromMesh(repaired.value().mesh, Material::ceramic(),
                                                Settings::forQuality(Quality::preview));
    const Fall fall = asset ? dropOnFloor(asset.value(), options.height_m) : Fall{0, 0, 0, asset.error()};
    const bool sound = fall.pieces > 1 && fall.unsound == 0 && fall.volume_error < largest_volume_error;
    std::printf("%d | %.0e | %s |\n", fall.pieces, fall.volume_error, sound ? "sound" : fall.fault.c_str());
    std::fflush(stdout);
    return sound;
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = optionsOf(argc, argv);
    std::printf(
        "| model | triangles | faults | repaired | s | triangles then | %% of size: from / lost of the "
        "original | pieces | volume lost | |\n|---|---|---|---|---|---|---|---|---|---|\n");
    std::size_t good = 0;
    for (const std::string& file : options.files) good += check(file, options);
    std::printf("\n%zu of %zu were accepted, broke, and have sound pieces only.\n", good,
                options.files.size());
    return good == options.files.size() ? 0 : 1;
}
