// Time from labels to fragments: surfaces cut (on one thread, and on all: how long one waits), solids and
// boxes made of them, volumes summed; smallest of the repeats, processor time but for the waiting. Usage:
// cutting_benchmark [REPEATS [BODY]]
//   cup: 19,406 triangles of the demo, 17 pieces; wall: 154,660 triangles, 968 particles, 33 pieces, as
//   the paper's; both along the planes that a stress makes, the default, and between clusters, as the
//   paper's. The others are there for the hash over all that comes out, which tells whether a change of the
//   code left the fragments alone.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "benchmark/value_or_exit.h"
#include "core/clustering/bisection.h"
#include "core/clustering/clusters.h"
#include "core/clustering/wall_axes.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
#include "core/stress/elasticity.h"
#include "fracture/conservation.h"
#include "fracture/fragments.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

/// FNV-1a over the bits of the numbers that are added.
class Hash {
  public:
    void add(double value) {
        unsigned char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (std::size_t i = 0; i < sizeof value; ++i) value_ = (value_ ^ bytes[i]) * 0x100000001b3ULL;
    }
    unsigned long long value() const { return value_; }

  private:
    unsigned long long value_ = 0xcbf29ce484222325ULL;
};

/// What a triangle of a piece has, from its least corner on: the same wherever it is in the list.
std::vector<double> describe(const FragmentSurfaces& surfaces, const FragmentSurface& piece, std::size_t t) {
    const TriangleMesh& mesh = piece.mesh;
    const std::array<int, 3>& corners = mesh.triangles[t];
    const auto place = [&](int i) {
        const Vec3& x = mesh.vertices[corners[i]];
        return std::make_tuple(x.x(), x.y(), x.z());
    };
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (place(i) < place(least)) least = i;
    const int across = piece.across[t];
    std::vector<double> all = {double(piece.label), double(piece.parents[t]), double(mesh.kinds[t]),
                               double(across < 0 ? -1 : surfaces.pieces[across].label)};
    const auto add = [&](const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
    for (int k = 0; k < 3; ++k) {
        const int i = (least + k) % 3;
        add(mesh.vertices[corners[i]]);
        if (!mesh.normals.empty() && across < 0) add(mesh.normals[t][i]);
        if (!mesh.texture_coordinates.empty()) add(mesh.texture_coordinates[t][i]);
    }
    if (!mesh.material.empty()) all.push_back(mesh.material[t]);
    return all;
}

/// Of the bits of all triangles and boxes, whatever their order. The last bits of colours and normals of
/// crack faces depend on it: they are left out.
unsigned long long hashOf(const FragmentSurfaces& surfaces, const std::vector<Fragment>& fragments) {
    std::vector<std::vector<double>> all;
    for (const FragmentSurface& piece : surfaces.pieces)
        for (std::size_t t = 0; t < piece.parents.size(); ++t) all.push_back(describe(surfaces, piece, t));
    for (const Fragment& fragment : fragments)
        for (const auto& [centre, half] : fragment.boxes)
            all.push_back({centre.x(), centre.y(), centre.z(), half.x(), half.y(), half.z()});
    std::sort(all.begin(), all.end());
    Hash hash;
    for (const std::vector<double>& values : all)
        for (const double value : values) hash.add(value);
    return hash.value();
}

/// Processor time of this thread, ms: other threads of the program may spin while they wait for work.
double now() {
    std::timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

struct Case {
    std::string name;
    TriangleMesh surface;
    int clusters = 17;
    double spacing_m = 0;
    double roughness = 0;
    GuideField guide = {};
    std::uint64_t seed = 1;
    bool supported = false;
    bool by_stress = false;  ///< cracks are planes
};

/// Tension about the middle of the body's edge, the most there, everything damaged.
Damage damageOf(const Case& c, const Discretisation& sampling) {
    const auto box = boundingBox(c.surface);
    const double size = box.sizes().maxCoeff();
    const Vec3 middle = box.center() + Vec3(0.5 * box.sizes().x(), 0, 0);
    Damage damage;
    for (const Particle& particle : sampling.particles) {
        const Vec3 away = particle.position - middle;
        const Vec3 around = Vec3::UnitX().cross(away + 1e-3 * size * Vec3::UnitY()).normalized();
        damage.damaged.push_back(1);
        damage.overstress.push_back(c.by_stress ? 1 + 3 * std::exp(-4 * away.norm() / size) : 1);
        damage.stress.push_back(
            toSymmetricTensor(Mat3(damage.overstress.back() * around * around.transpose())));
    }
    damage.count = static_cast<int>(sampling.particles.size());
    return damage;
}

FragmentLabels labelsOf(const Case& c, const Discretisation& sampling, double wall_thickness_m) {
    const Damage damage = damageOf(c, sampling);
    if (c.by_stress)
        return bisectParticles(sampling, wallAxes(sampling), damage, c.clusters, 1000, wall_thickness_m,
                               c.seed);
    const BlowAxis axis{boundingBox(c.surface).center(), Vec3::UnitX()};
    return clusterParticles(sampling, damage, c.clusters, wall_thickness_m, c.seed, c.guide, axis);
}

void measure(const Case& c, int repeats) {
    Settings settings = Settings::forQuality(Quality::game);
    settings.sampling.spacing_m = c.spacing_m;
    settings.fracture.crack_roughness = c.roughness;
    settings.fracture.largest_fragment_count = 100;
    const auto solid = valueOrExit(BreakableSolid::make(c.surface, Material::ceramic(), settings));
    const auto sampling = valueOrExit(solid->discretisation());
    const FragmentLabels labels = labelsOf(c, *sampling, solid->wallThickness());
    const StrikeContext struck{*solid, *sampling, settings.fracture, c.seed};

    double cut_ms = std::numeric_limits<double>::infinity(), wait_ms = cut_ms, make_ms = cut_ms,
           sum_ms = cut_ms;
    unsigned long long hash = 0;
    std::size_t pieces = 0, triangles = 0, notes = 0;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const auto begin = std::chrono::steady_clock::now();
        valueOrExit(cutPieces(struck, labels));
        const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - begin;
        wait_ms = std::min(wait_ms, waited.count());
        const OnThisThreadAlone all_of_it;
        double start = now();
        const FragmentSurfaces surfaces = valueOrExit(cutPieces(struck, labels));
        cut_ms = std::min(cut_ms, now() - start);
        FragmentSurfaces kept = surfaces;
        start = now();
        const std::vector<Fragment> fragments = makeFragments(struck, labels, std::move(kept));
        make_ms = std::min(make_ms, now() - start);
        start = now();
        const ConservationErrors errors = conservationErrors(*solid, fragments);
        sum_ms = std::min(sum_ms, now() - start);
        if (!(errors.volume_rel < 1e-9)) std::printf("the volumes do not add up\n");
        if (repeat == 0) hash = hashOf(surfaces, fragments);
        pieces = surfaces.pieces.size(), notes = surfaces.notes.size(), triangles = 0;
        for (const FragmentSurface& piece : surfaces.pieces) triangles += piece.mesh.triangles.size();
    }
    std::printf("| %-14s | %6zu | %5zu | %3zu | %6zu | %7.2f | %7.2f | %7.2f | %6.3f | %016llx | %zu\n",
                c.name.c_str(), c.surface.triangles.size(), sampling->particles.size(), pieces, triangles,
                cut_ms, wait_ms, make_ms, sum_ms, hash, notes);
    std::fflush(stdout);
}

/// All that a mesh may carry along to its fragments.
TriangleMesh decorated(TriangleMesh mesh) {
    for (const Vec3& v : mesh.vertices) mesh.colours.push_back((0.5 + v.array() * 3).min(1).max(0));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const TriangleCorners corners = cornersOf(mesh, t);
        const Vec3 normal = areaVector(corners).normalized();
        mesh.normals.push_back({normal, normal, normal});
        mesh.texture_coordinates.push_back(
            {corners[0].head<2>(), corners[1].head<2>(), corners[2].head<2>()});
    }
    return mesh;
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 15;
    const TriangleMesh cup = valueOrExit(readObj(SHERD_ASSETS "/coffee_cup.obj"));
    const TriangleMesh wall = shapes::slab({1, 1, 0.09}, 185, 185, 12);
    GuideField radial;
    radial.kind = GuideField::Kind::radial;
    std::vector<Case> cases = {{"cup, planes", cup, 17, 0, 0, {}, 1, false, true},
                               {"wall, planes", wall, 33, 1 / 22.0, 0, {}, 1, false, true},
                               {"cup", cup},
                               {"wall", wall, 33, 1 / 22.0},
                               {"cup, seed 2", cup, 17, 0, 0, {}, 2},
                               {"cup, 5 mm", cup, 9, 0.005, 0, {}, 3},
                               {"cup, rough", cup, 25, 0, 0.3, {}, 4},
                               {"cup, decorated", decorated(cup), 17, 0, 0, {}, 5},
                               {"wall, radial", wall, 20, 0.05, 0, radial, 6},
                               {"hollow ball", shapes::hollowSphere(0.5, 0.4, 4), 40, 0.08, 0, {}, 7},
                               {"box", shapes::slab({1, 1, 1}), 30, 0.1, 0.2, {}, 8},
                               {"two legs", shapes::uShape(0.1, 0.03, 0.6, 0.4), 12, 0.05, 0, {}, 9},
                               {"plate", shapes::slab({1, 1, 0.09}, 24, 24, 3), 60, 1 / 22.0, 0, {}, 10},
                               {"fine cup", shapes::cup(0.04, 0.09, 0.004, 250, 100), 37, 0.004, 0, {}, 11}};
    for (std::uint64_t seed = 20; seed < 26; ++seed)
        cases.push_back({"ball", shapes::icosphere(0.5, 3), 15, 0.1, 0, {}, seed});
    std::printf(
        "| body | triangles | particles | pieces | their triangles | cut ms | on all cores | make ms | sum "
        "ms | hash |\n");
    for (const Case& c : cases)
        if (argc < 3 || c.name == argv[2]) measure(c, repeats);
}
