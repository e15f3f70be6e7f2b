#include "scene.h"

namespace demo {

Scene coffeeCup() {
    BreakableBody cup;
    cup.shape = ObjFile{"coffee_cup.obj"};
    cup.material = sherd::Material::ceramic();
    cup.look = {Vec3(0.03, 0.17, 0.24), Vec3(0.86, 0.78, 0.66), 0.12};
    cup.turn_deg = Vec3(0, 125, 35);
    cup.position = Vec3(0, 0, 1);

    Scene scene;
    scene.name = "coffee_cup";
    scene.summary = "a stoneware cup falls from 1 m onto a stone floor";
    scene.bodies = {cup};
    scene.camera = {Vec3(0.25, 1, -0.55), 32};
    return scene;
}

}  // namespace demo
