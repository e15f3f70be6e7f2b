#include "prototype/picture.h"

#include "prototype/looks.h"
#include "scenes/box_mesh.h"
#include "viewer/conversions.h"

namespace prototype {

Picture::Picture(const Level& level)
    : ball_(render::sphereMesh(Hall::ball_radius)), ground_(render::squareMesh(60)) {
    still_.light = daylight();
    render::Item ground;
    ground.mesh = &ground_;
    ground.material = groundStone();
    ground.is_ground = true;
    still_.items.push_back(ground);
    for (const Block& block : level.blocks) {
        const demo::Box box{block.size.cast<double>(), double(block.size.maxCoeff())};
        blocks_.push_back(std::make_unique<render::Mesh>(demo::toMeshData(demo::boxMesh(box))));
        render::Item item;
        item.mesh = blocks_.back().get();
        item.place.block<3, 1>(0, 3) = block.centre;
        item.material = block.look;
        still_.items.push_back(item);
    }
}

render::OrbitCamera Picture::camera(float aspect) {
    render::OrbitCamera camera;
    render::Bounds hall;
    hall.add({-1.3f, 0.4f, 0.25f});
    hall.add({1.3f, 1.4f, 1.85f});
    camera.frame(hall, {0.0f, 1.0f, -0.13f}, aspect);
    camera.zoom(0.88f);
    return camera;
}

render::Frame Picture::frame(Game& game, const Dust& dust) {
    render::Frame frame = still_;
    addThings(frame, game);
    addBalls(frame, game.hall());
    dust.drawInto(frame.marks);
    meshes_.endFrame();
    return frame;
}

void Picture::addThings(render::Frame& frame, Game& game) {
    const sherd::FractureWorld& fracture = game.fracture();
    for (const btRigidBody* body : fracture.bodies()) {
        const sherd::BreakableAsset* asset = fracture.asset(body);
        if (!asset) continue;
        render::Item item;
        item.mesh = &meshes_.of(*asset);
        item.place = demo::toRender(fracture.renderTransform(body));
        item.material = game.lookOf(*body);
        frame.items.push_back(item);
    }
}

void Picture::addBalls(render::Frame& frame, const Hall& hall) {
    for (const btTransform& place : hall.balls()) {
        render::Item item;
        item.mesh = &ball_;
        item.place = demo::toRender(place);
        item.material = redBall();
        frame.items.push_back(item);
    }
}

}  // namespace prototype
