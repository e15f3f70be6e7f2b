#include "bullet/strikes/blow_log.h"

#include <cmath>
#include <utility>

#include "bullet/bodies/kept_factors.h"
#include "bullet/shapes/shapes.h"
#include "bullet/world/conversions.h"

namespace sherd {

namespace {

/// What the asset warns of, with the first blow on its body.
std::vector<std::string> warningsAtFirstBlow(Breakable& breakable) {
    if (std::exchange(breakable.warned, true)) return {};
    std::vector<std::string> warnings = breakable.asset.warnings();
    breakable.noteLeastEnergy();
    if (breakable.prepared_free && !breakable.asset.prepared())
        warnings.push_back(
            "the asset was prepared, but not as supports hold this body, so that its first blow takes long: "
            "prepare what BreakableAsset::anchored makes of it, and add bodies of that");
    const BreakableSolid& solid = *breakable.asset.solid();
    const double off_m = (breakable.body_from_asset * toBullet(solid.moments().centroid)).length();
    constexpr double far = 0.02;  // of its radius
    const bool turns = breakable.isDynamic() && !breakable.body->getAngularFactor().isZero();
    if (!breakable.ownedHere() && turns && off_m > far * solid.boundingRadius())
        warnings.push_back(
            "the body turns about a point that is " + std::to_string(std::lround(1000 * off_m)) +
            " mm from the centre of its solid, about which its pieces turn: they fall and "
            "spin otherwise than it did; in a btCompoundShape the shape can be shifted so that both are one");
    const bool is_scaled = breakable.ownedHere() && isScaled(*breakable.owned.shape->shape) &&
                           breakable.body->getCollisionShape() == breakable.owned.shape->shape.get();
    if (is_scaled)
        warnings.push_back(
            "the collision shape of this body was scaled (setLocalScaling), and with it that of all bodies "
            "of its asset; the body breaks as its asset is, unscaled: scale the mesh instead "
            "(Repair::scale), and add bodies of that");
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
    const std::vector<std::string> warnings = warningsAtFirstBlow(*struck.breakable);
    ++counts_.seen;
    ++counts_.at(outcome.level);
    StageTimes elsewhere;
    if (decided && decided->doneElsewhere()) {
        elsewhere = outcome.ms;
        elsewhere.gate = 0;  // the step asked that
    }
    if (outcome.level == Level::gate && outcome.outcome == Outcome::held && warnings.empty() &&
        !outcome.full_solve_outcome) {
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
