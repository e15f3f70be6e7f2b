// Blows on prepared solids: the reduced model decides as the full solve does.
#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <algorithm>

#include "fracture/blow_damage.h"
#include "fracture/crack_energy.h"
#include "fracture/default_fracture.h"
#include "fracture/random_blows.h"
#include "geometry/surface_checks.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

std::shared_ptr<const BreakableSolid> solidOf(const Shape& shape) {
    const auto made = BreakableSolid::make(shape.mesh, shape.material, {});
    EXPECT_TRUE(made.ok()) << made.error();
    return made.value();
}

const Shape& shapeNamed(const std::string& name) {
    static const std::vector<Shape> shapes = tenShapes();
    return *std::find_if(shapes.begin(), shapes.end(),
                         [&](const Shape& shape) { return shape.name == name; });
}

struct Compared {
    int blows = 0, reduced = 0, same = 0;
    std::vector<double> stress_errors, overlaps;
};

Compared compare(const BreakableSolid& solid, const TriangleMesh& mesh, int count) {
    const Discretisation& sampling = *solid.discretisation().value();
    const BodyStrength& strength = solid.strength();
    FractureSettings fully = solid.settings().fracture;
    fully.use_reduced_model = false;
    const StrikeContext fast{solid, sampling, solid.settings().fracture, 1}, full{solid, sampling, fully, 1};
    const double crack_j = smallestCrackEnergy(solid, fully);
    RandomBlows blows(mesh, 11);
    Compared compared;
    for (int i = 0; i < count; ++i) {
        const Blow blow = blows.next();
        StageTimes ms;
        const BlowDamage a = blowDamage(fast, blow, strength, ms), b = blowDamage(full, blow, strength, ms);
        EXPECT_EQ(b.level, Level::full);
        const auto breaks = [&](const BlowDamage& found) {
            return found.damage.count > 0 && found.forces.strain_energy_j > crack_j;
        };
        ++compared.blows;
        compared.reduced += a.level == Level::reduced;
        compared.same += breaks(a) == breaks(b);
        compared.stress_errors.push_back(
            std::abs(a.damage.largest_stress_pa / b.damage.largest_stress_pa - 1));
        int both = 0, any = 0;
        for (std::size_t p = 0; p < sampling.particles.size(); ++p) {
            both += a.damage.damaged[p] && b.damage.damaged[p];
            any += a.damage.damaged[p] || b.damage.damaged[p];
        }
        if (any > 0) compared.overlaps.push_back(static_cast<double>(both) / any);
    }
    std::sort(compared.stress_errors.begin(), compared.stress_errors.end());
    std::sort(compared.overlaps.begin(), compared.overlaps.end());
    return compared;
}

TEST(ReducedBlows, DecideAsTheFullSolveDoes) {
    for (const char* name : {"wall", "bowl"}) {
        const Shape& shape = shapeNamed(name);
        const auto solid = solidOf(shape);
        ASSERT_TRUE(solid->prepare({}).ok());
        ASSERT_TRUE(solid->reducedStress());
        const Compared compared = compare(*solid, shape.mesh, 40);
        std::printf(
            "%s: reduced %d, same %d of %d, error of the stress %.4f, 90 %% below %.4f, overlap %.2f\n", name,
            compared.reduced, compared.same, compared.blows, compared.stress_errors[20],
            compared.stress_errors[36],
            compared.overlaps.empty() ? 1 : compared.overlaps[compared.overlaps.size() / 2]);
        EXPECT_GE(compared.reduced, 39) << name;
        EXPECT_GE(compared.same, 39) << name;
        EXPECT_LT(compared.stress_errors[20], 0.02) << name;
        ASSERT_GT(compared.overlaps.size(), 5u) << name;
        EXPECT_GT(compared.overlaps[compared.overlaps.size() / 2], 0.8) << name;
    }
}

TEST(ReducedBlows, NeedNoFactor) {
    const Shape& shape = shapeNamed("bowl");
    const auto solid = solidOf(shape);
    double told = 0;
    ASSERT_TRUE(solid->prepare([&](double done) {
        EXPECT_GE(done, told);
        told = done;
    }));
    EXPECT_EQ(told, 1);
    const Discretisation& sampling = *solid->discretisation().value();
    StageTimes ms;
    const BlowDamage found = blowDamage({*solid, sampling, solid->settings().fracture, 1},
                                        RandomBlows(shape.mesh, 3).next(), solid->strength(), ms);
    EXPECT_EQ(found.level, Level::reduced);
    EXPECT_FALSE(solid->isFactored());
    EXPECT_TRUE(solid->prepared());
    EXPECT_EQ(ms.factor, 0);
}

TEST(ReducedBlows, SmallSolidsAreAnsweredByTheirComplianceMatrix) {
    const Shape& shape = shapeNamed("wall");
    Settings settings = Settings::forQuality(Quality::preview);
    settings.sampling.spacing_m = 1.1 * wallThickness(shape.mesh);
    const auto solid = BreakableSolid::make(shape.mesh, shape.material, settings).value();
    ASSERT_TRUE(solid->prepare({}).ok());
    EXPECT_FALSE(solid->isFactored());
    ASSERT_TRUE(solid->reducedStress());
    EXPECT_TRUE(solid->reducedStress()->model.isDirect()) << solid->unknownCount() << " unknowns";
    const Compared compared = compare(*solid, shape.mesh, 40);
    EXPECT_EQ(compared.reduced, compared.blows);
    EXPECT_EQ(compared.same, compared.blows);
    EXPECT_LT(compared.stress_errors.back(), 2e-4);
}

TEST(ReducedBlows, SolidsWithoutOneAreSolvedFully) {
    Settings settings;
    settings.stress.resample_contacts = true;
    const auto made = BreakableSolid::make(shapeNamed("block").mesh, Material::brick(), settings);
    ASSERT_TRUE(made.ok());
    ASSERT_TRUE(made.value()->prepare({}).ok());
    EXPECT_FALSE(made.value()->reducedStress());
    EXPECT_TRUE(made.value()->isFactored());
    EXPECT_TRUE(made.value()->prepared());
}

// A small asset: such a thread waits for a core that nobody else wants, and a busy machine may have none for
// long.
TEST(ReducedBlows, AThreadOfItsOwnPreparesAnAsset) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(0.1, 0.1, 0.1)),
                                                Material::glass(), Settings::forQuality(Quality::preview));
    ASSERT_TRUE(asset.ok());
    std::future<Status> done = asset.value().prepareOnThread();
    EXPECT_TRUE(done.get().ok());
    EXPECT_TRUE(asset.value().prepared());
    EXPECT_TRUE(asset.value().solid()->reducedStress());
}

}  // namespace
