#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/numerics/pi.h"
#include "core/stress/principal_stresses.h"
#include "fracture/blow_stress.h"
#include "support/shapes.h"

namespace sherd {
namespace {

using Profile = std::vector<std::pair<double, double>>;

void addArc(Profile& profile, double r, double z, double radius, double from_degrees, double to_degrees) {
    constexpr int parts = 14;
    for (int i = 0; i <= parts; ++i) {
        const double angle = pi / 180 * (from_degrees + (to_degrees - from_degrees) * i / parts);
        profile.emplace_back(r + radius * std::cos(angle), z + radius * std::sin(angle));
    }
}

void addLine(Profile& profile, double r, double z, int parts) {
    const auto [r_0, z_0] = profile.back();
    for (int i = 1; i < parts; ++i)
        profile.emplace_back(r_0 + (r - r_0) * i / parts, z_0 + (z - z_0) * i / parts);
}

/// A mug without a handle: radius 40 mm, height 90 mm, wall 5 mm, all edges round.
TriangleMesh mug() {
    Profile profile{{0, 0}};
    addLine(profile, 0.033, 0, 14);
    addArc(profile, 0.033, 0.007, 0.007, -90, 0);
    addLine(profile, 0.04, 0.0876, 40);
    addArc(profile, 0.0376, 0.0876, 0.0024, 0, 90);
    addArc(profile, 0.0374, 0.0876, 0.0024, 90, 180);
    addLine(profile, 0.035, 0.011, 40);
    addArc(profile, 0.029, 0.011, 0.006, 0, -90);
    addLine(profile, 0, 0.005, 14);
    profile.emplace_back(0, 0.005);
    return shapes::revolvedSolid(profile, 180);
}

/// Of finite elements: quadratic tetrahedra as long as 0.12 radii of the contact at its rim (some 27000
/// nodes, smooth surface), the same traction at 1 N of pressure, balanced by rigid acceleration.
struct Contact {
    const char* name;
    Vec3 at, outward, slide;  ///< m, -, N
    double radius;            ///< m
    double true_pa;           ///< largest tension about the contact
    double off;               ///< of it, at most
    double grid;              ///< share of it that the grid alone has, at most
};

constexpr double quarter_wall = 0.00125;  // m

const Contact contacts[] = {
    {"outside", Vec3(0.04, 0, 0.045), Vec3::UnitX(), Vec3(0, 0, 0.4), quarter_wall, 1.877e5, 0.05, 0.5},
    {"inside", Vec3(0.035, 0, 0.045), -Vec3::UnitX(), Vec3(0, 0, 0.4), quarter_wall, 1.914e5, 0.07, 0.5},
    {"fillet of the floor", Vec3(0.03324, 0, 0.00676), Vec3(-1, 0, 1).normalized(), Vec3::Zero(),
     quarter_wall, 1.264e5, 0.15, 0.5},
    // These bend away from a plane by half a radius of theirs.
    {"over the fillet", Vec3(0.03324, 0, 0.00676), Vec3(-1, 0, 1).normalized(), Vec3::Zero(), 0.0042, 2.704e4,
     0.1, 0.65},
    {"over the lip", Vec3(0.0375, 0, 0.09), Vec3::UnitZ(), Vec3::Zero(), 0.0019, 2.206e4, 0.05, 0.5},
    {"along the lip", Vec3(0.0375, 0, 0.09), Vec3::UnitZ(), Vec3(0.5, 0, 0), 0.0019, 9.517e4, 0.2, 0.5},
};

class CurvedContact : public ::testing::Test {
  protected:
    static const BreakableSolid& solid() {
        static const auto made = valueOrThrow(
            BreakableSolid::make(mug(), Material::ceramic(), Settings::forQuality(Quality::game)));
        return *made;
    }
    template <class T>
    static T valueOrThrow(Result<T> result) {
        if (!result) throw std::runtime_error(result.error());
        return std::move(result).value();
    }
    static ContactPatch patchOf(const Contact& contact) {
        const ContactBody body = struckBody(solid(), {});
        const Vec3 push = -contact.outward;
        ContactPatch patch{nearestSurfacePoint(body.surface, contact.at, push),
                           push,
                           push + contact.slide,
                           contact.radius,
                           {}};
        patch.parts = partsOfPatch(body.surface, patch.spot, push, contact.radius, 0.18);
        return patch;
    }
    static double largestOf(const StressField& field) {
        double largest = 0;
        for (const SymmetricTensor& stress : field.points)
            largest = std::max(largest, largestPrincipal(stress));
        return largest;
    }
};

TEST_F(CurvedContact, HasANearFieldThatIsAsFiniteElementsHaveIt) {
    const StressSolver& solver = *valueOrThrow(solid().stressSolver());
    for (const Contact& contact : contacts) {
        const ContactPatch patch = patchOf(contact);
        const ContactField field = contactField(struckBody(solid(), {}), {patch}, solid().spacing());
        ASSERT_EQ(field.near.discs().size(), 1u) << contact.name;
        EXPECT_TRUE(field.others.empty()) << contact.name;
        const double with = largestOf(valueOrThrow(solver.solveContact(field)));
        EXPECT_NEAR(with, contact.true_pa, contact.off * contact.true_pa) << contact.name;
        std::vector<Vec3> places;
        for (const SurfacePlace& place : field.places) places.push_back(place.position);
        const double without = largestOf(valueOrThrow(solver.solve(unitLoads({patch}), places)));
        EXPECT_LT(without, contact.grid * contact.true_pa)
            << contact.name << ": the grid alone is too coarse";
    }
}

// On a ball five times as large the disc's rim lies a tenth of its radius below its middle: what presses
// straight down there pulls less at the rim than on a plane.
TEST_F(CurvedContact, OnABallIsAsFinerGridsHaveIt) {
    constexpr double ball_radius = 0.05, radius = 0.01;
    const auto solidAt = [&](const Settings& settings) {
        return valueOrThrow(
            BreakableSolid::make(shapes::icosphere(ball_radius, 5), Material::ceramic(), settings));
    };
    const auto ball = solidAt(Settings::forQuality(Quality::preview));
    Settings finer = Settings::forQuality(Quality::preview);
    finer.stress.resample_contacts = true;
    finer.stress.resampling_cells = 12;
    finer.stress.resampling_rounds = 4;
    const auto finer_ball = solidAt(finer);
    const ContactBody body = struckBody(*ball, {});
    ContactPatch patch{nearestSurfacePoint(body.surface, Vec3(0, 0, ball_radius), -Vec3::UnitZ()),
                       -Vec3::UnitZ(),
                       -Vec3::UnitZ(),
                       radius,
                       {}};
    patch.parts = partsOfPatch(body.surface, patch.spot, patch.push, radius, 0.18);
    const ContactField field = contactField(body, {patch}, ball->spacing());
    ASSERT_EQ(field.near.discs().size(), 1u);
    std::vector<Vec3> places;
    for (const SurfacePlace& place : field.places) places.push_back(place.position);
    const StressField own = valueOrThrow(valueOrThrow(ball->stressSolver())->solveContact(field)),
                      fine = valueOrThrow(
                          valueOrThrow(finer_ball->stressSolver())->solve(unitLoads({patch}), places));
    EXPECT_LT(fine.point_spacing_m.front(), 0.15 * radius);
    const double pressure_pa = field.near.discs()[0].traction_pa.norm();
    int at_rim = 0;
    double off = 0, off_on_plane = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double r = places[i].head<2>().norm();
        if (r < 0.9 * radius || r > 1.02 * radius || places[i].z() < 0) continue;
        const Vec3 along = Vec3::UnitZ().cross(places[i]).cross(places[i]).normalized();
        const auto alongIt = [&](const SymmetricTensor& stress) {
            return along.dot(toMatrix(stress) * along);
        };
        const double truth = alongIt(fine.points[i]);
        off += std::abs(alongIt(own.points[i]) - truth);
        const Vec3 on_plane(places[i].x(), places[i].y(), ball_radius);
        const SymmetricTensor plane =
            toSymmetricTensor(field.near.stressAt(on_plane) - field.near.stressAt(places[i]));
        off_on_plane += std::abs(alongIt(own.points[i] - field.places[i].unresolved + plane) - truth);
        ++at_rim;
    }
    ASSERT_GT(at_rim, 20);
    EXPECT_LT(off, 0.05 * at_rim * pressure_pa);
    EXPECT_GT(off_on_plane, 2 * off);
}

}  // namespace
}  // namespace sherd
