#include "fracture/baked_asset.h"

#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <filesystem>
#include <random>

#include "core/loads/load_patch.h"
#include "core/mlpg/splines/particle_mass.h"
#include "fracture/default_fracture.h"
#include "fracture/random_blows.h"
#include "support/altered_fields.h"
#include "support/shapes.h"
#include "support/temporary_path.h"

namespace {

using namespace sherd;

BreakableAsset smallCup(Settings settings = Settings::forQuality(Quality::preview)) {
    settings.sampling.largest_factor_millions = settings.sampling.largest_factor_if_thin_millions = 0.6;
    Material weak = Material::ceramic();  // so that many of the blows break it
    weak.tensile_strength_pa /= 20;
    weak.fracture_energy_j_m2 /= 20;
    const auto asset = BreakableAsset::fromMesh(shapes::cup(0.04, 0.1, 0.008, 16, 4), weak, settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value();
}

BreakableAsset savedAndLoaded(const BreakableAsset& asset) {
    const std::string path = temporaryPath("asset.sherd");
    const Status saved = asset.save(path);
    EXPECT_TRUE(saved.ok()) << saved.error();
    const auto loaded = BreakableAsset::load(path);
    EXPECT_TRUE(loaded.ok()) << loaded.error();
    return loaded.value();
}

std::vector<std::byte> contentOf(const std::string& path) {
    const auto read = readChecked(baked_format, path);
    EXPECT_TRUE(read.ok()) << read.error();
    return {read.value().bytes.get(), read.value().bytes.get() + read.value().size};
}

/// One that keeps its whole sampling, since that was there before it was prepared.
BreakableAsset sampledCup() {
    const BreakableAsset cup = smallCup();
    EXPECT_TRUE(cup.solid()->discretisation().ok());
    return cup;
}

/// A cup, and the same one from a file.
struct BakedAssetTest : testing::Test {
    const BreakableAsset asset = sampledCup(), loaded = savedAndLoaded(asset);
};

void expectSameMesh(const TriangleMesh& a, const TriangleMesh& b) {
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.kinds, b.kinds);
    EXPECT_EQ(a.file_faces, b.file_faces);
    EXPECT_EQ(a.texture_coordinates, b.texture_coordinates);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.materials, b.materials);
    EXPECT_EQ(a.colours, b.colours);
}

void expectSameOutcome(const BlowOutcome& a, const BlowOutcome& b) {
    EXPECT_EQ(a.outcome, b.outcome);
    EXPECT_EQ(a.peak_force_n, b.peak_force_n);
    EXPECT_EQ(a.contact_time_s, b.contact_time_s);
    EXPECT_EQ(a.largest_stress_pa, b.largest_stress_pa);
    EXPECT_EQ(a.damaged_particles, b.damaged_particles);
    EXPECT_EQ(a.message, b.message);
    EXPECT_EQ(a.warnings, b.warnings);
    ASSERT_EQ(a.fragments.size(), b.fragments.size());
    for (std::size_t f = 0; f < a.fragments.size(); ++f) {
        const Fragment &of_a = a.fragments[f], &of_b = b.fragments[f];
        expectSameMesh(of_a.solid->surface(), of_b.solid->surface());
        EXPECT_EQ(of_a.dropped, of_b.dropped);
        EXPECT_EQ(of_a.solid->wallThickness(), of_b.solid->wallThickness());
        EXPECT_EQ(of_a.solid->spacing(), of_b.solid->spacing());
        EXPECT_EQ(of_a.solid->supports().size(), of_b.solid->supports().size());
        ASSERT_EQ(of_a.boxes.size(), of_b.boxes.size());
        for (std::size_t i = 0; i < of_a.boxes.size(); ++i) {
            EXPECT_EQ(of_a.boxes[i].centre, of_b.boxes[i].centre);
            EXPECT_EQ(of_a.boxes[i].half_extents, of_b.boxes[i].half_extents);
        }
    }
}

