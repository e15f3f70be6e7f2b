#include "bullet/strikes/blow_log.h"

#include <utility>

#include "bullet/bodies/body_warnings.h"
#include "bullet/bodies/kept_factors.h"
#include "bullet/world/conversions.h"

namespace sherd {

namespace {

/// What was made of the body since is looked at with its first blow, and with those that have an event.
std::vector<std::string> warningsWith(Breakable& breakable, bool has_event) {
    std::vector<std::string> warnings;
    const bool is_first = !std::exchange(breakable.warned, true);
    if (is_first) {
        breakable.noteLeastEnergy();
        warnings = warningsOfMaking(breakable);
    }
    if (is_first || has_event)
        for (std::string& sentence : warningsOfChanges(breakable)) warnings.push_back(std::move(sentence));
    return warnings;
}

BlowEvent eventOf(const StruckBreakable& struck, const BlowFigures& figures) {
    const std::shared_ptr<const BreakableSolid>& solid = struck.breakable->asset.solid();
    // An app may keep events for as long as it likes.
    BlowEvent event(keepsFactorForAWhile(*solid) ? BreakableAsset(solid->unsolved())
                                                 : struck.breakable->asset);
    static_cast<BlowFigures&>(event) = figures;
    event.name = struck.breakable->name;
    event.asset_transform = struck.breakable->placed(struck.before.transform);
    event.velocity = fromBullet(struck.before.linear);
    event.angular_velocity = fromBullet(struck.before.angular);
    event.body = struck.breakable->body;
    event.position = struck.position;
    event.normal = struck.normal;
    event.striker = struck.striker;
    event.generation = struck.breakable->generation;
    return event;
}

}  // namespace

std::optional<std::size_t> BlowLog::add(const StruckBreakable& struck, const BlowOutcome& outcome,
                                        const DecidedBlow* decided) {
    const bool has_event = outcome.level != Level::gate || outcome.outcome != Outcome::held ||
                           outcome.full_solve_outcome.has_value();
    const std::vector<std::string> warnings = warningsWith(*struck.breakable, has_event);
    ++counts_.seen;
    ++counts_.at(outcome.level);
    StageTimes elsewhere;
    if (decided && decided->doneElsewhere()) {
        elsewhere = outcome.ms;
        elsewhere.gate = 0;  // the step asked that
    }
    if (!has_event && warnings.empty()) {
        times_.blows += outcome.ms;  // those of the others are added with their events
        times_.blows -= elsewhere;
        times_.workers += elsewhere;
        return std::nullopt;
    }
    BlowEvent event = eventOf(struck, outcome);
    event.warnings.insert(event.warnings.begin(), warnings.begin(), warnings.end());
    event.foreseen = decided && decided->is_foreseen;
    event.ms_elsewhere = elsewhere;
    of_step_.push_back({std::move(event)});
    return of_step_.size() - 1;
}

void BlowLog::addDropped(const StruckBreakable& struck, double impulse_n_s, const char* why,
                         double waited_s) {
    ++counts_.dropped;
    BlowFigures figures;
    figures.outcome = Outcome::dropped;
    figures.impulse_n_s = impulse_n_s;
    figures.waited_s = waited_s;
    figures.message = std::string("the budget left no room for this blow, so the body stays whole: ") + why;
    of_step_.push_back({eventOf(struck, figures)});
}

void BlowLog::addTooMany(const StruckBreakable& struck, double impulse_n_s, double waited_s) {
    addDropped(struck, impulse_n_s,
               "with its fragments there would be more than Budget::fragments_alive allows; raise it, or "
               "remove some",
               waited_s);
}

void BlowLog::addUnbreakable(const Breakable& breakable, const std::string& why) {
    BlowEvent event(breakable.asset);
    event.outcome = Outcome::failed;
    event.name = breakable.name;
    event.body = breakable.body;
    event.asset_transform = breakable.placed(breakable.body->getWorldTransform());
    event.position = fromBullet(breakable.body->getWorldTransform().getOrigin());
    event.message = why;
    of_step_.push_back({std::move(event)});
}

void BlowLog::endStep() {
    for (QueuedEvent& queued : of_step_) {
        times_.blows += queued.event.ms;
        times_.blows -= queued.event.ms_elsewhere;
        times_.workers += queued.event.ms_elsewhere;
        queue_.push(std::move(queued));
    }
    of_step_.clear();
}

}  // namespace sherd
