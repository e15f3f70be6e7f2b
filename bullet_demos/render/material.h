#pragma once

#include "render/types.h"

namespace render {

/// What is drawn over the plain colour of a surface.
enum class Pattern {
    plain,
    plaster,  ///< fine grain, matt
    wood,     ///< rings and fibres along the grain
    stone,    ///< a ground floor
    speckle,  ///< iron spots under a glaze
};

/// How a surface looks. Colours are linear, from 0 to 1. A mesh tells its outside from its inside (the faces
/// of a break), and a material has a colour for each.
struct Material {
    Vec3 outside = Vec3::Constant(0.7f);
    Vec3 inside = Vec3::Constant(0.8f);
    float gloss = 0;      ///< share of light that a clear coat on the outside mirrors at right angles
    float roughness = 0;  ///< of that coat, from 0, a mirror, to 1
    float metal = 0;      ///< 1: the coat mirrors in the outside's colour and nothing is under it
    float clear = 0;      ///< share of the light that goes through; above 0: glass, drawn last
    float bent = 0;       ///< share of that light that the surface bends aside
    Pattern pattern = Pattern::plain;
    Vec3 grain = Vec3::UnitZ();  ///< of Pattern::wood, in the mesh's coordinates
    float pattern_size = 0.1f;   ///< m
};

/// Sun and sky of a scene.
struct Light {
    Vec3 towards = Vec3(0.55f, 0.42f, -1).normalized();  ///< the direction that the sunlight takes
    Vec3 sun = Vec3(3.0f, 2.75f, 2.4f);
    Vec3 sky = Vec3(0.66f, 0.74f, 0.86f);  ///< from straight above
    Vec3 horizon = Vec3(0.31f, 0.325f, 0.345f);
    Vec3 ground = Vec3(0.20f, 0.19f, 0.18f);  ///< from below
    float softness = 0.012f;  ///< width of a shadow's edge, as a fraction of what the shadow map covers
};

}  // namespace render