/// The same blows on both; returns how many broke them.
int expectSameBlows(const BreakableAsset& a, const BreakableAsset& b, int count) {
    fracture_tests::RandomBlows blows(a.surface(), 11);
    FractureSettings fracture = a.settings().fracture;
    fracture.collision_shape = CollisionShape::boxes;  // which are compared, too
    int broke = 0;
    for (int i = 0; i < count; ++i) {
        const Blow blow = blows.next();
        // Merged debris and few pieces: labels are merged by the areas that particles share.
        fracture.debris = i % 2 ? Debris::merged : Debris::dropped;
        fracture.largest_fragment_count = i % 3 ? 36 : 5;
        EXPECT_EQ(canBreak(*a.solid(), blow, fracture), canBreak(*b.solid(), blow, fracture));
        const BlowOutcome of_a = strike(*a.solid(), blow, fracture, 3);
        expectSameOutcome(of_a, strike(*b.solid(), blow, fracture, 3));
        broke += of_a.outcome == Outcome::broke;
    }
    return broke;
}

/// A force on some triangle, spread over its corners and middle.
std::vector<PointForce> someLoads(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& corners = mesh.triangles[triangle];
    Vec3 middle = Vec3::Zero();
    for (const int v : corners) middle += mesh.vertices[v] / 3;
    std::vector<PointForce> loads = {{middle, Vec3(0.4, 0.1, -0.2)}};
    for (const int v : corners) loads.push_back({0.9 * middle + 0.1 * mesh.vertices[v], Vec3(0, 0.1, -0.3)});
    return loads;
}

TEST_F(BakedAssetTest, BlowsBreakItAsTheOneThatWasSaved) {
    EXPECT_TRUE(loaded.prepared());
    EXPECT_EQ(loaded.particleCount(), asset.particleCount());
    EXPECT_EQ(loaded.mass(), asset.mass());
    EXPECT_GE(expectSameBlows(asset, loaded, 12), 3);
}

TEST_F(BakedAssetTest, TheReducedModelAnswersWithTheSameBits) {
    const ReducedStress *a = asset.solid()->reducedStress(), *b = loaded.solid()->reducedStress();
    ASSERT_TRUE(a && b);
    const std::vector<double>& strengths = asset.solid()->strength().atPoints(a->reading);
    EXPECT_EQ(strengths, loaded.solid()->strength().atPoints(b->reading));
    const Strength strength{asset.solid()->failureCriterion(), asset.material(), strengths};
    int answered = 0, damaged = 0;
    for (std::size_t t = 0; t < asset.surface().triangles.size(); t += 17) {
        const auto loads = someLoads(asset.surface(), t);
        const auto of_a = a->model.respond(loads), of_b = b->model.respond(loads);
        ASSERT_EQ(of_a.ok(), of_b.ok());
        if (!of_a) continue;
        ++answered;
        EXPECT_EQ(of_a.value().unknowns, of_b.value().unknowns);
        EXPECT_EQ(of_a.value().strain_energy_j, of_b.value().strain_energy_j);
        // The mass that Ritz vectors of short contacts have.
        const Eigen::VectorXd u = of_a.value().unknowns.cast<double>();
        EXPECT_EQ(ParticleMass(a->model.problem()).times(u), ParticleMass(b->model.problem()).times(u));
        for (const double scale : {30.0, 3000.0}) {
            const Damage damage_a =
                a->reading.damage(of_a.value().unknowns, {{}, {}, loads}, scale, strength);
            const Damage damage_b =
                b->reading.damage(of_b.value().unknowns, {{}, {}, loads}, scale, strength);
            EXPECT_EQ(damage_a.damaged, damage_b.damaged);
            EXPECT_EQ(damage_a.overstress, damage_b.overstress);
            EXPECT_EQ(damage_a.largest_stress_pa, damage_b.largest_stress_pa);
            damaged += damage_a.count;
        }
    }
    EXPECT_GT(answered, 5);
    EXPECT_GT(damaged, 0);
}

