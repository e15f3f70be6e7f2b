// Broken bodies are swapped for their fragments, and the step is solved once more with these.

#include <algorithm>
#include <exception>
#include <unordered_set>

#include "bullet/fracture_world_impl.h"
#include "bullet/fragments/birth_callback.h"
#include "bullet/fragments/body_removal.h"
#include "bullet/fragments/body_swap.h"
#include "bullet/fragments/collision_exceptions.h"
#include "bullet/ground/ground_contact.h"
#include "bullet/ground/steady_contacts.h"
#include "bullet/island/contact_motion.h"
#include "bullet/strikes/applied_blow.h"
#include "bullet/strikes/same_blow.h"
#include "bullet/world/world_internals.h"
#include "core/numerics/split_mix.h"

namespace sherd {

namespace {

std::vector<btCollisionObject*> without(std::vector<btCollisionObject*> objects,
                                        const btCollisionObject* left_out) {
    objects.erase(std::remove(objects.begin(), objects.end(), left_out), objects.end());
    return objects;
}

}  // namespace

/// Swaps broken bodies for their fragments and solves the islands concerned once more; `swept` bodies get new
/// predictive contacts. Returns the breakable bodies that these are about to hit: none are looked for if this
/// is the `last` time.
std::vector<const btCollisionObject*> FractureWorld::Impl::resolveIslands(
    std::vector<Break>& breaks, const std::vector<btRigidBody*>& swept, bool last,
    const btContactSolverInfo& info, btIDebugDraw* drawer) {
    std::vector<btCollisionObject*> members(swept.begin(), swept.end());
    for (const Break& broken : breaks) members.push_back(broken.body);
    members = restoredIsland(members).bodies;

    std::vector<btCollisionObject*> new_bodies;
    std::vector<std::pair<StrikeOnWhole, std::vector<btCollisionObject*>>> struck;
    for (Break& broken : breaks) {
        const std::vector<btCollisionObject*> fragments = swap(broken, info.m_timeStep);
        if (!fragments.empty()) members = without(std::move(members), broken.body);
        new_bodies.insert(new_bodies.end(), fragments.begin(), fragments.end());
        struck.emplace_back(broken.strike, fragments);
    }
    timed(times_.steps.snapshot,
          [&] { decorator_.forEachListener([&](StepListener& hook) { hook.bodiesEnter(new_bodies); }); });
    timed(times_.steps.resolve, [&] {
        findContactsOf(world_, new_bodies);
        for (const auto& [strike, pieces] : struck)
            pushAsTheWholeWasStruck(*world_.getDispatcher(), strike, pieces);
    });
    timed(times_.steps.overlaps, [&] { allowOverlapsAtBirth(new_bodies); });
    const std::unordered_set<const btCollisionObject*> is_new(new_bodies.begin(), new_bodies.end());
    timed(times_.steps.overlaps, [&] {
        steadyContacts(world_, steadiedBodies(),
                       [&](const auto& object) { return is_new.count(&object) > 0; });
    });
    timed(times_.steps.ground, [&] {
        std::vector<const Breakable*> new_fragments;
        for (const btCollisionObject* body : new_bodies) new_fragments.push_back(breakables_.find(body));
        addGroundContacts(world_, new_fragments, moved_ground_.surfaces());
    });
    members.insert(members.end(), new_bodies.begin(), new_bodies.end());
    auto next = timed(times_.steps.sweep, [&] { return sweepAgain(swept, last, info.m_timeStep); });

    // Fragments may touch bodies that the whole body did not, and their islands then have to be solved again
    // too.
    Island pieces = restoredIsland(members);
    const AddedTime time(times_.steps.resolve);
    for (btCollisionObject* body : pieces.bodies) body->activate();
    solveIsland(world_, decorator_.innermost(), pieces, info, drawer);
    return next;
}

/// The islands of some bodies, set back to before the solve.
Island FractureWorld::Impl::restoredIsland(const std::vector<btCollisionObject*>& members) {
    const AddedTime time(times_.steps.restore);
    Island island = connectedIsland(world_, members);
    before_.restore(island);
    return island;
}

/// Makes the predictive contacts of bodies anew. Returns the breakable bodies that they are about to hit.
std::vector<const btCollisionObject*> FractureWorld::Impl::sweepAgain(const std::vector<btRigidBody*>& swept,
                                                                      bool last, btScalar time_step_s) {
    const Obstacles obstacles{[&](const auto& object) { return isFragmentOfAny(object); },
                              [&](const auto& object) { return last && breakables_.find(&object); }};
    std::vector<const btCollisionObject*> next;
    for (btRigidBody* body : swept) {
        const btCollisionObject* hit = predictContacts(world_, *body, obstacles, time_step_s);
        if (hit && breakables_.find(hit)) next.push_back(hit);
    }
    return next;
}

void FractureWorld::Impl::findNewContacts(const std::vector<btCollisionObject*>& new_bodies) {
    timed(times_.steps.resolve, [&] { findContactsOf(world_, new_bodies); });
    timed(times_.steps.overlaps, [&] { allowOverlapsAtBirth(new_bodies); });
}

void FractureWorld::Impl::allowOverlapsAtBirth(const std::vector<btCollisionObject*>& new_bodies) {
    std::vector<btCollisionObject*> may_overlap;
    for (btCollisionObject* body : new_bodies)
        if (!breakables_.find(body)->owned.shape->disjoint) may_overlap.push_back(body);
    if (!may_overlap.empty()) birth_overlaps_.add(world_, may_overlap);
    birth_overlaps_.applyAllowances(world_);
}

/// Returns the fragments, now in the world; none if their bodies could not be made.
std::vector<btCollisionObject*> FractureWorld::Impl::swap(Break& broken, btScalar time_step_s) {
    BlowEvent& event = log_.ofStep()[broken.event].event;
    Breakable* const parent = stillThere(broken);
    if (!parent) {
        event.outcome = Outcome::failed;
        event.message = "the body was taken out of the world while others broke";
        return {};
    }
    auto pieces = timed(event.ms.bodies, [&] { return makePieces(broken, *parent, time_step_s > 0); });
    if (pieces.empty()) return {};
    const auto fragments =
        timed(event.ms.swap, [&] { return exchange(broken, *parent, std::move(pieces), time_step_s); });
    if (broken.breaks_later)
        breakLater(*broken.breaks_later, *breakables_.find(fragments.front()), time_step_s);
    return fragments;
}

/// What struck a rest that was torn out breaks the piece when it is its turn.
void FractureWorld::Impl::breakLater(StruckBreakable rest, Breakable& piece, btScalar time_step_s) {
    rest.breakable = &piece;
    rest.before = stateOf(*piece.body);
    timed(times_.steps.waiting, [&] { letWait({&rest}, 0, time_step_s); });
}

/// The broken body; none if the app has taken it out since, in the callback of another one's fragments.
Breakable* FractureWorld::Impl::stillThere(const Break& broken) const {
    const auto& all = breakables_.all();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& breakable) {
        return breakable->serial == broken.serial && isInWorld(world_, breakable->body) &&
               !isToBeRemoved(*breakable);
    });
    return found == all.end() ? nullptr : found->get();
}

