// Whether a blow falls as it was foreseen.

#include "bullet/schedule/foreseen_blow.h"

#include "bullet/support.h"
#include "fracture/breakable_solid.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A plate on a floor that a ball strikes from the side.
struct Foreseen {
    Foreseen() {
        giveToken(*floor);
        giveToken(*ball);
        struck.breakable = &body;
        struck.partners = {floor, ball};
        ContactImpulse strike;
        strike.partner = 1;
        strike.point = Vec3(0, -0.3, 0);
        strike.normal = Vec3(0, 1, 0);
        strike.impulse = Vec3(0, 5, 0);
        strike.approach_m_s = 8;
        fallen = expected = BlowToDecide{body.asset.solid(), {}, body.fracture, 0, nullptr, {}};
        for (Blow* blow : {&fallen.blow, &expected.blow}) {
            blow->partners.resize(2);
            blow->partners[1] = Mobility::of(body.asset.solid()->moments(), 1000);
            blow->contacts = {strike};
        }
    }
    ContactImpulse support(double impulse_n_s) const {
        ContactImpulse support;
        support.point = Vec3(0, 0, -0.03);
        support.normal = Vec3(0, 0, 1);
        support.impulse = impulse_n_s * support.normal;
        return support;
    }
    bool isAs() {
        ForeseenBlow foreseen;
        foreseen.partners = {tokenOf(*floor), tokenOf(*ball)};
        foreseen.blow = expected;
        foreseen.is_solved_in_full = true;
        return isAsForeseen(foreseen, struck, fallen);
    }

    TestWorld scene;
    btRigidBody *floor = scene.addFloor(), *ball = scene.addBall(1, 0.1, btVector3(0, -1, 0));
    Breakable body{plate(crumbly()), std::make_shared<const FractureSettings>()};
    StruckBreakable struck;
    BlowToDecide expected, fallen;
};

TEST(ForeseenBlow, IsTheSameStrikeAsFarAsMatters) {
    Foreseen blow;
    EXPECT_TRUE(blow.isAs());
    ContactImpulse& strike = blow.fallen.blow.contacts[0];
    strike.approach_m_s = 8.05;
    strike.point.z() += 0.005;
    EXPECT_TRUE(blow.isAs());
    strike.approach_m_s = 8.2;
    EXPECT_FALSE(blow.isAs()) << "faster";
    strike.approach_m_s = 8;
    strike.point.z() += 0.005;
    EXPECT_FALSE(blow.isAs()) << "elsewhere";
}

TEST(ForeseenBlow, RestsOnTheSameBodies) {
    Foreseen blow;
    blow.fallen.blow.contacts.push_back(blow.support(0.1));
    EXPECT_FALSE(blow.isAs()) << "the floor was not to take anything of it";
    blow.expected.blow.contacts.push_back(blow.support(2));
    EXPECT_TRUE(blow.isAs());
    blow.fallen.blow.contacts.pop_back();
    EXPECT_FALSE(blow.isAs()) << "and does not";
}

TEST(ForeseenBlow, MayOrMayNotHardlyPressOnOthers) {
    Foreseen blow;
    blow.fallen.blow.contacts.push_back(blow.support(1e-3));
    EXPECT_TRUE(blow.isAs()) << "the strike lifts it off the floor, all but the rounding";
    std::swap(blow.fallen, blow.expected);
    EXPECT_TRUE(blow.isAs());
    blow.expected.blow.contacts.back() = blow.support(0.01);
    EXPECT_FALSE(blow.isAs());
}

}  // namespace
