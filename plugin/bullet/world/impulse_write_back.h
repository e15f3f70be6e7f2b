#pragma once

class btDiscreteDynamicsWorld;

namespace sherd {

/// Bullet's solvers write contact impulses back only when warm starting is on. Where the app has turned it
/// off, this turns it on for one solve with a factor of 0, which changes no result, and clears the impulses
/// afterwards.
class ImpulseWriteBack {
  public:
    void begin(btDiscreteDynamicsWorld& world);
    /// Does nothing where nothing was begun.
    void end(btDiscreteDynamicsWorld& world);

  private:
    bool forced_ = false;
    float apps_factor_ = 0;
};

}  // namespace sherd
