#pragma once

#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include "core/loads/blow.h"
#include "support/shapes.h"

namespace sherd::fracture_tests {

/// A plate of 0.4 x 0.4 x 0.03 m.
inline BreakableAsset plateAsset(const Material& material = Material::plaster(),
                                 const Settings& settings = {}) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.2, -0.2, -0.015), Vec3(0.2, 0.2, 0.015)),
                                                material, settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value();
}

/// A ball hits the plate in the middle of its upper face.
inline Blow blowInTheMiddle(double mass_kg, double speed_m_s) {
    ContactImpulse contact;
    contact.point = Vec3(0.003, 0.002, 0.015);
    contact.normal = -Vec3::UnitZ();
    contact.impulse = -Vec3::UnitZ() * mass_kg * speed_m_s;
    contact.approach_m_s = speed_m_s;
    contact.partner_radius_m = 0.03;
    return {{contact}, {Mobility::ofPoint(mass_kg)}};
}

}  // namespace sherd::fracture_tests
