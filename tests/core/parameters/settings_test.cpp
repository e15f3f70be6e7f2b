#include <gtest/gtest.h>
#include <sherd/settings.h>

#include <limits>

namespace {

using namespace sherd;

TEST(Settings, DefaultsAreValid) {
    EXPECT_EQ(Settings().validate().error(), "");
}

void expectSentence(void (*spoil)(Settings&), const std::string& sentence) {
    Settings settings;
    spoil(settings);
    EXPECT_EQ(settings.validate().error(), sentence);
}

TEST(Settings, EveryPartIsLookedAt) {
    expectSentence([](Settings& s) { s.sampling.spacing_m = -1; },
                   "SamplingSettings: spacing_m is -1 but must be 0 (chosen from the wall thickness) or "
                   "positive, in m.");
    expectSentence(
        [](Settings& s) { s.stress.support_radius = 0.5; },
        "StressSettings: support_radius is 0.5 but must be 0 (the form's own default) or between 1.2 and 4 "
        "particle spacings.");
    expectSentence([](Settings& s) { s.fracture.contact.partner_youngs_modulus_pa = 0; },
                   "FractureSettings: contact.partner_youngs_modulus_pa is 0 but must be positive, in Pa.");
    expectSentence([](Settings& s) { s.fracture.largest_fragment_count = 1; },
                   "FractureSettings: largest_fragment_count is 1 but must be at least 2.");
}

TEST(Settings, WhatIsOutOfRangeIsNamed) {
    const auto named = [](void (*spoil)(Settings&), const std::string& member) {
        Settings settings;
        spoil(settings);
        EXPECT_NE(settings.validate().error().find(": " + member + " is "), std::string::npos) << member;
    };
    named([](Settings& s) { s.sampling.layers_across_wall = 0; }, "layers_across_wall");
    named([](Settings& s) { s.sampling.smallest_count = 0; }, "smallest_count");
    named([](Settings& s) { s.sampling.largest_count = s.sampling.smallest_count - 1; }, "largest_count");
    named([](Settings& s) { s.sampling.cells_per_spacing = 5; }, "cells_per_spacing");
    named([](Settings& s) { s.sampling.cells_per_spacing = 0; }, "cells_per_spacing");
    named([](Settings& s) { s.sampling.smallest_fill = 1; }, "smallest_fill");
    named([](Settings& s) { s.fracture.contact.partner_poisson_ratio = 0.6; },
          "contact.partner_poisson_ratio");
    named([](Settings& s) { s.fracture.contact.shortest_contact_s = 0; }, "contact.shortest_contact_s");
    named([](Settings& s) { s.fracture.contact.smallest_patch = 0; }, "contact.smallest_patch");
    named([](Settings& s) { s.fracture.contact.largest_patch = 1.5; }, "contact.largest_patch");
    named([](Settings& s) { s.fracture.fragment_count = -1; }, "fragment_count");
    named([](Settings& s) { s.fracture.fragment_count = 41; }, "fragment_count");
    named([](Settings& s) { s.fracture.smallest_fragment_m3 = -1; }, "smallest_fragment_m3");
    named([](Settings& s) { s.strength.field_minimum = -1; }, "field_minimum");
    named([](Settings& s) { s.fracture.crack_roughness = 0.6; }, "crack_roughness");
    named([](Settings& s) { s.fracture.rest_after_break_s = std::numeric_limits<double>::quiet_NaN(); },
          "rest_after_break_s");
    named([](Settings& s) { s.fracture.debris = static_cast<Debris>(99); }, "debris");
    named([](Settings& s) { s.fracture.collision_shape = static_cast<CollisionShape>(-1); },
          "collision_shape");
    named([](Settings& s) { s.fracture.same_blow_s = -1; }, "same_blow_s");
    named([](Settings& s) { s.sampling.spacing_m = std::numeric_limits<double>::infinity(); }, "spacing_m");
}

}  // namespace