TEST_F(BakedAssetTest, TheGateSaysTheSame) {
    const PeakTable &a = asset.solid()->reducedStress()->peaks, &b = loaded.solid()->reducedStress()->peaks;
    ASSERT_GE(a.levels.size(), 2u);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (const Vec3& vertex : asset.surface().vertices) {
        const PeakTable::Push push{vertex.cast<float>(), Eigen::Vector3f::UnitX(), 1e-3f};
        const Eigen::Vector3f force(1, 0.3f, -0.2f);
        const PeakTable::At at_a(a, push), at_b(b, push);
        EXPECT_EQ(at_a.stress(force), at_b.stress(force));
        EXPECT_EQ(at_a.compliance(), at_b.compliance());
        EXPECT_EQ(at_a.work(force), at_b.work(force));
    }
}

TEST(BakedAssets, AnchoredOnesAreHeldAsBefore) {
    const auto held = smallCup().anchored({BoxRegion{{-1, -1, 0}, {1, 1, 0}}});
    ASSERT_TRUE(held.ok()) << held.error();
    const BreakableAsset loaded = savedAndLoaded(held.value());
    ASSERT_EQ(loaded.supports().size(), 1u);
    expectSameBlows(held.value(), loaded, 4);
}

TEST_F(BakedAssetTest, StressIsReadAtTheSamePoints) {
    const ReadingPoints &a = asset.solid()->reducedStress()->reading.points(),
                        &b = loaded.solid()->reducedStress()->reading.points();
    EXPECT_EQ(a.starts, b.starts);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        EXPECT_EQ(a.points[i].xi, b.points[i].xi);
        EXPECT_EQ(a.points[i].normal, b.points[i].normal);
        EXPECT_EQ(a.points[i].particle, b.points[i].particle);
    }
}

TEST_F(BakedAssetTest, AFullSolveSamplesAnewWhatTheFileLeavesOut) {
    const auto kept = loaded.solid()->discretisation();
    EXPECT_EQ(kept.value()->parts.order, 0);
    const auto refused = makeSplineProblem(kept.value(), loaded.material(), Basis::quadratic, {}, {});
    EXPECT_NE(refused.error().find("moments of order 0"), std::string::npos) << refused.error();

    FractureSettings fracture = asset.settings().fracture;
    fracture.use_reduced_model = false;
    fracture.damage_waves = 2;
    fracture_tests::RandomBlows blows(asset.surface(), 11);
    int broke = 0;
    for (int i = 0; i < 6; ++i) {
        const Blow blow = blows.next();
        const BlowOutcome of_loaded = strike(*loaded.solid(), blow, fracture, 3);
        expectSameOutcome(strike(*asset.solid(), blow, fracture, 3), of_loaded);
        broke += of_loaded.outcome == Outcome::broke;
    }
    EXPECT_GE(broke, 2);
}

/// The same, with other limits and warnings than any solid has.
std::shared_ptr<const ReducedStress> altered(const std::shared_ptr<const ReducedStress>& reduced) {
    const ReducedModel& model = reduced->model;
    const std::shared_ptr<const SplineProblem> problem(reduced, &model.problem());
    return std::make_shared<const ReducedStress>(ReducedStress{
        ReducedModel(problem, model.stiffness(), model.modes(), model.vibrations(), {21, 22, 23}),
        reduced->reading,
        reduced->peaks,
        {"third warning"}});
}

