#include "viewer/scene_frame.h"

#include <algorithm>
#include <vector>

#include "render/projection.h"
#include "viewer/conversions.h"
#include "viewer/looks.h"

namespace demo {
namespace {

/// Bodies that one looks into: only their shape is left.
render::Material seeThrough(const render::Material& opaque) {
    render::Material material = opaque;
    material.pattern = render::Pattern::plain;
    material.outside = render::Vec3(0.8f, 0.85f, 0.9f);
    material.inside = render::Vec3::Constant(0.3f);
    material.clear = 0.97f;
    material.bent = 0;
    return material;
}

}  // namespace

void SceneFrame::begin(Simulation& simulation) {
    bounds_ = render::Bounds();
    body_size_m_ = 0;
    sherd::FractureWorld& fracture = simulation.placed().fracture();
    for (const btRigidBody* body : fracture.bodies()) {
        const render::Mat4 place = toRender(fracture.renderTransform(body));
        render::Bounds own;
        for (const sherd::Vec3& vertex : fracture.asset(body)->surface().vertices) {
            own.add(vertex.cast<float>());
            bounds_.add(render::transformed(place, vertex.cast<float>()));
        }
        body_size_m_ = std::max(body_size_m_, own.radius());
    }
}

render::Frame SceneFrame::make(Simulation& simulation, const Overlays& overlays, const BlowStress* stress) {
    render::Frame frame;
    render::Item ground;
    ground.mesh = &ground_;
    ground.material = floorStone(1.2f * std::max(bounds_.radius(), 0.05f));
    ground.is_ground = true;
    frame.items.push_back(ground);
    addBodies(frame, simulation.placed(), overlays);
    addBalls(frame, simulation.placed());
    frame.marks = overlayMarks(overlays, simulation, stress);
    frame.marks_through = overlays.contacts;
    meshes_.endFrame();
    return frame;
}

void SceneFrame::addBodies(render::Frame& frame, PlacedScene& scene, const Overlays& overlays) {
    int number = 0;
    sherd::FractureWorld& fracture = scene.fracture();
    for (const btRigidBody* body : fracture.bodies()) {
        const sherd::BreakableAsset& asset = *fracture.asset(body);
        render::Item item;
        item.mesh = &meshes_.of(asset);
        item.place = toRender(fracture.renderTransform(body));
        item.material = renderMaterial(asset, scene.lookOf(*body), body_size_m_);
        if (overlays.seeThrough()) item.material = seeThrough(item.material);
        if (overlays.coloured_pieces) {
            item.material.outside = pieceColour(number);
            item.material.inside = 0.8f * pieceColour(number) + render::Vec3::Constant(0.15f);
            item.material.pattern = render::Pattern::plain;
            if (!overlays.seeThrough()) item.material.clear = 0;
        }
        ++number;
        frame.items.push_back(item);
    }
}

void SceneFrame::addBalls(render::Frame& frame, const PlacedScene& scene) {
    for (const PlacedBall& ball : scene.balls()) {
        btTransform place;
        ball.body->getMotionState()->getWorldTransform(place);
        render::Item item;
        item.mesh = &ball_;
        item.place = toRender(place);
        item.place.block<3, 3>(0, 0) *= float(ball.diameter_m / 2);
        item.material = steel();
        frame.items.push_back(item);
    }
}

render::Vec3 medianPlace(Simulation& simulation) {
    render::Vec3 median = render::Vec3::Zero();
    const std::vector<btRigidBody*> bodies = simulation.placed().fracture().bodies();
    for (int axis = 0; axis < 3 && !bodies.empty(); ++axis) {
        std::vector<float> values;
        for (const btRigidBody* body : bodies) values.push_back(body->getWorldTransform().getOrigin()[axis]);
        const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        median[axis] = *middle;
    }
    return median;
}

float spread(Simulation& simulation, const render::Vec3& middle) {
    constexpr double most = 0.7;
    std::vector<float> distances;
    for (const btRigidBody* body : simulation.placed().fracture().bodies())
        distances.push_back((toRender(body->getWorldTransform().getOrigin()) - middle).norm());
    if (distances.empty()) return 0;
    const auto last = distances.begin() + std::ptrdiff_t(most * double(distances.size() - 1));
    std::nth_element(distances.begin(), last, distances.end());
    return *last;
}

}  // namespace demo
