#pragma once

#include <sherd/events.h>

#include <functional>

class btRigidBody;

namespace sherd {

/// A fragment that is about to enter the world, for the app to change what it inherited.
///
/// A fragment inherits from the body that broke
/// - friction, rolling and spinning friction, anisotropic friction (the factors of its axes, turned to those
///   of the fragment), restitution, contact stiffness and damping, contact processing
///   threshold, collision flags, damping, sleeping thresholds (the angular one is larger
///   for small fragments: a quarter of the linear one at their surface), linear and angular factor (unless
///   the linear one is zero: what the app held in its place comes free), flags, gravity, threshold and (as
///   far as it fits) radius of continuous collision;
/// - collision group and mask, objects that it does not collide with, user pointer, the three user indices,
///   custom debug colour, the name and the FractureSettings;
/// - the strength of each of its places, and what earlier blows damaged there (Outcome::held);
/// - its share of the momentum and of the forces that wait for the solver. Where the world holds it on a
///   support (BreakableOptions::supports) it is static; then, and where it comes off a static body, Bullet
///   chooses its group and mask anew unless the app had chosen them.
/// It may sleep, also where DISABLE_DEACTIVATION kept the body awake, as while a mouse drags it.
/// Its own are mass, inertia, place, collision shape (FractureSettings::collision_shape) and motion state: a
/// btDefaultMotionState that begins where the whole body was drawn.
struct FragmentBirth {
    btRigidBody& body;            ///< not in the world yet
    const BreakableAsset& asset;  ///< its surface, in the coordinates of the body that broke
    const btRigidBody& parent;    ///< the body that broke; still in the world
    const BlowEvent& event;       ///< the blow; `fragments` holds those that came before this one
    std::string& name;
    int& collision_group;
    int& collision_mask;
};

/// Called for every fragment, before Bullet sees it; dropped debris is left out. May set everything of
/// `body` that Bullet lets an app set: user pointer and indices, motion state, friction, velocity, ... Its
/// place, mass, shape and extension pointer are Sherd's: a place or pointer that is changed is put back, and
/// a motion state is told the place; a mass that is changed stays, and momentum is not conserved then. A
/// motion state of the app's outlives the fragment: delete it when the fragment was removed, or after the
/// event of its break was taken. May call the FractureWorld as from inside a step, also about `body`. Must
/// leave the world as it is. If it throws, the fragment enters the world with what had been set by then, and
/// the event says so.
using FragmentCallback = std::function<void(FragmentBirth&)>;

}  // namespace sherd