/// The bodies of the fragments. If that fails there are none, and the event says why.
std::vector<std::unique_ptr<Breakable>> FractureWorld::Impl::makePieces(const Break& broken,
                                                                        const Breakable& parent,
                                                                        bool inside_step) {
    try {
        return makeFragmentBodies(parent, *broken.decided, world_.getGravity(), inside_step);
    } catch (const std::exception& trouble) {
        BlowEvent& event = log_.ofStep()[broken.event].event;
        event.outcome = Outcome::failed;
        event.message = std::string("the fragments' bodies could not be made (") + trouble.what() +
                        "); the body stays whole";
        if (parent.isFragment()) turnAboutOneAxis(*parent.body);
        return {};
    }
}

/// Puts the pieces in the place of their parent.
std::vector<btCollisionObject*> FractureWorld::Impl::exchange(Break& broken, Breakable& parent,
                                                              std::vector<std::unique_ptr<Breakable>> pieces,
                                                              btScalar time_step_s) {
    BlowEvent& event = log_.ofStep()[broken.event].event;
    pushLoose(pieces, broken.for_pieces);
    pushLoose(pieces,
              moved(waiting_.pushesFor(parent.serial), parent.placed(broken.body->getWorldTransform())));
    event.momentum_error_rel = momentumError(*broken.body, pieces);
    event.dropped_mass_kg = dropDebris(broken.decided->outcome.fragments, pieces);
    // Between steps, too: the ball of a fragment tells the side of the ground at any time.
    if (time_step_s > 0 || parent.isFragment())
        setBackOnGround(world_, parent, pieces, moved_ground_.since(world_));
    inheritCollisionExceptions(world_, parent, pieces);
    const std::vector<Breakable*> born = registerFragments(parent, std::move(pieces), !broken.breaks_later);
    for (Breakable* fragment : born) {
        const auto callback = on_fragment_;  // which may set another one
        if (*callback && !released_) announceBirth(world_, *callback, parent, *fragment, event);
        turnAboutOneAxis(*fragment->body);
        event.fragments.push_back(fragment->body);
    }
    RemovedJoints joints = removeFromWorld(world_, parent);
    event.removed_constraints = std::move(joints.constraints);
    event.removed_multi_body_constraints = std::move(joints.multi_body_constraints);
    addToWorld(world_, born, time_step_s);
    for (Breakable* fragment : born) fragment->being_born = false;
    spent_.new_fragments += static_cast<int>(born.size());
    log_.ofStep()[broken.event].broken = breakables_.take(parent.token);
    return {event.fragments.begin(), event.fragments.end()};
}

/// What comes out of its supports whole and is to break after that is of its parent's generation still.
std::vector<Breakable*> FractureWorld::Impl::registerFragments(const Breakable& parent,
                                                               std::vector<std::unique_ptr<Breakable>> pieces,
                                                               bool of_next_generation) {
    std::vector<Breakable*> fragments;
    const std::vector<BodyToken> same_blow = partOfTheBlowOn(world_, *parent.body);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Breakable& fragment = registerBreakable(std::move(pieces[i]));
        if (parent.seed) fragment.seed = splitMix64(*parent.seed + golden_step * (i + 1));
        fragment.damaged = parent.damaged;
        fragment.unbreakable_until_s = time_s_ + parent.fracture->rest_after_break_s;
        noteBlow(same_blow, parent, time_s_, fragment);
        fragment.generation = parent.generation + of_next_generation;
        fragment.being_born = true;
        fragments.push_back(&fragment);
    }
    if (of_next_generation) solvers_ahead_.addFragments(fragments, roomForPrepared(), mayHaveThreads());
    return fragments;
}

}  // namespace sherd
