#pragma once

#include <sherd/types.h>

#include <string>
#include <vector>

class btRigidBody;
class btTypedConstraint;

namespace sherd {

/// Milliseconds of each stage of one blow; 0 where a stage was not needed. `resolve_step` is the second solve
/// of the step, with the fragments.
struct StageTimes {
    double sample = 0, assemble = 0, factor = 0, solve = 0, stress = 0, damage = 0, cluster = 0, surface = 0,
           bodies = 0, resolve_step = 0;
};

/// One blow whose stress was solved: the body broke, or it held. World frame, SI units.
struct BreakEvent {
    enum class Outcome {
        broke,   ///< `broken` was taken out of the world and `fragments` stand in its place
        held,    ///< the stress stayed below the strength
        failed,  ///< the blow could not be worked out; the body is whole and `message` says why
    };
    Outcome outcome = Outcome::held;
    /// The struck body. If it broke, it is removed from the world, and valid until the step after the event
    /// was taken.
    btRigidBody* broken = nullptr;
    std::vector<btRigidBody*> fragments;  ///< empty unless it broke; valid until they break or are removed
    /// Joints that held the body before it broke, removed from the world; the app owns them.
    std::vector<btTypedConstraint*> removed_constraints;
    Vec3 position = Vec3::Zero();   ///< of the contact with the largest impulse, m
    Vec3 normal = Vec3::Zero();     ///< unit direction in which the body was pushed there
    double impulse_n_s = 0;         ///< sum of the normal impulses of all contacts
    double peak_force_n = 0;        ///< of the contact, as a pulse of half a sine
    double contact_time_s = 0;      ///< duration of that pulse
    double largest_stress_pa = 0;   ///< largest principal stress at any particle
    double mass_error_rel = 0;      ///< of all fragments together, relative to the body
    double volume_error_rel = 0;    ///< the same of the volume
    double dropped_mass_kg = 0;     ///< of debris that left the world (FractureSettings::debris)
    double momentum_error_rel = 0;  ///< linear and angular, of all fragments against the body
    double residual_rel = 0;        ///< of the linear solve
    StageTimes ms;
    std::string message;  ///< failure, fallbacks and warnings, as sentences
};

/// Counts since the FractureWorld was made.
struct BlowCounts {
    long long seen = 0;     ///< blows: a breakable body in contact in one step
    long long skipped = 0;  ///< of these: the energy cannot break the body, so nothing was solved
    long long solved = 0;   ///< of these: the stress was solved
};

}  // namespace sherd
