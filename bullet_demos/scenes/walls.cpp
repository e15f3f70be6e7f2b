#include "scene.h"

namespace demo {
namespace {

/// The paper's wall of 22 x 22 x 2 particles, standing free, and a steel ball about to strike its middle.
Scene wall(const sherd::Material& material, const Look& look, double ball_speed_m_s) {
    BreakableBody wall;
    wall.shape = Box{Vec3(1, 0.09, 1), 0.0225};
    wall.material = material;
    wall.settings.sampling.spacing_m = 0.045;
    wall.look = look;

    Ball ball;
    ball.position = Vec3(0, -0.165, 0.5);  // 2 cm before the wall: it hits the middle before gravity counts
    ball.velocity = Vec3(0, ball_speed_m_s, 0);

    Scene scene;
    scene.bodies = {wall};
    scene.balls = {ball};
    scene.camera = {Vec3(0.55, 1, -0.35), 34};
    return scene;
}

}  // namespace

Scene plasterWall() {
    Scene scene = wall(sherd::Material::plaster(), {Vec3(0.60, 0.42, 0.28), Vec3(0.88, 0.84, 0.78), 0}, 8);
    scene.name = "plaster_wall";
    scene.summary = "a steel ball at 8 m/s strikes the middle of a plaster wall that stands free";
    return scene;
}

Scene glassWall() {
    Scene scene = wall(sherd::Material::glass(), {Vec3(0.25, 0.45, 0.40), Vec3(0.55, 0.75, 0.70), 0.3}, 30);
    scene.bodies[0].settings.fracture.guide.kind = sherd::GuideField::Kind::radial;
    scene.name = "glass_wall";
    scene.summary = "a steel ball at 30 m/s strikes a glass wall; cracks run away from the blow";
    return scene;
}

Scene woodWall() {
    Scene scene = wall(sherd::Material::wood(), {Vec3(0.42, 0.24, 0.11), Vec3(0.72, 0.54, 0.32), 0}, 20);
    scene.bodies[0].settings.fracture.guide.kind = sherd::GuideField::Kind::constant;
    scene.name = "wood_wall";
    scene.summary = "a steel ball at 20 m/s strikes a wooden wall; cracks run along the upright grain";
    return scene;
}

}  // namespace demo
