// How the scenes break: which way cracks run, whatever the time step.
#include <algorithm>
#include <iostream>
#include <numeric>

#include "demos/stage.h"
#include "support/break_measures.h"
#include "support/piece_checks.h"

namespace {

using namespace demo_tests;
using sherd::SurfaceKind;
using sherd::TriangleMesh;

/// The surfaces right after the first break, in the frame of the whole, and where the blow fell there.
struct FirstBreak {
    std::vector<TriangleMesh> pieces;
    Vec3 contact = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
};

FirstBreak breakOf(const SeededScene& scene, std::uint64_t seed) {
    Stage stage = scene.stage(seed);
    EXPECT_TRUE(stage.runToBreak(1.5));
    FirstBreak first;
    for (const btRigidBody* body : stage.world->fracture().bodies())
        first.pieces.push_back(stage.world->fracture().asset(body)->surface());
    for (const auto& event : stage.events) {
        if (event.outcome != sherd::Outcome::broke) continue;
        first.contact = stage.before_step.inverse() * event.position;
        first.direction = stage.before_step.linear().transpose() * event.normal;
        break;
    }
    return first;
}

Vec3 extent(const TriangleMesh& mesh) {
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& v : mesh.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    return high - low;
}

/// Mean over all pieces.
Vec3 meanExtent(const FirstBreak& first) {
    Vec3 sum = Vec3::Zero();
    for (const TriangleMesh& piece : first.pieces) sum += extent(piece);
    return sum / static_cast<double>(first.pieces.size());
}

template <class Visit>
void forEachCrackFace(const FirstBreak& first, const Visit& visit) {
    for (const TriangleMesh& piece : first.pieces)
        for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
            if (piece.kinds[t] != SurfaceKind::crack) continue;
            const auto& [a, b, c] = piece.triangles[t];
            const Vec3 &p = piece.vertices[a], &q = piece.vertices[b], &r = piece.vertices[c];
            const Vec3 area = (q - p).cross(r - p) / 2;
            visit((p + q + r) / 3, area.normalized(), area.norm());
        }
}

constexpr int seeds = 10;

std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
    return rank;
}

/// Spearman's: Pearson's correlation of the ranks.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto x = ranks(a), y = ranks(b);
    const double mean = (static_cast<double>(x.size()) - 1) / 2;
    double xy = 0, xx = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - mean) * (y[i] - mean);
        xx += (x[i] - mean) * (x[i] - mean);
    }
    return xy / xx;
}

TEST(Patterns, WoodSplitsAlongItsGrain) {
    double along = 0, across = 0;
    const SeededScene scene(named("wood_wall"));
    for (int seed = 1; seed <= seeds; ++seed) {
        const Vec3 mean = meanExtent(breakOf(scene, seed));
        along += mean.z();
        across += mean.x();
    }
    std::cout << "extent along the grain over that across: " << along / across << "\n";
    EXPECT_GT(along / across, 3);
}

/// Upright over level crack area of the plaster wall, and its pieces' height over their width for each seed.
struct Directions {
    double upright_over_level = 0;
    std::vector<double> height_over_width;
};

Directions directionsOfPlaster(sherd::CrackPattern pattern) {
    Directions found;
    double upright = 0, level = 0;
    Scene scene = named("plaster_wall");
    scene.bodies[0].settings.fracture.crack_pattern = pattern;
    const SeededScene seeded(scene);
    for (int seed = 1; seed <= seeds; ++seed) {
        const FirstBreak first = breakOf(seeded, seed);
        const Vec3 mean = meanExtent(first);
        found.height_over_width.push_back(mean.z() / mean.x());
        forEachCrackFace(first, [&](const Vec3&, const Vec3& normal, double area) {
            upright += area * normal.x() * normal.x();
            level += area * normal.z() * normal.z();
        });
    }
    found.upright_over_level = upright / level;
    std::cout << "upright over level crack area: " << found.upright_over_level << "\n";
    return found;
}

TEST(Patterns, PlasterPrefersNoDirection) {
    const Directions found = directionsOfPlaster(sherd::CrackPattern::seeds);
    for (const double ratio : found.height_over_width) EXPECT_NEAR(ratio, 1, 0.15);
    EXPECT_NEAR(found.upright_over_level, 1, 0.15);
}

// A few large pieces decide the mean of each break: only that of several says something.
TEST(Patterns, CracksThatFollowTheStressOfPlasterPreferNoDirection) {
    const Directions found = directionsOfPlaster(sherd::CrackPattern::stress);
    const auto& ratios = found.height_over_width;
    EXPECT_NEAR(std::accumulate(ratios.begin(), ratios.end(), 0.0) / seeds, 1, 0.15);
    EXPECT_NEAR(found.upright_over_level, 1, 0.15);
}

