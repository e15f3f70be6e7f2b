#pragma once

#include "render/context.h"
#include "viewer/overlays.h"

namespace demo {

/// The panel on the right: the time of steps, the counts of blows, and the stages of the last one.
void drawBlowPanel(Simulation& simulation, render::Size size);

/// What the colours of the particles mean.
void drawColourBar(const BlowStress& stress, ParticleColour by, render::Size size);

}  // namespace demo
