#pragma once

#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/island/island_state.h"
#include "bullet/strikes/contact_collector.h"

class btPersistentManifold;

namespace sherd {

/// What bodies that rest on each other hear of a strike on one of them: a hammer on a column squeezes each of
/// its bricks. Nothing strikes the lower ones, and Bullet's impulses there are those of a time step; so the
/// pile goes into the blow as it stands (`Stack`), and the loads follow from how it gives way while the
/// strike lasts. A pile is the struck body and up to eleven others that move, the nearest by contacts. Of
/// several strikes on one pile, the one that brings most energy counts for those that it does not touch, and
/// for those that nothing else strikes hard enough to break them. What rests on a body that lands is struck
/// by that in turn, and so is what rests on it.
class Piles {
  public:
    /// From the solved manifolds of a step. `predictive` are those of continuous collision.
    Piles(const std::vector<const btPersistentManifold*>& solved,
          const std::vector<const btPersistentManifold*>& predictive, const BreakableRegistry& breakables,
          const StepSnapshot& before, double time_s, double time_step_s);

    /// Whether a strike on another body may break this one: it is squeezed, or rides on what lands.
    bool mayBreak(const Breakable& breakable) const;
    /// Whether a body, no fragment, came upon another one, or rests on what did. What rests on it goes on and
    /// strikes it.
    bool lands(const btCollisionObject& object) const { return landed_.count(&object) > 0; }
    /// Whether what does not give way had stopped a striker, at that place of it, before it touched what
    /// would push it there like that: a wall between them is thinner than its way in a step.
    bool isStoppedBefore(const btCollisionObject& striker, const btVector3& place, const btVector3& push,
                         double touched_s, double closing_m_s) const;
    /// Gives a blow its stack. Strikes beside that are then left out if they cannot break the body.
    void attachTo(StruckBreakable& struck) const;

  private:
    /// Where and how a body is struck; world frame.
    struct Strike {
        const btCollisionObject *striker = nullptr, *struck = nullptr;
        btVector3 point, push;  // on the struck body
        double speed_m_s = 0, energy_j = 0;
        double touched_s = 0;  // before the solve
        int striker_child = -1, struck_child = -1;
        bool is_brought = false;  // by the struck body, most of the speed
    };
    /// By what does not give way.
    struct Stop {
        btVector3 place, push;
        double speed_m_s, touched_s;
    };
    struct Pile {
        Strike strike;
        std::vector<const btCollisionObject*> bodies;  // those that move; the struck one first
        std::vector<const btPersistentManifold*> contacts;
    };
    using Neighbours = std::unordered_map<const btCollisionObject*, std::vector<const btPersistentManifold*>>;

    /// How the bodies of a manifold meet: as strikes, if they do; else pressed on each other, if they are.
    void look(const btPersistentManifold& manifold, bool is_predictive, std::vector<Strike>& strikes,
              std::vector<const btPersistentManifold*>& pressed);
    void leaveOutFaint(std::vector<Strike>& strikes) const;
    void noteLanding(const Strike& strike);
    void noteStop(const btCollisionObject& stopped, const btCollisionObject& by, const Stop& stop);
    void noteRiders(const std::vector<const btPersistentManifold*>& pressed);
    /// Whether the rider is one that others may ride on, faster than was known.
    bool noteRider(const btCollisionObject& rider, const btCollisionObject& carrier);
    Pile pileOf(const Strike& strike, const Neighbours& neighbours) const;
    void assign(Pile pile);
    Stack stackOf(const Pile& pile, StruckBreakable& struck) const;
    StackBody stackBody(const btCollisionObject& object, const Pile& pile, StruckBreakable& struck,
                        const btTransform& from_world) const;
    void addContacts(const btPersistentManifold& manifold, StruckBreakable& struck,
                     const btTransform& from_world, Stack& stack) const;
    DistantStrike distantStrike(const Strike& strike, StruckBreakable& struck,
                                const btTransform& from_world) const;
    HertzContact contactBetween(const btCollisionObject& a, const btCollisionObject& b,
                                const ContactSettings& settings) const;

    const BreakableRegistry& breakables_;
    const StepSnapshot& before_;
    double time_s_, time_step_s_;
    std::vector<Pile> piles_;
    // For look-up only.
    std::unordered_map<const btCollisionObject*, std::size_t> pile_of_;
    std::unordered_map<const btCollisionObject*, std::vector<Stop>> stops_;
    std::unordered_map<const btCollisionObject*, double> landed_;  // m/s
    std::unordered_set<const btCollisionObject*> riding_;          // on what landed
};

}  // namespace sherd
