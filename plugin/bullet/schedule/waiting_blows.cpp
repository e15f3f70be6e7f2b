#include "bullet/schedule/waiting_blows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "bullet/world/simulated_time.h"

namespace sherd {

namespace {

/// Whether a worker may have the blow already: a little ahead of the plan, so that nothing waits for it where
/// it is slower. Of simulated time alone, since what a solid keeps of a blow serves its next one.
bool isWorkedOn(const WaitingBlow& blow, double time_s) {
    constexpr double ahead_s = 0.1;
    return blow.begun_s <= time_s + ahead_s;
}

/// About.
double particlesOf(const BreakableSolid& solid) {
    const double spacing = solid.spacing();
    return solid.moments().volume / (spacing * spacing * std::min(spacing, solid.wallThickness()));
}

double firstMilliseconds(double particles) {
    return 0.15 * particles * (1 + particles / 400);
}

}  // namespace

// About as blows take that break their bodies, with all that follows: first ones on fragments of 64 to 400
// particles and up to 20,000 triangles at `game` 4 to 90 ms; those on whole bodies of 600 to 1800 particles
// 30 to 90 ms where one before them has left its factor. The one that makes it takes tenths of a second more,
// whenever its turn is: a queue that had that for each of them would drop them all.
double estimatedMilliseconds(const BreakableSolid& solid, const Blow& blow) {
    constexpr double prepared_ms = 15;  // a reduced model answers, then cutting and shapes, if it breaks
    constexpr double support_ms = 0.2;  // what a body leans on answers for itself: in a heap there are many
    const auto supports = std::count_if(blow.contacts.begin(), blow.contacts.end(),
                                        [](const ContactImpulse& contact) { return contact.supports(); });
    const double supports_ms = support_ms * static_cast<double>(supports);
    if (solid.reducedStress()) return prepared_ms + supports_ms;
    const double particles = particlesOf(solid);
    return (solid.isFragment() ? firstMilliseconds(particles) : 10 + 0.04 * particles) + supports_ms;
}

double setUpMilliseconds(const BreakableSolid& solid) {
    return solid.isFragment() || solid.hasSolver() ? 0 : firstMilliseconds(particlesOf(solid));
}

double millisecondsPerStep(const Budget& budget, double time_step_s) {
    return budget.milliseconds_per_step > 0 ? budget.milliseconds_per_step : 1e3 * time_step_s;
}

double WaitingBlows::turn_s(double work_ms, const Budget& budget, double time_step_s) {
    return time_step_s *
           std::max(work_ms / millisecondsPerStep(budget, time_step_s), 1.0 / budget.solves_per_step);
}

double WaitingBlows::left_s(const Budget& budget, double time_s) const {
    double begin_s = std::max(busy_until_s_, time_s);
    for (auto blow = blows_.rbegin(); blow != blows_.rend(); ++blow)
        if (blow->is_on_fragment && !isWorkedOn(*blow, time_s)) begin_s = blow->begun_s;
    constexpr double least = 0.5;  // a second explosion's bodies wait longer, rather than break all at once
    return std::max(least * budget.longest_wait_s, time_s + budget.longest_wait_s - begin_s);
}

WaitingBlows::Fate WaitingBlows::add(WaitingBlow blow, double turn_s, const Budget& budget, double time_s) {
    for (WaitingBlow& other : blows_) {
        if (other.serial != blow.serial) continue;
        const bool is_harder = other.energy_j < blow.energy_j;
        if (is_harder && (isWorkedOn(other, time_s) || other.due_s < time_s + budget.shortest_wait_s))
            continue;
        WaitingBlow& kept = is_harder ? blow : other;
        WaitingBlow& left_out = is_harder ? other : blow;
        kept.for_pieces.insert(kept.for_pieces.end(), left_out.for_pieces.begin(), left_out.for_pieces.end());
        kept.is_kept |= left_out.is_kept;
        if (!is_harder) return Fate::merged;
        blow.struck_at_s = time_s;
        blow.begun_s = other.begun_s;
        blow.worked_by_s = other.worked_by_s;
        blow.due_s = other.due_s;
        other = std::move(blow);
        return Fate::merged;
    }
    const double last_s = time_s + budget.longest_wait_s;
    const auto place = std::find_if(blows_.begin(), blows_.end(), [&](const WaitingBlow& other) {
        return !blow.is_on_fragment && other.is_on_fragment && !isWorkedOn(other, time_s);
    });
    const bool is_alone = busy_until_s_ <= time_s;
    blow.begun_s = place == blows_.end() ? std::max(busy_until_s_, time_s) : place->begun_s;
    turn_s = std::clamp(blow.solved_by_s - blow.begun_s, 0.0, turn_s);
    const double done_s = blow.begun_s + turn_s;
    if (!is_alone && !blow.is_kept && turn_s > 0 && done_s > last_s) return Fate::dropped;
    busy_until_s_ = is_alone ? std::min(done_s, last_s) : busy_until_s_ + turn_s;
    for (auto later = place; later != blows_.end(); ++later)
        for (double* moment : {&later->begun_s, &later->worked_by_s, &later->due_s}) *moment += turn_s;
    blow.worked_by_s = blow.is_kept ? done_s : std::min(done_s, last_s);
    blow.struck_at_s = time_s;
    blow.due_s = std::max(blow.worked_by_s, time_s + budget.shortest_wait_s);
    if (place != blows_.begin()) blow.due_s = std::max(blow.due_s, std::prev(place)->due_s);
    // Turns keep their order.
    double due_s = blow.due_s;
    for (auto later = blows_.insert(place, std::move(blow)); later != blows_.end(); ++later)
        due_s = later->due_s = std::max(later->due_s, due_s);
    return Fate::waits;
}

void WaitingBlows::interrupt(double for_s, const Budget& budget, double time_s) {
    if (busy_until_s_ <= time_s) return;
    busy_until_s_ += for_s;
    double due_s = 0;
    for (WaitingBlow& blow : blows_) {
        if (blow.begun_s > time_s) blow.begun_s += for_s;
        const double last_s = std::max(blow.worked_by_s, blow.struck_at_s + budget.longest_wait_s);
        if (blow.worked_by_s > time_s) blow.worked_by_s = std::min(blow.worked_by_s + for_s, last_s);
        due_s = blow.due_s = std::max({due_s, blow.due_s, blow.worked_by_s});
    }
}

void WaitingBlows::keepTo(const Budget& budget, double time_s) {
    const double longest_s = budget.shortest_wait_s > 0 ? budget.longest_wait_s : 0;
    for (WaitingBlow& blow : blows_)
        for (double* moment : {&blow.begun_s, &blow.worked_by_s, &blow.due_s})
            *moment = std::min(*moment, std::max(time_s, blow.struck_at_s + longest_s));
    for (std::size_t i = 1; i < blows_.size(); ++i)
        blows_[i].due_s = std::max(blows_[i].due_s, blows_[i - 1].due_s);
    busy_until_s_ = std::min(busy_until_s_, time_s + longest_s);
}

bool WaitingBlows::isFirstOfItsBody(std::size_t number) const {
    return std::none_of(blows_.begin(), blows_.begin() + static_cast<long>(number),
                        [&](const WaitingBlow& other) { return other.serial == blows_[number].serial; });
}

void WaitingBlows::submit(const Executor& executor, double time_s) {
    for (std::size_t i = 0; i < blows_.size(); ++i)
        if (!blows_[i].decided->isSubmitted() && isWorkedOn(blows_[i], time_s) && isFirstOfItsBody(i))
            blows_[i].decided->submit(executor);
}

void WaitingBlows::workUntil(double time_s) {
    double none = 0;  // nobody else does any
    for (std::size_t i = 0; i < blows_.size(); ++i)
        if (blows_[i].worked_by_s <= time_s + time_rounding_s && isFirstOfItsBody(i))
            blows_[i].decided->finish(none);
}

const WaitingBlow* WaitingBlows::due(double time_s) const {
    return !blows_.empty() && blows_.front().due_s <= time_s + time_rounding_s ? &blows_.front() : nullptr;
}

void WaitingBlows::finishFirst(double until_s, double& waiting_ms) {
    constexpr double slower = 2;  // than the estimate has it
    DecidedBlow& first = *blows_.front().decided;
    first.decideIfFree();
    for (std::size_t i = 1; i < blows_.size() && !first.isDecided(); ++i) {
        const WaitingBlow& next = blows_[i];
        const double left_ms = slower * blows_.front().work_ms - first.decidedFor_ms();
        const bool fits = next.decided->isSubmitted() && slower * next.work_ms <= left_ms;
        if ((fits || next.worked_by_s <= until_s) && isFirstOfItsBody(i)) next.decided->decideIfFree();
    }
    first.finish(waiting_ms);
}

WaitingBlow WaitingBlows::takeFirst() {
    WaitingBlow first = std::move(blows_.front());
    blows_.pop_front();
    return first;
}

const WaitingBlow* WaitingBlows::keptFor(std::uint64_t serial) const {
    for (const WaitingBlow& blow : blows_)
        if (blow.serial == serial && blow.is_kept) return &blow;
    return nullptr;
}

std::vector<Push> WaitingBlows::pushesFor(std::uint64_t serial) const {
    std::vector<Push> pushes;
    for (const WaitingBlow& blow : blows_)
        if (blow.serial == serial)
            pushes.insert(pushes.end(), blow.for_pieces.begin(), blow.for_pieces.end());
    return pushes;
}

int WaitingBlows::promised() const {
    constexpr long long most = std::numeric_limits<int>::max() / 2;
    long long fragments = 0;
    for (const WaitingBlow& blow : blows_)
        if (blow.is_kept) fragments += blow.promised;
    return static_cast<int>(std::min(fragments, most));
}

void WaitingBlows::settle(std::uint64_t serial, double& waiting_ms) {
    for (WaitingBlow& blow : blows_)
        if (blow.serial == serial) {
            blow.decided->finish(waiting_ms);
            return;
        }
}

}  // namespace sherd
