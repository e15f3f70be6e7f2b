#pragma once

#include "render/context.h"
#include "viewer/state.h"

namespace demo {

/// Mouse and keys: turns the camera, throws, drags, and sets the state. Call once a frame, after the panels
/// were begun; what a panel takes is left to it. `simulation` may be missing.
class Controls {
  public:
    void apply(ViewerState& state, render::OrbitCamera& camera, Simulation* simulation,
               render::Context& context);

  private:
    void turnCamera(ViewerState& state, render::OrbitCamera& camera, render::Size size);
    void throwOrDrag(ViewerState& state, const render::Ray& ray, Simulation& simulation);
    static void takeKey(ViewerState& state, int key);

    float moved_ = 0;  ///< pixels that the mouse moved with the left button down
};

}  // namespace demo