/// Every field is another than its default, and the mesh has all attributes.
BakedAsset altered(BakedSolid solid) {
    alterFields(solid.material);
    alterFields(solid.settings.fracture);
    alterFields(solid.settings.strength);
    solid.supports = {SphereRegion{{1, 2, 3}, 4}, BoxRegion{{5, 6, 7}, {8, 9, 10}},
                      CylinderRegion{{11, 12, 13}, {14, 15, 16}, 17}};
    TriangleMesh& mesh = solid.surface;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double x = static_cast<double>(t);
        mesh.kinds.push_back(t % 2 ? SurfaceKind::crack : SurfaceKind::original);
        mesh.texture_coordinates.push_back({Vec2(x, 0.1), Vec2(0.2, x), Vec2(0, 1)});
        mesh.normals.push_back({Vec3(x, 0.1, 0), Vec3(0.2, x, 0), Vec3(0, 1, x)});
        mesh.material.push_back(t % 3 == 0);
    }
    mesh.file_faces.resize(mesh.triangles.size(), 90000);
    mesh.materials = {"glaze", "crack"};
    mesh.colours.assign(mesh.vertices.size(), Vec3(0.1, 0.2, 0.3));
    solid.bounding_radius = 18;
    solid.wall_thickness = 19;
    solid.spacing = 20;
    solid.model.reduced = altered(solid.model.reduced);
    RepairReport repairs{1, 2, 3, 4, 5, 6, 0.7, 8, 9, 10, true, true, true, 0.13, 0.14, 0.15};
    return {std::move(solid), repairs, {"first warning", "second"}};
}

