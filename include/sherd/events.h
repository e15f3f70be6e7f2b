#pragma once

#include <sherd/types.h>

#include <string>
#include <vector>

class btRigidBody;
class btTypedConstraint;

namespace sherd {

/// Milliseconds of each stage of one blow; 0 where a stage was not needed.
struct StageTimes {
    double sample = 0, assemble = 0, factor = 0, solve = 0, stress = 0, damage = 0, cluster = 0, surface = 0,
           bodies = 0, resolve_step = 0;
};

/// One solved blow: a body that broke, or one that was looked at and held. World frame, SI units.
struct BreakEvent {
    enum class Outcome {
        broke,   ///< `broken` was taken out of the world and `fragments` stand in its place
        held,    ///< the stress stayed below the strength
        failed,  ///< the blow could not be worked out; the body is whole and `message` says why
    };
    Outcome outcome = Outcome::held;
    btRigidBody* broken =
        nullptr;  ///< the struck body; after a break out of the world, and alive until the next step
    std::vector<btRigidBody*> fragments;  ///< empty unless it broke; alive until they break or are removed
    std::vector<btTypedConstraint*>
        removed_constraints;       ///< joints that held the broken body; the app owns them
    Vec3 position = Vec3::Zero();  ///< of the hardest contact, m
    Vec3 normal = Vec3::Zero();    ///< direction in which the body was pushed there
    double impulse_n_s = 0;        ///< sum of the normal impulses
    double peak_force_n = 0;       ///< of the contact pulse
    double contact_time_s = 0;
    double largest_stress_pa = 0;  ///< largest principal stress at any particle
    double mass_error_rel = 0;     ///< over all fragments, against the body
    double volume_error_rel = 0;
    double dropped_mass_kg = 0;     ///< of debris that left the world (FractureSettings::debris)
    double momentum_error_rel = 0;  ///< linear and angular, across the swap
    double residual_rel = 0;        ///< of the linear solve
    StageTimes ms;
    std::string message;  ///< failure, fallbacks and warnings, as sentences
};

/// Counts since the world was hooked.
struct BlowCounts {
    long long seen = 0;     ///< struck bodies, step by step
    long long skipped = 0;  ///< of these: too weak by the bound, no solve
    long long solved = 0;   ///< of these: stress solved
};

}  // namespace sherd
