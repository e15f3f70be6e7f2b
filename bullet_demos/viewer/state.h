#pragma once

#include <string>
#include <vector>

#include "viewer/choices.h"
#include "viewer/overlays.h"
#include "viewer/simulation.h"
#include "viewer/throws.h"

namespace demo {

/// What panels and keys change, and the window obeys.
struct ViewerState {
    Choices choices;  ///< what is shown, or being loaded
    Throw throwing;
    BudgetChoice budget;
    Overlays overlays;
    bool paused = false;
    float speed = 1;     ///< of time: below 1 slow motion
    bool follow = true;  ///< the camera keeps its eye on the bodies
    bool panels = true;

    // Wishes for the next frame.
    bool step_once = false;
    bool restart = false;  ///< the scene from its start, with what the choices say of how it breaks
    bool reload = false;   ///< another scene, mesh or material
    bool frame_view = false;
    bool screenshot = false;
    bool recording = false;         ///< a picture of every frame
    bool start_now = false;         ///< without waiting for the preparation
    std::vector<std::string> said;  ///< by the library, of what was loaded; or why it cannot be
    std::string notice;             ///< what was last written, or went wrong
};

}  // namespace demo
