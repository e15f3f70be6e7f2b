#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "viewer/drag.h"
#include "viewer/throws.h"
#include "world/scene_world.h"

namespace demo {

/// What the budget of the world is to be (sherd::Budget).
struct BudgetChoice {
    bool limited = false;
    float milliseconds_per_step = 4;
    int solves_per_step = 3;

    bool operator!=(const BudgetChoice& other) const {
        return limited != other.limited || milliseconds_per_step != other.milliseconds_per_step ||
               solves_per_step != other.solves_per_step;
    }
};

/// A blow that had an event, and the assets of the pieces at that moment.
struct SeenBlow {
    sherd::BlowEvent event;
    std::vector<sherd::BreakableAsset> pieces;
    int number = 0;  ///< counts blows from 1
};

/// Wall-clock time of a step, and Sherd's part of it.
struct StepTime {
    float whole_ms = 0, sherd_ms = 0;
};

/// A scene that is stepped for somebody who watches, with what he does to it.
class Simulation {
  public:
    Simulation(const Scene& scene, const SceneAssets& assets);

    /// Moves on by a part of a second, in steps of the scene's length; what is drawn lies between them.
    void advance(double seconds);
    void stepOnce();
    void setBudget(const BudgetChoice& choice);
    void throwBall(const render::Ray& ray, const Throw& how);

    Drag& drag() { return drag_; }
    PlacedScene& placed() { return world_.placed(); }
    btDiscreteDynamicsWorld& world() { return world_.world(); }
    const Scene& scene() const { return scene_; }
    /// The last blow that broke something or could have; none yet.
    const std::optional<SeenBlow>& lastBlow() const { return last_blow_; }
    const std::deque<StepTime>& stepTimes() const { return step_times_; }
    int steps() const { return steps_; }
    int breaks() const { return breaks_; }
    /// Blows that could not be decided, and what the first of them says.
    int failures() const { return failures_; }
    const std::string& firstFailure() const { return first_failure_; }
    double secondsSinceBreak() const { return (steps_ - last_break_step_) * scene_.time_step_s; }

  private:
    void takeEvents();
    static void beforeStep(btDynamicsWorld* world, btScalar);
    static void afterStep(btDynamicsWorld* world, btScalar);

    Scene scene_;
    SceneWorld world_;
    Drag drag_{world_.world()};
    std::optional<SeenBlow> last_blow_;
    std::deque<StepTime> step_times_;
    double step_began_ms_ = 0, sherd_began_ms_ = 0;
    int steps_ = 0, breaks_ = 0, blows_ = 0, failures_ = 0;
    std::string first_failure_;
    int last_break_step_ = -1000000;
};

}  // namespace demo
