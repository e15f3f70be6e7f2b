#pragma once

#include <LinearMath/btTransform.h>
#include <sherd/breakable_asset.h>
#include <sherd/outcome.h>
#include <sherd/types.h>

#include <string>
#include <vector>

class btCollisionObject;
class btMultiBodyConstraint;
class btRigidBody;
class btTypedConstraint;

namespace sherd {

/// One blow that was solved, on a coarse grid or in full: the body broke, or it held. Blows that the gate
/// decided have an event only where it has something to say: the first blow on a body that has warnings, what
/// was torn out of its supports, and all blows with FractureSettings::check_with_full_solve. World frame, SI
/// units.
struct BlowEvent : BlowFigures {
    explicit BlowEvent(const BreakableAsset& of_body) : asset(of_body) {}

    // The struck body. Asset, name and motion are values, good for as long as the event is kept, also when
    // the body is long gone: for a sound, for dust, for a decal at `asset_transform.inverse() * position`.

    /// Its surface and material. An event that is kept keeps them in memory.
    BreakableAsset asset;
    std::string name;  ///< BreakableOptions::name
    /// Maps the coordinates of `asset` to the world, where the body was when the blow was decided: in the
    /// step in which it fell, or `waited_s` after that. So `position`, `normal` and the motion.
    btTransform asset_transform = btTransform::getIdentity();
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass just before that, m/s
    Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
    /// If it broke, it is removed from the world. A body of Sherd's is then valid until the first step after
    /// the event was taken; a body of the app's for as long as the app keeps it.
    btRigidBody* body = nullptr;
    /// How many breaks made it: 0 for a body that was added, 1 for its fragments, and so on. The event that
    /// has a fragment among its `fragments` is that of the body that it was part of.
    int generation = 0;

    Vec3 position = Vec3::Zero();  ///< of the hard strikes the first, m
    Vec3 normal = Vec3::Zero();    ///< unit direction in which the body was pushed there
    /// What struck there; nullptr for blows of the app's own (applyBlow, explode), and for a striker that
    /// left the world while the blow waited. The app may have removed it since the step: then compare it
    /// only.
    const btCollisionObject* striker = nullptr;
    bool foreseen = false;  ///< it fell as foreseen (Budget::foresight_s): threads were asked before, if any
    /// The part of `ms` that other threads did. The step paid for the rest, and for waiting
    /// (StepTimes::waiting).
    StageTimes ms_elsewhere;

    /// Empty unless it broke, and without those that a FragmentCallback removed. The FractureWorld owns them.
    /// Each is valid until it is removed or the FractureWorld is destroyed; if it breaks in its turn, it
    /// lives on as the `body` of that event.
    std::vector<btRigidBody*> fragments;
    /// Joints that held the body before it broke, removed from the world. The app owns them; if the body was
    /// Sherd's they are disabled. They may be removed once more and deleted at any time.
    std::vector<btTypedConstraint*> removed_constraints;
    std::vector<btMultiBodyConstraint*> removed_multi_body_constraints;  ///< the same with multi-bodies
    double dropped_mass_kg = 0;  ///< of debris that left the world (FractureSettings::debris)
    /// Linear and angular, of all fragments against the body; 0 if the world held it or holds some of them. A
    /// body of the app's may have an inertia larger than its solid has, as Bullet gives it to hulls and
    /// compounds: its fragments go on as it turned then, with less angular momentum, and this says how much.
    double momentum_error_rel = 0;
};

}  // namespace sherd
