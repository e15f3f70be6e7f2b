#pragma once

#include <sherd/sherd.h>

#include "render/material.h"
#include "scenes/scene.h"

namespace demo {

/// How a body is drawn: in the colours of `look`, with the pattern of its material. `size_m` is about the
/// radius of the whole body.
render::Material renderMaterial(const sherd::BreakableAsset& asset, const Look& look, float size_m);

/// Of the balls.
render::Material steel();
/// Of the ground.
render::Material floorStone(float size_m);

}  // namespace demo
