#pragma once

#include <LinearMath/btScalar.h>
#include <sherd/result.h>

#include <string>

#include "scenes/scene.h"

struct GUIHelperInterface;

namespace demo {

/// What the sliders of an example hold. A shot takes the speed at once; everything else counts from the next
/// start of the scene.
struct Knobs {
    btScalar strength_percent = 100;  ///< of the tensile strength in the scene
    btScalar fragments = 0;           ///< 0: as the scene says
    btScalar ball_speed_m_s = 10;
    btScalar quality = 1;  ///< preview, game, film; 1: as the scene says
};

/// Knobs as a scene starts with them.
Knobs knobsOf(const Scene& scene);

/// Puts a slider for each into the browser's panel; `knobs` outlives the panel.
void registerSliders(GUIHelperInterface& helper, Knobs& knobs);

/// The scene of that file, changed as the knobs say.
sherd::Result<Scene> sceneWith(const std::string& file, const Knobs& knobs);

}  // namespace demo
