// Which blows break their bodies: at once, or when it is their turn.

#include <algorithm>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/strikes/torn_out.h"
#include "bullet/world/conversions.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/split_mix.h"
#include "core/numerics/urgent_work.h"
#include "core/numerics/worker_threads.h"
#include "fracture/decide_blow.h"

namespace sherd {

namespace {

StrikeOnWhole strikeOnWhole(const StruckBreakable& struck) {
    StrikeOnWhole strike{struck.striker, toBullet(struck.normal)};
    for (const ContactImpulse& contact : struck.blow.contacts) {
        const auto partner = static_cast<std::size_t>(contact.partner);
        if (!contact.strikes() || partner >= struck.partners.size()) continue;
        if (struck.partners[partner] == struck.striker)
            strike.way_m = std::max(strike.way_m, btScalar(contact.approach_m_s * contact.touched_s));
    }
    return strike;
}

}  // namespace

void FractureWorld::Impl::setExecutor(Executor executor) {
    executor_of_app_ = std::move(executor);
}

const Executor& FractureWorld::Impl::executor() {
    if (executor_of_app_) return *executor_of_app_;
    if (!workers_) workers_ = patientWorkerThreads(GivesWay::to_urgent);
    return workers_;
}

BlowToDecide FractureWorld::Impl::toDecide(const StruckBreakable& struck, int most_fragments) const {
    const Breakable& breakable = *struck.breakable;
    BlowToDecide blow{breakable.asset.solid(), struck.blow,       breakable.fracture,
                      seedOf(breakable),       breakable.damaged, {}};
    if (most_fragments < breakable.fracture->largest_fragment_count) {
        auto fewer = std::make_shared<FractureSettings>(*breakable.fracture);
        fewer->largest_fragment_count = std::max(fewest_fragments, most_fragments);
        fewer->fragment_count = std::min(fewer->fragment_count, fewer->largest_fragment_count);
        blow.fracture = std::move(fewer);
    }
    return blow;
}

/// What came of blows that must not wait, on all threads there are.
std::vector<std::shared_ptr<DecidedBlow>> FractureWorld::Impl::decideNow(
    std::vector<std::shared_ptr<DecidedBlow>> decided) {
    std::optional<UrgentWork> urgent;
    if (decided.size() > 1) urgent.emplace();  // one alone leaves others their cores
    for (const auto& one : decided)
        if (one->isSubmitted()) one->hurry();  // it was foreseen: perhaps a thread is at it
    if (executor_of_app_)
        for (std::size_t i = 1; i < decided.size(); ++i) decided[i]->submit(*executor_of_app_);
    else
        forEachChunk(static_cast<int>(decided.size()), [&](int i) { decided[i]->decideIfFreeAnywhere(); });
    for (const auto& one : decided) one->decideIfFree();
    for (const auto& one : decided) one->finish(times_.steps.waiting);
    return decided;
}

/// Notes what came of a blow. Returns what is to be swapped for its fragments, if anything is.
std::optional<FractureWorld::Impl::Break> FractureWorld::Impl::tell(
    const StruckBreakable& struck, const BlowOutcome& outcome, const std::shared_ptr<DecidedBlow>& decided) {
    const std::optional<std::size_t> event = log_.add(struck, outcome, decided.get());
    if (!event) return std::nullopt;
    std::shared_ptr<const DamagedMaterial>& damaged = struck.breakable->damaged;
    damaged = DamagedMaterial::united(damaged, outcome.damaged);
    if (outcome.outcome != Outcome::broke) {
        if (decided) kept_factors_.noteDecided(*struck.breakable, breakables_);
        return std::nullopt;
    }
    return Break{struck.breakable->body, decided, *event, struck.for_pieces, struck.breakable->serial,
                 strikeOnWhole(struck)};
}

/// What the gate says of each blow; nothing where a stress problem is to be solved.
GatedBlows FractureWorld::Impl::gate(const std::vector<StruckBreakable>& struck, btScalar time_step_s) {
    GatedBlows gated;
    gated.held.resize(struck.size());
    gated.ms.resize(struck.size());
    gated.torn.resize(struck.size());
    const auto ask = [&](std::size_t i) {
        const Breakable& body = *struck[i].breakable;
        if (!isToBeRemoved(body))
            gated.held[i] = heldByGate(*body.asset.solid(), struck[i].blow, *body.fracture, seedOf(body),
                                       gated.ms[i].gate, body.damaged);
    };
    std::vector<std::size_t> here, anywhere;
    for (std::size_t i = 0; i < struck.size(); ++i)
        (mayRunElsewhere(*struck[i].breakable->asset.solid(), *struck[i].breakable->fracture) ? anywhere
                                                                                              : here)
            .push_back(i);
    constexpr int at_once = 8;  // fewer take less time than it takes to wake a thread
    const auto count = static_cast<int>(anywhere.size());
    const int chunk_count = std::min(at_once, (count + at_once - 1) / at_once);
    forEachChunk(chunk_count, [&](int chunk) {
        for (int i = chunk; i < count; i += chunk_count) ask(anywhere[i]);
    });
    for (const std::size_t i : here) ask(i);
    for (std::size_t i = 0; i < struck.size(); ++i) {
        const Breakable& body = *struck[i].breakable;
        if (gated.held[i] || isToBeRemoved(body)) continue;
        if (isLightRest(struck[i], time_s_)) {
            if (isInTheWay(struck[i])) gated.torn[i] = Torn::for_good;
            times_.blows += gated.ms[i];
        } else if (time_step_s > 0 && isOutdone(struck[i])) {
            ++counts_.merged;
            times_.blows += gated.ms[i];
        } else if (body.breaksAt(time_s_)) {
            (time_step_s > 0 && patience_.mayWait(struck[i]) ? gated.later : gated.now).push_back(i);
        }
    }
    gated.ahead.resize(struck.size());
    if (time_step_s > 0) {
        findSolvedAhead(struck, gated);
        patience_.tearOutFirst(struck, spent_, gated);
        patience_.thinOut(struck, time_step_s, spent_, gated);
    }
    for (const std::size_t i : gated.later) times_.blows += gated.ms[i];
    for (std::size_t i = 0; i < struck.size(); ++i)
        if (gated.torn[i] == Torn::first) times_.blows += gated.ms[i];
    return gated;
}

std::vector<FractureWorld::Impl::Break> FractureWorld::Impl::evaluateBlows(
    const std::vector<StruckBreakable>& struck, btScalar time_step_s) {
    const ThreadsAsAllowed threads(*this);
    GatedBlows gated = gate(struck, time_step_s);
    const std::vector<std::size_t>& now = gated.now;
    int room = now.empty() ? 0 : roomForFragments();
    const int room_before = room;
    if (time_step_s > 0) dropWithoutRoom(struck, gated, room);
    std::vector<std::shared_ptr<DecidedBlow>> blows;
    const auto kept = std::count_if(gated.later.begin(), gated.later.end(),
                                    [&](std::size_t i) { return struck[i].isKept(); });
    int deciding = 0, taken = 0;  // the others share what is left by those that were solved before they fell
    for (const std::size_t i : now) {
        taken += gated.ahead[i].value_or(0);
        deciding += !gated.ahead[i];
    }
    const int sharing = std::max(1, deciding);
    const int share = std::max(0, room - taken) / (sharing + static_cast<int>(kept)),
              share_of_step =
                  std::max(0, budget_.fragments_per_step - spent_.new_fragments - taken) / sharing;
    for (const std::size_t i : now) {
        const Breakable& breakable = *struck[i].breakable;
        // A factor that one blow leaves serves the next; a reduced model has all that it needs.
        if (!breakable.asset.solid()->reducedStress())
            waiting_.settle(breakable.serial, times_.steps.waiting);
        const int places = gated.ahead[i] ? placesAhead(breakable, room)
                                          : std::min(share + breakable.ownPlaces(), share_of_step);
        BlowToDecide blow = toDecide(struck[i], places);
        if (auto foreseen = takeForeseen(struck[i], blow)) {
            times_.blows += gated.ms[i];
            blows.push_back(std::move(foreseen->decided));
            continue;
        }
        spent_.decided_ms += estimatedMilliseconds(*breakable.asset.solid(), blow.blow);
        blow.before = gated.ms[i];
        blows.push_back(DecidedBlow::make(std::move(blow)));
    }
    spent_.decided += deciding;
    if (time_step_s > 0) interruptWaiting(time_step_s);
    const auto decided = decideNow(std::move(blows));
    std::vector<Break> breaks;
    for (std::size_t i = 0, k = 0; i < struck.size(); ++i) {
        const bool is_now = k < now.size() && now[k] == i;
        const bool is_torn = gated.torn[i] != Torn::not_at_all;
        if (!is_now && !gated.held[i] && !is_torn) continue;
        const auto own = is_now ? decided[k++] : is_torn ? tornOut(struck[i]) : nullptr;
        if (is_now && time_step_s > 0 && !takeRoom(struck[i], own->outcome, room)) {
            (own->doneElsewhere() ? times_.workers : times_.blows) += own->outcome.ms;
            kept_factors_.noteDecided(*struck[i].breakable, breakables_);
            continue;
        }
        const auto broken = tell(struck[i], own ? own->outcome : *gated.held[i], own);
        if (!broken) continue;
        breaks.push_back(*broken);
        if (gated.torn[i] == Torn::first) breaks.back().breaks_later = struck[i];
    }
    std::vector<const StruckBreakable*> to_wait;
    for (const std::size_t i : gated.later) to_wait.push_back(&struck[i]);
    if (!to_wait.empty())
        timed(times_.steps.waiting, [&] { letWait(to_wait, room_before - room, time_step_s); });
    return breaks;
}

std::uint64_t FractureWorld::Impl::seedOf(const Breakable& breakable) const {
    return breakable.seed ? *breakable.seed
                          : splitMix64(breakable.fracture->seed + golden_step * breakable.serial);
}

}  // namespace sherd
