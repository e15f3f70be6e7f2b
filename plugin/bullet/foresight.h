#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "bullet/contact_collector.h"
#include "bullet/decided_blow.h"
#include "bullet/island_state.h"
#include "bullet/rehearsal.h"

namespace sherd {

/// A blow that a rehearsal has found.
struct ForeseenBlow {
    std::uint64_t serial = 0;                  ///< of the body that will be struck
    const btCollisionObject* mover = nullptr;  ///< whose way was rehearsed; may be dead: compared only
    double strikes_at_s = 0;                   ///< simulated time
    std::vector<const btCollisionObject*> partners;
    BlowToDecide blow;
    std::shared_ptr<DecidedBlow> decided;
};

/// What strikes what in the steps to come, and what comes of it. A body that flies freely does what a
/// rehearsal of a few steps says, so that its blow can be solved beside these steps instead of in the one in
/// which it falls. A blow that falls otherwise than foreseen is solved when it falls. All of this follows
/// from the state of the world alone, never from which thread was faster.
class Foresight {
  public:
    bool empty() const { return outlooks_.empty() && blows_.empty(); }
    /// Forgets all of it. Returns how many blows that were.
    int clear();

    /// For the end of a step: drops what has not come true. `is_there`: whether an object is in the world.
    /// Returns how many blows that were.
    int follow(const btDiscreteDynamicsWorld& world, double time_s);
    /// Whether nothing is known of what a body does from here on, or too little of it to be worth more.
    bool isToBeLookedAt(const btCollisionObject& mover, double time_s, double ahead_s) const;
    /// Notes where a body goes, up to `until_s`.
    void note(const btCollisionObject& mover, std::vector<BodyState> way, double until_s);
    void note(ForeseenBlow blow);
    bool isForeseen(std::uint64_t serial) const;
    /// What comes of a blow that falls as it was foreseen; nullptr for others.
    std::shared_ptr<DecidedBlow> take(const StruckBreakable& struck, const BlowToDecide& blow);

  private:
    /// What is known of a body.
    struct Outlook {
        const btCollisionObject* mover = nullptr;
        std::vector<BodyState> way;  // at the end of each step since it was looked at
        std::size_t steps = 0;       // gone since
        double until_s = 0;          // simulated time
        int surprises = 0;           // one after the other
        double rests_until_s = 0;    // it does what nobody foresees
    };
    Outlook* of(const btCollisionObject* mover);
    void surprised(Outlook& outlook, double time_s);

    std::vector<Outlook> outlooks_;  // in the order in which they were noted
    std::vector<ForeseenBlow> blows_;
};

/// Whether a body may bring some energy to what it meets, by its speed.
bool mayBring(const btRigidBody& mover, double energy_j);

/// The bodies that a rehearsal of a mover's next `ahead_s` seconds needs, in the order of the world's
/// objects: itself, what it may meet on its way, and what touches one of these. Empty if it meets no whole
/// body that it might break, or breaks on nothing. Of `is_foreseeable` bodies a reduced model tells the
/// stress.
std::vector<Role> rolesAround(btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                              const StepSnapshot& before, btRigidBody& mover, double ahead_s, double time_s);

/// Whether a blow on a body could be foreseen, and is worth that: whole, prepared, not too new to break.
bool isForeseeable(const Breakable& breakable, double time_s);

}  // namespace sherd