TEST(BakedAssets, EveryFieldComesBack) {
    const BakedAsset written = altered(smallCup().solid()->baked().value());
    BakedAsset copy = written;
    const std::string path = temporaryPath("asset.sherd");
    ASSERT_TRUE(saveBaked(copy, path).ok());
    const auto loaded = loadBaked(path);
    ASSERT_TRUE(loaded.ok()) << loaded.error();
    const BakedAsset& read = loaded.value();
    expectSameMesh(read.solid.surface, written.solid.surface);
    EXPECT_EQ(valuesOf(read.solid.material), valuesOf(written.solid.material));
    EXPECT_EQ(valuesOf(read.solid.settings), valuesOf(written.solid.settings));
    EXPECT_EQ(read.warnings, written.warnings);
    EXPECT_EQ(read.repairs.sentences(), written.repairs.sentences());
    EXPECT_EQ(read.repairs.largest_loss_m, 0.15);
    EXPECT_EQ(read.repairs.size_m, 0.13);
    EXPECT_EQ(read.solid.bounding_radius, 18);
    EXPECT_EQ(read.solid.wall_thickness, 19);
    EXPECT_EQ(read.solid.spacing, 20);
    EXPECT_EQ(read.solid.moments.volume, written.solid.moments.volume);
    EXPECT_EQ(read.solid.moments.centroid, written.solid.moments.centroid);
    EXPECT_EQ(read.solid.moments.second, written.solid.moments.second);
    ASSERT_EQ(read.solid.supports.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(describe(read.solid.supports[i]), describe(written.solid.supports[i]));
    EXPECT_EQ(read.solid.model.reduced->warnings, std::vector<std::string>{"third warning"});
    const ReducedModelLimits& limits = read.solid.model.reduced->model.limits();
    EXPECT_EQ(limits.patches, 21);
    EXPECT_EQ(limits.modes, 22);
    EXPECT_EQ(limits.local_functions, 23);
}

TEST_F(BakedAssetTest, TheSamplingIsTheSameButForWhatOnlyStressProblemsRead) {
    const Discretisation &a = *asset.solid()->discretisation().value(),
                         &b = *loaded.solid()->discretisation().value();
    EXPECT_EQ(a.spacing, b.spacing);
    EXPECT_EQ(a.cell_size, b.cell_size);
    EXPECT_EQ(a.grid_origin, b.grid_origin);
    EXPECT_EQ(a.neighbours, b.neighbours);
    EXPECT_EQ(a.particle_cells, b.particle_cells);
    ASSERT_EQ(a.particles.size(), b.particles.size());
    for (std::size_t i = 0; i < a.particles.size(); ++i) {
        EXPECT_EQ(a.particles[i].position, b.particles[i].position);
        EXPECT_EQ(a.particles[i].volume, b.particles[i].volume);
        EXPECT_EQ(a.particles[i].spacing, b.particles[i].spacing);
    }
    ASSERT_EQ(a.cells.size(), b.cells.size());
    for (std::size_t c = 0; c < a.cells.size(); ++c) {
        EXPECT_EQ(a.cells[c].particle, b.cells[c].particle);
        EXPECT_EQ(a.cells[c].moments.volume, b.cells[c].moments.volume);
        EXPECT_EQ(a.cells[c].moments.centroid, b.cells[c].moments.centroid);
        EXPECT_EQ(a.cells[c].moments.second.diagonal(), b.cells[c].moments.second.diagonal());
    }
    EXPECT_TRUE(b.surface_points.empty());
    EXPECT_EQ(a.facing, b.facing);
    ASSERT_EQ(a.voxels.size(), b.voxels.size());
    for (std::size_t v = 0; v < a.voxels.size(); ++v) {
        EXPECT_EQ(a.voxels[v].index, b.voxels[v].index);
        EXPECT_EQ(a.voxels[v].cell, b.voxels[v].cell);
        EXPECT_EQ(a.voxels[v].fill, b.voxels[v].fill);
    }
    std::size_t face = 0;  // of `b`: between different particles only
    for (const IntegrationFace& of_a : a.faces) {
        if (a.cells[of_a.cells[0]].particle == a.cells[of_a.cells[1]].particle) continue;
        ASSERT_LT(face, b.faces.size());
        EXPECT_EQ(of_a.cells[0], b.faces[face].cells[0]);
        EXPECT_EQ(of_a.cells[1], b.faces[face].cells[1]);
        EXPECT_EQ(of_a.area, b.faces[face++].area);
    }
    EXPECT_EQ(face, b.faces.size());
    EXPECT_EQ(a.parts.origin, b.parts.origin);
    EXPECT_EQ(a.parts.edges, b.parts.edges);
    EXPECT_EQ(a.parts.count, b.parts.count);
    EXPECT_EQ(a.parts.voxels_per_cell, b.parts.voxels_per_cell);
    EXPECT_EQ(a.parts.first_part, b.parts.first_part);
    EXPECT_EQ(a.parts.neighbours, b.parts.neighbours);
    for (std::size_t p = 0; p < a.parts.parts.size(); ++p) {
        EXPECT_EQ(a.parts.parts[p].cell, b.parts.parts[p].cell);
        EXPECT_EQ(a.parts.parts[p].fill, b.parts.parts[p].fill);
        EXPECT_EQ(a.parts.parts[p].voxels, b.parts.parts[p].voxels);
    }
}

TEST_F(BakedAssetTest, WhatIsPreparedFirstKeepsNoMoreThanAFile) {
    const BreakableAsset prepared = smallCup();
    ASSERT_TRUE(prepared.prepare().ok());
    EXPECT_FALSE(asset.solid()->discretisation().value()->surface_points.empty());
    EXPECT_TRUE(prepared.solid()->discretisation().value()->surface_points.empty());
    const auto &points = prepared.solid()->reducedStress()->reading.points().points,
               &all = asset.solid()->reducedStress()->reading.points().points;
    EXPECT_EQ(points.size(), all.size());
    EXPECT_EQ(points.capacity(), points.size()) << "no room is left over";
    FractureSettings fracture = asset.settings().fracture;
    fracture_tests::RandomBlows blows(asset.surface(), 12);
    for (const bool reduced : {true, true, false}) {
        fracture.use_reduced_model = reduced;
        const Blow blow = blows.next();
        expectSameOutcome(strike(*asset.solid(), blow, fracture, 3),
                          strike(*prepared.solid(), blow, fracture, 3));
    }
}

TEST(BakedAssets, WhatAFileCannotHoldIsRefused) {
    const std::string path = temporaryPath("asset.sherd");
    const auto expectRefused = [&](const Settings& settings, const std::string& words) {
        const std::string sentence = smallCup(settings).save(path).error();
        EXPECT_NE(sentence.find("The asset cannot be baked: "), std::string::npos) << sentence;
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
        EXPECT_FALSE(std::filesystem::exists(path));
    };
    Settings settings;
    settings.strength.field = [](const Vec3&) { return 1.0; };
    expectRefused(settings, "strength.field is a function");
    settings = {};
    settings.fracture.guide.kind = GuideField::Kind::custom;
    settings.fracture.guide.custom = [](const Vec3&, const Vec3&) { return Vec3(1, 0, 0); };
    expectRefused(settings, "BodyOptions::fracture");
    settings = {};
    settings.stress.resample_contacts = true;
    expectRefused(settings, "resample_contacts");
    settings = {};
    settings.stress.trial_function = TrialFunction::mls;
    expectRefused(settings, "trial_function");
    EXPECT_NE(smallCup().save(temporaryPath("no_folder") + "/asset.sherd").error().find("Cannot write"),
              std::string::npos);
}

TEST(BakedAssets, SavingPrepares) {
    const BreakableAsset asset = smallCup();
    EXPECT_FALSE(asset.prepared());
    ASSERT_TRUE(asset.save(temporaryPath("prepared.sherd")).ok());
    EXPECT_TRUE(asset.prepared());
}

TEST_F(BakedAssetTest, TellsWhetherItIsWhatTheProgramWouldBake) {
    const auto made = [&](TriangleMesh surface, const Material& material, const Settings& settings) {
        return BreakableAsset::fromMesh(surface, material, settings).value();
    };
    const BreakableAsset same = made(loaded.surface(), loaded.material(), loaded.settings());
    EXPECT_TRUE(loaded.isSameAs(same));
    EXPECT_TRUE(same.isSameAs(loaded));
    Material stronger = loaded.material();
    stronger.tensile_strength_pa *= 2;
    EXPECT_FALSE(loaded.isSameAs(made(loaded.surface(), stronger, loaded.settings())));
    Settings other = loaded.settings();
    other.fracture.largest_generation = 1;
    EXPECT_FALSE(loaded.isSameAs(made(loaded.surface(), loaded.material(), other)));
    TriangleMesh moved = loaded.surface();
    for (Vec3& x : moved.vertices) x.x() += 0.01;
    EXPECT_FALSE(loaded.isSameAs(made(moved, loaded.material(), loaded.settings())));
    const auto held = same.anchored({BoxRegion{{-1, -1, 0}, {1, 1, 0}}});
    ASSERT_TRUE(held.ok()) << held.error();
    EXPECT_FALSE(loaded.isSameAs(held.value()));
}

TEST(BakedAssets, BrokenFilesGetASentence) {
    const std::string path = temporaryPath("asset.sherd");
    std::filesystem::remove(path);  // of an earlier run
    EXPECT_NE(BreakableAsset::load(path).error().find("is missing"), std::string::npos);
    ASSERT_TRUE(smallCup().save(path).ok());
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
    const std::string sentence = BreakableAsset::load(path).error();
    EXPECT_NE(sentence.find("is cut short"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("bake the asset again"), std::string::npos) << sentence;
}

TEST(BakedAssets, ContentThatNoAssetHasIsRefusedOrHarmless) {
    const std::string path = temporaryPath("asset.sherd");
    ASSERT_TRUE(smallCup().save(path).ok());
    const std::vector<std::byte> content = contentOf(path);
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 60; ++i) {
        std::vector<std::byte> changed = content;
        for (int k = 0; k < 4; ++k) changed[random() % changed.size()] = static_cast<std::byte>(random());
        if (i % 3 == 0) changed.resize(random() % changed.size());
        ASSERT_TRUE(writeChecked(baked_format, changed, path).ok());
        const auto loaded = BreakableAsset::load(path);
        refused += !loaded;
        if (i % 3 == 0) {
            EXPECT_NE(loaded.error().find("holds what no asset has"), std::string::npos);
        }
    }
    EXPECT_GE(refused, 20);
}

TEST(BakedAssets, SavingWhatWasLoadedGivesTheSameFile) {
    const std::string first = temporaryPath("first.sherd"), second = temporaryPath("second.sherd");
    ASSERT_TRUE(smallCup().save(first).ok());
    ASSERT_TRUE(BreakableAsset::load(first).value().save(second).ok());
    EXPECT_EQ(contentOf(first), contentOf(second));
}

}  // namespace
