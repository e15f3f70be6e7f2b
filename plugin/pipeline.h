#pragma once

#include <memory>
#include <string>
#include <vector>

#include <sherd/events.h>
#include <sherd/triangle_mesh.h>

#include "body.h"

namespace sherd {

/// One solved contact point, in the frame of the struck asset.
struct ContactImpulse {
    Vec3 point = Vec3::Zero();    ///< m
    Vec3 normal = Vec3::Zero();   ///< unit, the direction in which the body is pushed
    Vec3 impulse = Vec3::Zero();  ///< normal and friction impulse on the body, N s
    double approach_m_s = 0;      ///< closing speed along the normal before the solve and without this step's gravity
    double effective_mass_kg = 0;  ///< 1 / (n . (K_a + K_b) n) of the two bodies at the point
    double partner_radius_m = 0;  ///< radius of curvature of the striking shape; 0: not known or flat
    double partner_youngs_modulus_pa = 0;  ///< 0: the settings' value
    double partner_poisson_ratio = 0;
};

/// All contacts of one body in one step.
struct Blow {
    std::vector<ContactImpulse> contacts;
};

/// A piece of a broken body, ready to become a rigid body. Frame of the parent's asset.
struct Fragment {
    std::shared_ptr<const Body> body;
    std::vector<std::pair<Vec3, Vec3>> boxes;  ///< centres and half extents for the collision shape; empty: use the hull
};

struct BlowOutcome {
    BreakEvent::Outcome outcome = BreakEvent::Outcome::held;
    std::vector<Fragment> fragments;
    double impulse_n_s = 0, peak_force_n = 0, contact_time_s = 0, largest_stress_pa = 0;
    double mass_error_rel = 0, volume_error_rel = 0, residual_rel = 0;
    int damaged_particles = 0;
    StageTimes ms;
    std::string message;
};

/// A bound that costs nothing: false when the blow carries less energy than it takes to bring one particle's share of the
/// material to its strength, so that no solve can find damage.
bool canBreak(const Body& body, const Blow& blow);

/// The whole way from a blow to fragments (paper, Figure 1). Never throws; on any failure the body stays whole and the
/// outcome says why.
BlowOutcome strike(const Body& body, const Blow& blow, std::uint64_t seed);

/// Boxes that stand for the whole body in collisions: filled voxels, merged.
Result<std::vector<std::pair<Vec3, Vec3>>> collisionBoxes(const Body& body);

}  // namespace sherd
