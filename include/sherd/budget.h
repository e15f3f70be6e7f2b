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
/// body that is not prepared takes most. A step is one of Bullet's own: a frame may have several.
///
/// Decided in their step, always:
/// - blows on a whole body by what it turns back or slows down and cannot break, but for crowds (below);
/// - blows on a fragment by a lighter body that cannot break: what breaks lets that through;
/// - blows on a fragment that supports hold, by what is half as heavy or more as what of it is in the way.
///   Beyond `solves_per_step` such fragments come out of their supports whole, and break later.
///
/// In their step while it has room, else later:
/// - blows on a whole body by the ground, a breakable body, or what is 50 times as heavy; those on a fragment
///   by a lighter whole body. There is room unless more than `solves_per_step` bodies are struck, or a ball
///   breaks another one in the step; then as far as `milliseconds_per_step` and `solves_per_step` go;
/// - blows on a whole body by fragments alone: as far as these go, and one at least where there is no such
///   crowd and a fragment of more than half of the body's mass is among them;
/// - blows on a crowd of free whole bodies, more than `solves_per_step`, by what moves against them and is 10
///   times as heavy as each, kinematic bodies among that: so many, the most urgent, unless something behind a
///   body would stop what strikes it;
/// - blows on such a crowd by what does not move against them and is twice as heavy as each, such as a shelf
///   on which they are set down: as those by the ground;
/// - what an explosion does to whole and held bodies: all of it if these are no more than `solves_per_step`,
///   else one at least.
///
/// Later: other blows on fragments.
///
/// Every blow on a whole body may be solved before it falls (`foresight_s`). Blows that wait are solved
/// beside the steps that follow, by the world's executor; the body breaks steps later, where it is by then, a
/// whole one before fragments. How many follows from simulated time, the size of bodies, and whether they are
/// prepared by then, never from the clock: a run repeats bit for bit. Events tell (BlowEvent::waited_s,
/// Outcome::dropped); so BlowCounts.
struct Budget {
    /// How long blows on fragments wait at least, s of simulated time. At 0 none waits: each is decided in
    /// its step, however long that takes.
    double shortest_wait_s = 0.05;
    /// A blow that would wait longer is dropped when it falls; whole bodies that are struck after it go
    /// before it, which comes on top. One that nothing has to wait for waits no longer either: the step then
    /// takes what is left of it. So it is with what explosions do to whole and held bodies, however many
    /// these are.
    double longest_wait_s = 0.5;
    /// Computing time for blows that wait, ms a step: of one core of about 2020, estimated from the size of
    /// the bodies. At 0 it is the step's own length, as a core has that does nothing else. A step has half of
    /// it for blows that may wait; what it decides takes the core from those that do, for as long as the step
    /// is at most. Foreseen blows have as much of their own from when they are found; one that is solved by
    /// then waits no more.
    double milliseconds_per_step = 0;
    /// So many blows that wait are decided a step at most, each with its share of the step's computing time
    /// at least; and so many of those that may wait.
    int solves_per_step = 3;
    Priority priority = Priority::hardest;
    Vec3 viewpoint = Vec3::Zero();  ///< of Priority::nearest, world frame, m
    /// How far ahead blows on whole bodies are foreseen, s of simulated time, 0 to 1; Sherd looks up to twice
    /// as far, which is less than the solve takes where a body is not prepared: the steps wait for the rest.
    /// At the end of a step it follows what flies freely in a small copy of the world. The blow that it finds
    /// is solved on other threads, and the step in which it falls only swaps the bodies. A blow that falls
    /// otherwise is solved in its step: by another partner, a tenth of a particle spacing, 1 % of the speed
    /// or 2 degrees off, on other supports. At 0 none is foreseen. Nor is any while the app has Bullet call
    /// it for contacts (gContactProcessedCallback, gContactStartedCallback, gContactEndedCallback), for what
    /// two materials come to (gCalculateCombinedFrictionCallback and its like), or for pairs that are near
    /// (btCollisionDispatcher::setNearCallback): it would hear of bodies that it does not have.
    double foresight_s = 0.1;
    /// Large fragments at most whose stress problem is factored beside the steps that follow their birth, on
    /// a thread of its own: what is left of a pane in its frame, on which the next blow would take tenths of
    /// a second otherwise. Blows on these are foreseen, too. Each takes 5 to 10 MB at `game` for as long as
    /// it is there. At 0 none is.
    int prepared_fragments = 32;
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
