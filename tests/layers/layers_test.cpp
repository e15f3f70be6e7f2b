#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>
#include <sherd/stress_model.h>

#include "fracture/pipeline.h"
#include "support/shapes.h"

// This program has no Bullet and no forms on particles linked, see CMakeLists.txt beside it.
namespace {

using namespace sherd;

const TriangleMesh plate = shapes::box(Vec3(-0.2, -0.2, -0.015), Vec3(0.2, 0.2, 0.015));

TEST(LayersWithoutBullet, BreakAPlate) {
    const auto asset = BreakableAsset::fromMesh(plate, Material::plaster());
    ASSERT_TRUE(asset.ok()) << asset.error();
    ContactImpulse contact;
    contact.point = Vec3(0.003, 0.002, 0.015);
    contact.normal = -Vec3::UnitZ();
    contact.impulse = -10 * Vec3::UnitZ();
    contact.approach_m_s = 10;
    contact.partner_radius_m = 0.03;
    const BreakableSolid& solid = *asset.value().solid();
    const BlowOutcome out = strike(solid, {{contact}, {Mobility::ofPoint(1)}}, solid.settings().fracture, 1);
    EXPECT_EQ(out.outcome, Outcome::broke) << out.message;
}

TEST(WithoutParticleForms, SplinesSolveAndTheOthersSayWhatIsMissing) {
    Settings settings = Settings::forQuality(Quality::preview);
    const auto splines = StressModel::make(plate, Material::plaster(), settings);
    ASSERT_TRUE(splines.ok()) << splines.error();
    for (const TrialFunction form : {TrialFunction::mls, TrialFunction::gmls}) {
        settings.stress.trial_function = form;
        settings.stress.basis = Basis::linear;
        const auto refused = StressModel::make(plate, Material::plaster(), settings);
        ASSERT_FALSE(refused.ok());
        const std::string name = form == TrialFunction::mls ? "'mls'" : "'gmls'";
        for (const std::string& word : {name, std::string("without"), std::string("SHERD_PARTICLE_FORMS=ON")})
            EXPECT_NE(refused.error().find(word), std::string::npos) << refused.error();
    }
}

}  // namespace
