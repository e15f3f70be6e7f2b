#include <algorithm>

#include "core/sampling/sampling_support.h"

namespace sherd {
namespace {

TEST(SamplingParticles, WallOfThePaperHas968) {
    const Discretisation wall = sampled(shapes::slab({1, 0.09, 1}, 20, 2, 20), 0.045);
    EXPECT_EQ(wall.particles.size(), 968u);
    EXPECT_EQ(wall.cells.size(), 968u * 8);
    EXPECT_EQ(wall.voxels.size(), 968u * 8);
    for (const Particle& p : wall.particles) EXPECT_NEAR(p.volume, 0.09 / 968, 1e-15);
    // On a 22 x 2 x 22 lattice, each pair of adjacent cells shares 4 faces of voxels, each cell has 12
    // inside.
    EXPECT_EQ(wall.faces.size(), 4u * (21 * 2 * 22 + 22 * 1 * 22 + 22 * 2 * 21) + 12u * 968);
    std::size_t links = 0;
    for (const auto& list : wall.neighbours) links += list.size();
    EXPECT_EQ(links, 2u * (21 * 2 * 22 + 22 * 1 * 22 + 22 * 2 * 21));
    EXPECT_EQ(connectedBodies(wall), 1);
}

TEST(SamplingParticles, GridIsStretchedOnlyALittle) {
    const Discretisation slab = sampled(shapes::slab({1, 1, 0.05}), 0.1);  // thinner than a cell
    EXPECT_NEAR(slab.cell_size.x(), 0.05, 1e-15);
    EXPECT_NEAR(slab.cell_size.z(), 0.05, 1e-15);  // not stretched down to the sheet
    EXPECT_EQ(slab.particles.size(), 100u);
    for (const Particle& p : slab.particles) EXPECT_NEAR(p.position.z(), 0, 1e-15);
}

TEST(SamplingParticles, OrderIsThatOfTheCells) {
    const Discretisation box = sampled(shapes::slab({0.3, 0.3, 0.3}), 0.1);
    ASSERT_EQ(box.particles.size(), 27u);
    for (int i = 0; i < 27; ++i)
        EXPECT_LT((box.particles[i].position - 0.1 * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)).norm(),
                  1e-14);
}

TEST(SamplingParticles, LegsOfAUAreNoNeighboursAcrossTheGap) {
    // The gap is narrower than a particle cell, wider than a voxel.
    for (const double angle : {0.0, 0.4})
        for (const double spacing : {0.1, 0.13, 0.17}) {
            SCOPED_TRACE(spacing);
            const TriangleMesh mesh = shapes::uShape(0.3, 0.09, 1, 0.5);
            const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
            const Discretisation solid = sampled(shapes::moved(mesh, turn), spacing, 4);
            expectSound(solid);
            EXPECT_EQ(connectedBodies(solid), 1);
            for (std::size_t p = 0; p < solid.particles.size(); ++p)
                for (const int q : solid.neighbours[p]) {
                    const Vec3 a = turn.transpose() * solid.particles[p].position;
                    const Vec3 b = turn.transpose() * solid.particles[q].position;
                    const bool high = std::min(a.z(), b.z()) > 0.3 + spacing;
                    EXPECT_FALSE(high && (a.x() < 0.345) != (b.x() < 0.345))
                        << a.transpose() << " and " << b.transpose();
                }
        }
}

TEST(SamplingParticles, PartsOfOneParticleCellBecomeParticlesOfTheirOwn) {
    // Two plates, 0.4 of a particle cell apart: the cells between hold a part of each.
    using namespace shapes;
    const TriangleMesh plates =
        joined(box({0, 0, 0}, {1, 1, 0.13}, 4, 4, 1), box({0, 0, 0.17}, {1, 1, 0.3}, 4, 4, 1));
    const Discretisation solid = sampled(plates, 0.1, 4);
    EXPECT_EQ(connectedBodies(solid), 2);
    expectMoments(solid, plates);
    EXPECT_EQ(solid.particles.size(), 400u);
    for (const Particle& p : solid.particles) EXPECT_FALSE(p.position.z() > 0.13 && p.position.z() < 0.17);
}

TEST(SamplingParticles, SliversGetNoParticle) {
    // 1.1 cells of 0.1 along z do not fit by stretching 0.11 / 2, so a second layer would be a tenth full.
    const TriangleMesh mesh = shapes::rectilinear({0, 0.1, 0.4}, {0, 0.4}, {0, 0.11, 0.4},
                                                  [](int i, int, int k) { return i == 0 || k == 0; });
    const Discretisation solid = sampled(mesh, 0.1);
    expectMoments(solid, mesh);
    expectSound(solid);
    EXPECT_EQ(solid.particles.size(), 4u * (4 + 3));
}

TEST(SamplingParticles, TinyCutsAreMergedAndNothingIsLost) {
    // The top layer of voxels is filled by ever less, down to nothing but rounding.
    for (const double excess : {1e-1, 1e-2, 1e-4, 1e-8, 1e-12, 1e-15, 0.0}) {
        SCOPED_TRACE(excess);
        const TriangleMesh mesh = shapes::rectilinear({0, 0.5, 1}, {0, 1}, {0, 0.5 + 0.05 * excess, 1},
                                                      [](int i, int, int k) { return i == 0 || k == 0; });
        const Discretisation solid = sampled(mesh, 0.1);
        expectMoments(solid, mesh);
        expectSound(solid);
        for (const IntegrationCell& cell : solid.cells)
            EXPECT_GT(cell.moments.volume, 0.9 * solid.cell_size.prod());
        EXPECT_EQ(solid.particles.size(), 750u);
    }
}

TEST(SamplingParticles, ThinSheetKeepsItsParticles) {
    // A tenth of a cell thick, and across a plane of the grid: one layer, not merged along itself.
    const TriangleMesh mesh = shapes::rectilinear({0, 0.1, 1}, {0, 1}, {0, 0.497, 0.507, 1},
                                                  [](int i, int, int k) { return i == 0 || k == 1; });
    const Discretisation solid = sampled(mesh, 0.1);
    expectMoments(solid, mesh);
    expectSound(solid);
    EXPECT_EQ(solid.particles.size(), 100u + 90u);
}

TEST(SamplingParticles, SeparateBodiesStaySeparate) {
    const TriangleMesh two = shapes::joined(shapes::icosphere(0.3, 2),
                                            shapes::translated(shapes::icosphere(0.3, 2), {0.75, 0.1, 0}));
    EXPECT_EQ(connectedBodies(sampled(two, 0.1)), 2);
}

TEST(SamplingParticles, SameInputGivesTheSameBits) {
    const TriangleMesh mesh = shapes::moved(shapes::cup(0.04, 0.09, 0.005, 40, 10), shapes::tilt());
    const Discretisation a = sampled(mesh, 0.004), b = sampled(mesh, 0.004);
    ASSERT_EQ(a.particles.size(), b.particles.size());
    ASSERT_EQ(a.surface_points.size(), b.surface_points.size());
    for (std::size_t p = 0; p < a.particles.size(); ++p)
        EXPECT_EQ(a.particles[p].position, b.particles[p].position);
    for (std::size_t q = 0; q < a.surface_points.size(); ++q)
        EXPECT_EQ(a.surface_points[q].area, b.surface_points[q].area);
    EXPECT_EQ(a.neighbours, b.neighbours);
}

}  // namespace
}  // namespace sherd
