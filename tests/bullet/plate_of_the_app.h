#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "bullet/strikes/contact_collector.h"
#include "bullet/support.h"
#include "core/loads/contact_loads.h"
#include "fracture/blow_stress.h"

namespace sherd::bullet_tests {

/// A plate of 0.6 x 0.6 x 0.06 m that is an app's own box, and what strikes it in a step.
struct PlateOfTheApp {
    explicit PlateOfTheApp(TestWorld& its_scene, const btVector3& place) : scene(its_scene) {
        auto breakable =
            std::make_unique<Breakable>(asset, fractureSettingsFor(asset, asset.settings().fracture));
        box = scene.addBox(btScalar(asset.mass()), btVector3(0.3f, 0.3f, 0.03f), place);
        breakable->body = box;
        registry.add(std::move(breakable));
    }

    /// Steps once. No strike if nothing touches the plate then.
    Strike strikeOfStep(double dt) {
        StepSnapshot before;
        before.take(*scene.world);
        scene.step(1, dt);
        ContactCollector collector(registry, before, 0, scene.world->getSolverInfo());
        feedSolvedContacts(*scene.world, collector);
        const std::vector<StruckBreakable> struck = collector.takeStruck();
        EXPECT_EQ(struck.size(), 1u);
        if (struck.size() != 1) return {};
        const Blow& blow = struck[0].blow;
        Strike strike = strikeOf(struckBody(*asset.solid(), blow), blow, asset.settings().fracture.contact);
        for (StrikePoint& point : strike.points) point.contact = nullptr;  // they go with the blow
        return strike;
    }

    TestWorld& scene;
    BreakableRegistry registry;
    const BreakableAsset asset = plate(crumbly());
    btRigidBody* box = nullptr;
};

}  // namespace sherd::bullet_tests
