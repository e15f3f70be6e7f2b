#pragma once

#include <BulletDynamics/Dynamics/btActionInterface.h>
#include <BulletDynamics/Dynamics/btDynamicsWorld.h>
#include <LinearMath/btIDebugDraw.h>

class btDiscreteDynamicsWorld;

namespace sherd {

/// Whether a world is inside a step, or a FractureWorld is adding or removing bodies: then no body may come
/// or go, since Bullet is walking through the lists of them. Right only in a world whose steps are ended by
/// `markBetweenSteps`.
bool isInsideStep(const btDiscreteDynamicsWorld& world);
void markBetweenSteps(btDiscreteDynamicsWorld& world);

/// Makes a world count as inside a step while bodies are added or removed. Bullet calls the app meanwhile
/// (contacts end, pairs are filtered).
class InsideStep {
  public:
    explicit InsideStep(btDiscreteDynamicsWorld& world);
    ~InsideStep();
    InsideStep(const InsideStep&) = delete;
    InsideStep& operator=(const InsideStep&) = delete;

  private:
    btDiscreteDynamicsWorld& world_;
    int before_;
};

/// While one lives, `stepSimulation` throws a std::logic_error before it moves anything, unless the app sets
/// another tick callback meanwhile: Bullet cannot bear a step that begins inside another. Gravity, which
/// Bullet has added by then, acts once more in the step under way; a call that is too short for a step of its
/// own passes.
class NoStepMeanwhile {
  public:
    explicit NoStepMeanwhile(btDiscreteDynamicsWorld& world);
    ~NoStepMeanwhile();
    NoStepMeanwhile(const NoStepMeanwhile&) = delete;
    NoStepMeanwhile& operator=(const NoStepMeanwhile&) = delete;

  private:
    btDiscreteDynamicsWorld& world_;
    btInternalTickCallback of_the_app_;
};

/// Told when the bodies of a step stand at their new places, before any action of the app's.
class IntegrationListener {
  public:
    virtual ~IntegrationListener() = default;
    virtual void afterIntegration() = 0;
};

/// The first action of a world, which Bullet calls right after it has integrated the positions. An app that
/// destroys it from one of its own actions misses the next of these in that step.
class IntegrationHook final : public btActionInterface {
  public:
    IntegrationHook(btDiscreteDynamicsWorld& world, IntegrationListener& listener);
    ~IntegrationHook() override;
    IntegrationHook(const IntegrationHook&) = delete;
    IntegrationHook& operator=(const IntegrationHook&) = delete;

    void updateAction(btCollisionWorld*, btScalar) override { listener_.afterIntegration(); }
    void debugDraw(btIDebugDraw*) override {}

  private:
    btDiscreteDynamicsWorld& world_;
    IntegrationListener& listener_;
};

}  // namespace sherd
