#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

namespace sherd {

/// Which of the blows that wait are decided first. The others wait longer, and are the first to be dropped.
enum class Priority {
    hardest,  ///< the largest normal impulse
    nearest,  ///< the shortest way to `Budget::viewpoint`
    largest,  ///< the largest body
};

/// What breaking may cost a step; not what a step may take: what must not wait takes its time, and a whole
/// body that is not prepared takes most. In its step is decided every blow on a whole body, and every blow on
/// a fragment that something lighter than it strikes, or that falls on one that is held: what breaks there
/// lets the striker through. Other blows on fragments wait. So do, beyond `milliseconds_per_step`, blows on
/// whole bodies that fragments strike; and where more than `solves_per_step` bodies are struck at once, or a
/// ball breaks another one in the step, those that breakable bodies strike, the ground, or what is 50 times
/// as heavy, or an explosion. Blows that wait are solved beside the steps that follow, by the world's
/// executor; the body breaks steps later, where it is by then, a whole one before fragments. How many follows
/// from simulated time, the size of bodies, and whether they are prepared by then, never from the clock: a
/// run repeats bit for bit. Events tell (BlowEvent::waited_s, Outcome::dropped); so BlowCounts. A step is one
/// of Bullet's own: a frame may have several.
struct Budget {
    /// How long blows on fragments wait at least, s of simulated time. At 0 none waits: each is decided in
    /// its step, however long that takes.
    double shortest_wait_s = 0.05;
    /// A blow that would wait longer is dropped. One that nothing has to wait for waits no longer either: the
    /// step then takes what is left of it. So it is with what explosions do to whole and held bodies, however
    /// many these are.
    double longest_wait_s = 0.5;
    /// Computing time for blows that wait or may wait, ms a step: of one core of about 2020, estimated from
    /// the size of the bodies. At 0 it is half of the step's own length.
    double milliseconds_per_step = 0;
    /// So many blows that wait are decided a step at most, each with its share of the step's computing time
    /// at least; and so many of those that may wait.
    int solves_per_step = 3;
    Priority priority = Priority::hardest;
    Vec3 viewpoint = Vec3::Zero();  ///< of Priority::nearest, world frame, m
    /// How far ahead a blow on a whole, prepared body is foreseen at least, s of simulated time: what flies
    /// to it, or what it flies to, is followed beside the world's own steps, and what comes of the blow is
    /// solved on other threads until it falls, so that its step has only the bodies to swap. A blow that
    /// falls otherwise (by a tenth of a particle spacing or a hundredth of the speed, or struck by something
    /// else) is solved in its step. At 0 none is foreseen; nor is any while the app has Bullet call it for
    /// contacts (gContactProcessedCallback, gContactStartedCallback, gContactEndedCallback).
    double foresight_s = 0.1;
    /// Fragments that one step brings into the world, about: bodies that break at once share them, and are
    /// made into fewer pieces, two at least; those that waited break a step later.
    int fragments_per_step = 200;
    /// Fragments in the world at most: bodies are made into fewer pieces, and where there is no room for two
    /// they stay whole (Outcome::dropped). So does a body whose blow waited, if other bodies took the room
    /// meanwhile. applyBlow breaks a body all the same.
    int fragments_alive = 1000;

    /// No blow waits or is foreseen, and nothing is limited.
    static Budget none();

    /// The error says which field is out of range, and which values are possible.
    Status validate() const;
};

}  // namespace sherd
