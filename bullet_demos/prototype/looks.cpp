#include "prototype/looks.h"

#include <array>

namespace prototype {
namespace {

using render::Pattern;
using render::Vec3;

render::Material matt(const Vec3& outside, const Vec3& inside, Pattern pattern, float pattern_size) {
    render::Material look;
    look.outside = outside;
    look.inside = inside;
    look.pattern = pattern;
    look.pattern_size = pattern_size;
    return look;
}

}  // namespace

render::Material paintedWall() {
    return matt({0.50f, 0.50f, 0.42f}, {0.7f, 0.7f, 0.7f}, Pattern::plaster, 0.6f);
}

render::Material darkWood() {
    render::Material look = matt({0.26f, 0.13f, 0.06f}, {0.4f, 0.25f, 0.12f}, Pattern::wood, 0.35f);
    look.grain = Vec3::UnitX();
    look.gloss = 0.05f;
    look.roughness = 0.3f;
    return look;
}

render::Material plankWood(int number) {
    render::Material look = darkWood();
    look.outside = (0.8f + 0.1f * float(number * 7 % 5)) * Vec3(0.30f, 0.19f, 0.11f);
    look.pattern_size = 0.5f + 0.03f * float(number * 3 % 7);
    return look;
}

render::Material groundStone() {
    return matt({0.24f, 0.26f, 0.21f}, {0.3f, 0.3f, 0.3f}, Pattern::stone, 0.9f);
}

render::Material windowGlass() {
    render::Material look = matt({0.25f, 0.45f, 0.40f}, {0.55f, 0.75f, 0.70f}, Pattern::plain, 0.5f);
    look.gloss = 0.3f;
    look.roughness = 0.05f;
    look.clear = 0.94f;
    look.bent = 0.3f;
    return look;
}

render::Material rawPlaster() {
    return matt({0.66f, 0.47f, 0.33f}, {0.88f, 0.84f, 0.78f}, Pattern::plaster, 0.45f);
}

render::Material redBall() {
    render::Material look = matt({0.62f, 0.05f, 0.03f}, {0.6f, 0.1f, 0.1f}, Pattern::plain, 0.1f);
    look.gloss = 0.12f;
    look.roughness = 0.15f;
    return look;
}

render::Material glaze(int number) {
    static const std::array<Vec3, 5> colours = {Vec3(0.03f, 0.17f, 0.24f), Vec3(0.62f, 0.55f, 0.42f),
                                                Vec3(0.55f, 0.20f, 0.06f), Vec3(0.70f, 0.68f, 0.62f),
                                                Vec3(0.10f, 0.24f, 0.11f)};
    const Vec3& colour = colours[std::size_t(number) % colours.size()];
    const bool is_light = colour.minCoeff() > 0.3f;
    render::Material look = matt(colour, is_light ? Vec3(0.70f, 0.36f, 0.22f) : Vec3(0.86f, 0.78f, 0.66f),
                                 is_light ? Pattern::speckle : Pattern::plain, 0.13f);
    look.gloss = 0.12f;
    look.roughness = 0.12f;
    return look;
}

render::Light daylight() {
    render::Light light;
    light.towards = Vec3(0.2f, 0.62f, -0.72f).normalized();
    light.sky = Vec3(0.50f, 0.68f, 0.92f);
    light.horizon = Vec3(0.50f, 0.52f, 0.53f);
    light.ground = Vec3(0.24f, 0.22f, 0.19f);
    light.sun = Vec3(3.4f, 2.95f, 2.3f);
    light.softness = 0.003f;
    return light;
}

}  // namespace prototype
