#pragma once

#include <sherd/events.h>
#include <sherd/triangle_mesh.h>

#include <memory>
#include <string>
#include <vector>

#include "core/loads/blow.h"
#include "core/sampling/voxel_boxes.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// A piece of a broken body, ready to become a rigid body. Frame of the parent's asset.
struct Fragment {
    std::shared_ptr<const BreakableSolid> body;
    std::vector<Box> boxes;  ///< for the collision shape; empty: the hull of the surface stands in
    bool dropped = false;    ///< takes its share of the momentum, and leaves the world
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

/// A bound that costs nothing: false when the blow brings less energy than it takes to bring one particle's
/// share of the material to its strength, or to pay for the smallest crack, so that no solve can end in a
/// break.
bool canBreak(const BreakableSolid& body, const Blow& blow);

/// The whole way from a blow to fragments (paper, Figure 1). Never throws; on any failure the body stays
/// whole and the outcome says why.
BlowOutcome strike(const BreakableSolid& body, const Blow& blow, std::uint64_t seed);

/// Boxes that stand for the whole body in collisions: filled voxels, merged.
Result<std::vector<Box>> collisionBoxes(const BreakableSolid& body);

}  // namespace sherd