// Share of the crack area whose plane is within 20 degrees of the radial plane (which holds the axis of the
// blow) or the tangential one.
TEST(Patterns, GlassCracksRunAwayFromTheBlowOrAroundIt) {
    const double least = std::cos(20 * std::acos(-1) / 180);
    double aligned = 0, all = 0;
    const SeededScene scene(named("glass_wall"));
    for (int seed = 1; seed <= seeds; ++seed) {
        const FirstBreak first = breakOf(scene, seed);
        forEachCrackFace(first, [&](const Vec3& x, const Vec3& normal, double area) {
            Vec3 away = x - first.contact;
            away -= away.dot(first.direction) * first.direction;
            away.normalize();
            const double along = std::abs(normal.dot(away));
            const double around = std::abs(normal.dot(first.direction.cross(away)));
            all += area;
            if (std::max(along, around) > least) aligned += area;
        });
    }
    std::cout << "aligned share of the crack area: " << aligned / all << "\n";
    EXPECT_GT(aligned / all, 0.8);
}

TEST(Patterns, ThePlatesSmallPiecesLieAtTheContact) {
    double sum = 0;
    const SeededScene scene(named("coffee_plate"));
    for (int seed = 1; seed <= seeds; ++seed) {
        const FirstBreak first = breakOf(scene, seed);
        std::vector<double> size, distance;
        for (const TriangleMesh& piece : first.pieces) {
            double volume = 0;
            Vec3 centre = Vec3::Zero();
            for (const auto& [a, b, c] : piece.triangles) {
                const Vec3 &p = piece.vertices[a], &q = piece.vertices[b], &r = piece.vertices[c];
                const double part = p.cross(q).dot(r) / 6;
                volume += part;
                centre += part * (p + q + r) / 4;
            }
            size.push_back(volume);
            distance.push_back((centre / volume - first.contact).norm());
        }
        std::cout << "seed " << seed << ": " << size.size() << " pieces, rank correlation "
                  << rankCorrelation(size, distance) << "\n";
        sum += rankCorrelation(size, distance);
    }
    EXPECT_GT(sum / seeds, 0.5);
}

/// The walls without a guide.
std::vector<FirstBreak> unguidedWalls() {
    std::vector<FirstBreak> breaks;
    for (const char* name : {"plaster_wall", "glass_wall"}) {
        Scene scene = named(name);
        scene.bodies[0].settings.fracture.guide = {};
        const SeededScene seeded(scene);
        for (int seed = 1; seed <= seeds; ++seed) breaks.push_back(breakOf(seeded, seed));
    }
    return breaks;
}

// In a plate that is struck in its middle the largest tension runs around the blow.
TEST(Patterns, CracksOfAStruckPlateAreRadialOrRingsWithoutAGuide) {
    double sum = 0;
    const auto breaks = unguidedWalls();
    for (const FirstBreak& first : breaks) {
        sherd_tests::AlignedShare share(first.contact, first.direction);
        for (const TriangleMesh& piece : first.pieces)
            for (const auto& face : sherd_tests::crackFaces(piece)) share.add(face);
        sum += share.value();
    }
    std::cout << "aligned share of the crack area: " << sum / static_cast<double>(breaks.size()) << "\n";
    EXPECT_GT(sum / static_cast<double>(breaks.size()), 0.8);
}

TEST(Patterns, SizesOfPiecesFollowAPowerLaw) {
    std::vector<double> sizes;
    for (const FirstBreak& first : unguidedWalls())
        for (const TriangleMesh& piece : first.pieces) sizes.push_back(sherd_tests::volumeOf(piece));
    const auto laws = sherd_tests::sizeLaws(sizes);
    std::cout << sizes.size() << " pieces, exponent " << laws.exponent << ", " << laws.decades
              << " decades, logarithm of the likelihood over that of one size, a piece: "
              << laws.power_law - laws.one_size << "\n";
    EXPECT_GT(static_cast<double>(sizes.size()) * (laws.power_law - laws.one_size), 5);
    EXPECT_GT(laws.decades, 2);
}

TEST(Patterns, NoPieceIsHookedIntoItsNeighbours) {
    for (const char* name :
         {"plaster_wall", "glass_wall", "wood_wall", "coffee_plate", "coffee_cup", "plane"}) {
        double worst = 0;
        const SeededScene scene(named(name));
        for (const std::uint64_t seed : {1, 2})
            for (const TriangleMesh& piece : breakOf(scene, seed).pieces)
                worst = std::max(worst, sherd_tests::hookedShare(sherd_tests::crackFaces(piece)));
        std::cout << name << ": in the way of the piece that has it worst: " << 100 * worst
                  << " % of its crack area\n";
        EXPECT_LE(worst, 0.05) << name;
    }
}

// What breaks, and into how much, is the blow's business and not the time step's. One break changes by up to
// three pieces of twenty with any rounding of its contact, whatever the step.
TEST(Patterns, TheTimeStepDoesNotDecide) {
    for (const char* name : {"plaster_wall", "glass_wall", "wood_wall"}) {
        std::vector<double> counts;
        for (const double step : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
            Scene scene = named(name);
            scene.time_step_s = step;
            counts.push_back(0);
            const SeededScene seeded(scene);
            for (int seed = 1; seed <= seeds; ++seed)
                counts.back() += static_cast<double>(breakOf(seeded, seed).pieces.size());
        }
        std::cout << name << ": " << counts[0] << ", " << counts[1] << ", " << counts[2] << " pieces of "
                  << seeds << " breaks\n";
        EXPECT_NEAR(counts[0] / counts[2], 1, 0.05) << name;
        EXPECT_NEAR(counts[1] / counts[2], 1, 0.05) << name;
    }
}

}  // namespace
