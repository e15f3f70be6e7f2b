#pragma once

#include "render/material.h"

namespace prototype {

render::Material paintedWall();
render::Material darkWood();
/// Of the floor; no two neighbours are alike.
render::Material plankWood(int number);
render::Material groundStone();
render::Material windowGlass();
render::Material rawPlaster();
render::Material redBall();
/// Of the crockery; a few colours in turn.
render::Material glaze(int number);

/// Sun through the open front of the hall.
render::Light daylight();

}  // namespace prototype
