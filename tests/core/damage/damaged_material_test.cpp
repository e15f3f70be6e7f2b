#include "core/damage/damaged_material.h"

#include <gtest/gtest.h>

#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

Discretisation sampled(double spacing) {
    return sampleSolid(shapes::moved(shapes::slab(Vec3(0.4, 0.1, 0.3)), shapes::tilt()), spacing, {}).value();
}

std::vector<char> where(const Discretisation& solid, double above) {
    std::vector<char> damaged;
    for (const Particle& particle : solid.particles) damaged.push_back(particle.position.x() > above);
    return damaged;
}

TEST(DamagedMaterial, IsThatOfTheParticlesItWasMadeOf) {
    const Discretisation solid = sampled(0.03);
    const std::vector<char> damaged = where(solid, 0.05);
    const auto material = DamagedMaterial::with(nullptr, solid, damaged);
    EXPECT_EQ(material->particles(solid), damaged);
    const std::vector<char> none(damaged.size());
    EXPECT_EQ(DamagedMaterial::with(nullptr, solid, none)->particles(solid), none);
    EXPECT_EQ(DamagedMaterial::with(material, solid, none)->particles(solid), damaged);
}

TEST(DamagedMaterial, IsFoundByAnotherGrid) {
    const Discretisation coarse = sampled(0.03), fine = sampled(0.017);
    const auto material = DamagedMaterial::with(nullptr, coarse, where(coarse, 0.05));
    const std::vector<char> found = material->particles(fine);
    int undecided = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double x = fine.particles[i].position.x();
        if (std::abs(x - 0.05) < 0.03)
            ++undecided;
        else
            EXPECT_EQ(found[i], x > 0.05) << i;
    }
    EXPECT_LT(undecided, static_cast<int>(found.size()) / 2);
}

TEST(DamagedMaterial, IsUnited) {
    const Discretisation coarse = sampled(0.03), fine = sampled(0.017);
    const auto right = DamagedMaterial::with(nullptr, coarse, where(coarse, 0.08));
    std::vector<char> left = where(coarse, -0.1);
    for (char& damaged : left) damaged = !damaged;
    EXPECT_EQ(DamagedMaterial::united(nullptr, nullptr), nullptr);
    EXPECT_EQ(DamagedMaterial::united(right, nullptr), right);
    EXPECT_EQ(DamagedMaterial::united(nullptr, right), right);
    const auto both = DamagedMaterial::united(right, DamagedMaterial::with(nullptr, coarse, left));
    std::vector<char> expected = where(coarse, 0.08);
    for (std::size_t i = 0; i < left.size(); ++i) expected[i] = expected[i] || left[i];
    EXPECT_EQ(both->particles(coarse), expected);
    const std::vector<char> other = where(fine, 0.02);
    const std::vector<char> found = DamagedMaterial::with(both, fine, other)->particles(fine);
    for (std::size_t i = 0; i < other.size(); ++i) EXPECT_GE(found[i], other[i]);
}

}  // namespace
