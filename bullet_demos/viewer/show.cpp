#include "viewer/show.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demo {
namespace {

/// Balls that suit the bodies: those of the scene, or a fifth of the body.
double ballDiameter(const Scene& scene, float body_radius_m) {
    return scene.balls.empty() ? std::clamp(0.4 * double(body_radius_m), 0.01, 0.4)
                               : scene.balls.front().diameter_m;
}

}  // namespace

void Show::begin(Loaded loaded, ViewerState& state, render::OrbitCamera& camera, float aspect) {
    simulation_.reset();
    loaded_ = std::move(loaded);
    restart(state, camera);
    if (state.throwing.ball_diameter_m <= 0)
        state.throwing.ball_diameter_m = ballDiameter(loaded_->scene, scene_frame_.bounds().radius());
    frameView(camera, aspect);
}

void Show::restart(ViewerState& state, render::OrbitCamera& camera) {
    if (distance_before_break_) camera.zoom(*distance_before_break_ / camera.distance());
    distance_before_break_.reset();
    simulation_.reset();
    Scene scene = loaded_->scene;
    chooseFracture(scene, state.choices);
    if (!state.choices.isScene()) scene.bodies.front().position.z() = state.choices.own_mesh.drop_height_m;
    simulation_ = std::make_unique<Simulation>(scene, loaded_->assets);
    simulation_->setBudget(state.budget);
    scene_frame_.begin(*simulation_);
    stress_view_ = std::make_unique<StressView>();
    at_rest_.reset();
    if (!loaded_->assets.bodies.empty())
        at_rest_ = SeenBlow{sherd::BlowEvent(loaded_->assets.bodies.front()), {}, 0};
}

void Show::frameView(render::OrbitCamera& camera, float aspect) const {
    render::Bounds bounds = scene_frame_.bounds();
    const render::Vec3 margin = render::Vec3::Constant(0.25f * bounds.radius());
    bounds.add(bounds.lo - margin);
    bounds.add(bounds.hi + margin);
    camera.frame(bounds, simulation_->scene().camera.towards.cast<float>(), aspect);
}

const BlowStress* Show::stress(const Overlays& overlays, bool wait) {
    if (overlays.particles == ParticleColour::hidden || !simulation_) return nullptr;
    const auto& blow = simulation_->lastBlow() ? simulation_->lastBlow() : at_rest_;
    if (blow) stress_view_->want(*blow);
    if (wait) {
        stress_view_->wait();
        if (blow) stress_view_->want(*blow);  // an older one may have been under way
        stress_view_->wait();
    }
    const auto& newest = stress_view_->newest();
    return newest ? &*newest : nullptr;
}

void Show::followBodies(render::OrbitCamera& camera, float seconds) {
    constexpr double while_pieces_part_s = 1;
    const render::Vec3 middle = medianPlace(*simulation_);
    camera.moveTarget((1 - std::exp(-30 * seconds)) * (middle - camera.target()));
    if (simulation_->secondsSinceBreak() > while_pieces_part_s) return;
    const float needed =
        camera.distanceFor(spread(*simulation_, middle) + 0.6f * scene_frame_.bounds().radius());
    if (needed <= camera.distance()) return;
    if (!distance_before_break_) distance_before_break_ = camera.distance();
    camera.zoom(std::pow(needed / camera.distance(), 1 - std::exp(-3 * seconds)));
}

render::Frame Show::frame(const Overlays& overlays, const BlowStress* stress) {
    return scene_frame_.make(*simulation_, overlays, stress);
}

}  // namespace demo
