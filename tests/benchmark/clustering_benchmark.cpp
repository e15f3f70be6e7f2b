// Time to cluster a body: distances along the neighbour table against straight ones (the paper: 110 s against
// 4 s on its plane of 2739 particles). Everything is damaged; medians of processor time of one thread. Usage:
// clustering_benchmark MESH.obj SPACING_M CLUSTERS
//   the paper's plane: build/meshes/plane_52500.obj 0.00654 6

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

#include "core/clustering/clusters.h"
#include "core/clustering/wall_axes.h"
#include "core/sampling/sample_solid.h"

namespace {

using namespace sherd;

/// Of 15 seeds.
template <class Work>
double medianMilliseconds(const Work& work) {
    std::vector<double> times;
    for (std::uint64_t seed = 0; seed < 15; ++seed) {
        const std::clock_t start = std::clock();
        work(seed);
        times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::nth_element(times.begin(), times.begin() + 7, times.end());
    return times[7];
}

/// No more than the paper's two loops with straight distances: seeds by farthest point, each particle to the
/// nearest.
std::vector<int> bareClusters(const Discretisation& solid, int clusters, std::uint64_t seed) {
    const std::size_t count = solid.particles.size();
    std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
    std::vector<int> labels(count);
    std::size_t next = std::mt19937_64(seed)() % count;
    for (int label = 0; label < clusters; ++label) {
        for (std::size_t i = 0; i < count; ++i) {
            const double distance = (solid.particles[i].position - solid.particles[next].position).norm();
            if (distance < nearest[i]) nearest[i] = distance, labels[i] = label;
        }
        next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    }
    return labels;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return std::puts("Usage: clustering_benchmark MESH.obj SPACING_M CLUSTERS"), 1;
    const double spacing = std::atof(argv[2]);
    const int clusters = std::atoi(argv[3]);
    const auto mesh = readObj(argv[1]);
    if (!mesh) return std::puts(mesh.error().c_str()), 1;
    const auto solid = sampleSolid(mesh.value(), spacing, {});
    if (!solid) return std::puts(solid.error().c_str()), 1;

    Damage damage;
    damage.damaged.assign(solid.value().particles.size(), 1);
    damage.overstress.assign(solid.value().particles.size(), 1.0);
    GuideField straight;  // lambda 1: Eq. 18 is the straight distance
    straight.kind = GuideField::Kind::constant;
    straight.cost_along = 1;
    const double along = medianMilliseconds(
        [&](std::uint64_t seed) { clusterParticles(solid.value(), damage, clusters, 2 * spacing, seed); });
    const double direct = medianMilliseconds([&](std::uint64_t seed) {
        clusterParticles(solid.value(), damage, clusters, 2 * spacing, seed, straight);
    });
    const double bare =
        medianMilliseconds([&](std::uint64_t seed) { bareClusters(solid.value(), clusters, seed); });
    const double axes = medianMilliseconds([&](std::uint64_t) { wallAxes(solid.value()); });
    std::printf(
        "%zu particles, %d clusters, ms: path lengths %.2f, straight %.2f (%.2f times that), two bare loops "
        "%.2f; "
        "wall axes %.2f of all but the last\n",
        solid.value().particles.size(), clusters, along, direct, along / direct, bare, axes);
}
