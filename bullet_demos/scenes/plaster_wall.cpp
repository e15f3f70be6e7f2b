#include "scene.h"

namespace demo {

Scene plasterWall() {
    BreakableBody wall;
    wall.shape = Box{Vec3(1, 0.09, 1), 0.0225};
    wall.material = sherd::Material::plaster();
    wall.settings.sampling.spacing_m = 0.045;  // the paper's 22 x 22 x 2 particles
    wall.look = {Vec3(0.60, 0.42, 0.28), Vec3(0.88, 0.84, 0.78), 0};

    Ball ball;
    ball.position = Vec3(0, -0.165, 0.5);  // 2 cm before the wall: it hits the middle before gravity counts
    ball.velocity = Vec3(0, 8, 0);

    Scene scene;
    scene.name = "plaster_wall";
    scene.summary = "a steel ball at 8 m/s strikes the middle of a plaster wall that stands free";
    scene.bodies = {wall};
    scene.balls = {ball};
    scene.camera = {Vec3(0.55, 1, -0.35), 34};
    return scene;
}

}  // namespace demo
