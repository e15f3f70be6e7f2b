#include "core/mlpg/particle_forms/shape_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/mlpg/particle_forms/weight_function.h"
#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {
namespace {

Discretisation sampledSolid(const TriangleMesh& mesh, double spacing) {
    Result<Discretisation> solid = sampleSolid(mesh, spacing, SamplingSettings{});
    EXPECT_TRUE(solid.ok()) << solid.error();
    return std::move(solid).value();
}

Discretisation jitteredBlock() {
    Discretisation solid = sampledSolid(shapes::slab({0.8, 0.6, 0.5}), 0.1);
    std::mt19937 random(3);
    for (Particle& particle : solid.particles)
        for (int j = 0; j < 3; ++j) particle.position[j] += 0.02 * (random() / 4294967296.0 * 2 - 1);
    return solid;
}

struct Space {
    TrialSpace space;
    double support_radius;
};
const Space all_spaces[] = {{{TrialFunction::mls, Basis::linear}, 2.2},
                            {{TrialFunction::mls, Basis::quadratic}, 2.8},
                            {{TrialFunction::gmls, Basis::linear}, 1.4},
                            {{TrialFunction::gmls, Basis::quadratic}, 2.0}};

/// The field that the shape functions make of the data of f (value and gradient), and its gradient.
template <class Value, class Gradient>
std::pair<double, Vec3> interpolate(const Discretisation& solid, const TrialSpace& space,
                                    const ShapeFunctions& shapes, const Value& f, const Gradient& df) {
    double value = 0;
    Vec3 gradient = Vec3::Zero();
    const int functions = space.functionsPerParticle();
    for (size_t n = 0; n < shapes.values.size(); ++n) {
        const Particle& particle = solid.particles[shapes.particles[n / functions]];
        const int k = static_cast<int>(n) % functions;
        const double datum = k == 0 ? f(particle.position) : particle.spacing * df(particle.position)[k - 1];
        value += shapes.values[n] * datum;
        gradient += shapes.gradients[n] * datum;
    }
    return {value, gradient};
}

TEST(ShapeFunctions, WeightIsThePapersQuarticSpline) {
    for (double q : {0.0, 0.3, 0.7, 0.999}) {
        EXPECT_NEAR(splineWeight(q), 1 - 6 * q * q + 8 * q * q * q - 3 * q * q * q * q, 1e-15);
        const double step = 1e-6;
        const double slope = q > 0 ? (splineWeight(q + step) - splineWeight(q - step)) / (2 * step) : 0;
        EXPECT_NEAR(splineWeightSlope(q) * q, slope, 1e-6);
    }
    EXPECT_EQ(splineWeight(1.1), 0);
}

// Linear fields, values and gradients, at points inside and at the corner, on irregular particles.
TEST(ShapeFunctions, ReproduceLinearFields) {
    const Discretisation solid = jitteredBlock();
    const Vec3 slope(1, -2, 3);
    for (const Space& form : all_spaces) {
        const SupportGraph supports(solid, form.support_radius);
        ShapeEvaluator evaluator(solid, supports, form.space);
        ShapeFunctions shapes;
        for (const SurfacePoint& point : solid.surface_points) {
            const Vec3 x = point.position;
            evaluator.evaluate(x, solid.cells[point.cell].particle, true, shapes);
            const auto [value, gradient] = interpolate(
                solid, form.space, shapes, [&](const Vec3& y) { return 4 + slope.dot(y); },
                [&](const Vec3&) { return slope; });
            ASSERT_NEAR(value, 4 + slope.dot(x), 1e-11);
            ASSERT_LT((gradient - slope).norm(), 1e-9);
        }
    }
}

TEST(ShapeFunctions, QuadraticBasisReproducesQuadraticFields) {
    const Discretisation solid = jitteredBlock();
    const auto f = [](const Vec3& x) { return x.x() * x.x() - 2 * x.y() * x.z() + x.z(); };
    const auto df = [](const Vec3& x) { return Vec3(2 * x.x(), -2 * x.z(), -2 * x.y() + 1); };
    for (const Space& form : {all_spaces[1], all_spaces[3]}) {
        const SupportGraph supports(solid, form.support_radius);
        ShapeEvaluator evaluator(solid, supports, form.space);
        ShapeFunctions shapes;
        const Vec3 x(0.03, -0.11, 0.07);
        int owner = 0;
        for (size_t i = 0; i < solid.particles.size(); ++i)
            if ((solid.particles[i].position - x).norm() < (solid.particles[owner].position - x).norm())
                owner = static_cast<int>(i);
        ASSERT_EQ(evaluator.evaluate(x, owner, true, shapes), Evaluation::regular);
        const auto [value, gradient] = interpolate(solid, form.space, shapes, f, df);
        EXPECT_NEAR(value, f(x), 1e-12);
        EXPECT_LT((gradient - df(x)).norm(), 1e-10);
    }
}

// Complete derivatives, weights and moment matrix included: against finite differences.
TEST(ShapeFunctions, GradientsAreThoseOfTheValues) {
    const Discretisation solid = jitteredBlock();
    const int owner = static_cast<int>(solid.particles.size()) / 2;
    const Vec3 x = solid.particles[owner].position + Vec3(0.021, -0.013, 0.017);
    for (const Space& form : all_spaces) {
        const SupportGraph supports(solid, form.support_radius);
        ShapeEvaluator evaluator(solid, supports, form.space);
        ShapeFunctions here, above, below;
        evaluator.evaluate(x, owner, true, here);
        const double step = 1e-6;
        for (int j = 0; j < 3; ++j) {
            evaluator.evaluate(x + step * Vec3::Unit(j), owner, false, above);
            evaluator.evaluate(x - step * Vec3::Unit(j), owner, false, below);
            ASSERT_EQ(above.particles, here.particles);
            ASSERT_EQ(below.particles, here.particles);
            for (size_t n = 0; n < here.values.size(); ++n)
                ASSERT_NEAR(here.gradients[n][j], (above.values[n] - below.values[n]) / (2 * step), 2e-6);
        }
    }
}

// Coplanar particles: enough for gmls; mls says that it is lost but still reproduces constants.
TEST(ShapeFunctions, CoplanarParticles) {
    const Discretisation sheet = sampledSolid(shapes::slab({0.8, 0.6, 0.1}), 0.1);
    ASSERT_EQ(sheet.particles.size(), 48u);
    const Vec3 x = sheet.particles[20].position + Vec3(0.01, 0.02, 0.04);
    const Vec3 slope(1, -2, 3);
    for (const Space& form : {all_spaces[0], all_spaces[2]}) {
        const SupportGraph supports(sheet, form.support_radius);
        ShapeEvaluator evaluator(sheet, supports, form.space);
        ShapeFunctions shapes;
        const bool mls = form.space.trial_function == TrialFunction::mls;
        EXPECT_EQ(evaluator.evaluate(x, 20, true, shapes), mls ? Evaluation::deficient : Evaluation::regular);
        const double tilt = mls ? 0 : slope.z();
        const auto linear = [&](const Vec3& y) {
            return 4 + slope.x() * y.x() + slope.y() * y.y() + tilt * y.z();
        };
        const auto [value, gradient] = interpolate(
            sheet, form.space, shapes, linear, [&](const Vec3&) { return Vec3(slope.x(), slope.y(), tilt); });
        EXPECT_NEAR(value, linear(x), 1e-12);
    }
}

// The legs of a U are nearer to each other than a support radius, and must not see each other.
TEST(ShapeFunctions, GapsAreNotBridged) {
    const Discretisation solid = sampledSolid(shapes::uShape(0.2, 0.05, 1.0, 0.2), 0.1);
    const SupportGraph supports(solid, 3);
    int pairs_near = 0, pairs_coupled = 0;
    for (size_t a = 0; a < solid.particles.size(); ++a)
        for (size_t b = 0; b < solid.particles.size(); ++b) {
            const Vec3 p = solid.particles[a].position, q = solid.particles[b].position;
            const bool left = p.x() < 0.2 && p.z() > 0.7, right = q.x() > 0.25 && q.z() > 0.7;
            if (!left || !right || (p - q).norm() > 0.3) continue;
            ++pairs_near;
            const std::vector<int>& list = supports.candidates(static_cast<int>(a));
            pairs_coupled += std::binary_search(list.begin(), list.end(), static_cast<int>(b));
        }
    EXPECT_GT(pairs_near, 0);
    EXPECT_EQ(pairs_coupled, 0);
}

}  // namespace
}  // namespace sherd
