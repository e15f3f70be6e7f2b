#pragma once

#include <memory>
#include <optional>

#include "viewer/loading.h"
#include "viewer/scene_frame.h"
#include "viewer/state.h"
#include "viewer/stress_view.h"

namespace demo {

/// What is loaded, its simulation, and what is drawn of it. Knows no window: the viewer with hands and the
/// one without share it.
class Show {
  public:
    /// Takes over what was loaded and starts it.
    void begin(Loaded loaded, ViewerState& state, render::OrbitCamera& camera, float aspect);
    /// The same scene from its start, from as near as before pieces flew apart.
    void restart(ViewerState& state, render::OrbitCamera& camera);
    void frameView(render::OrbitCamera& camera, float aspect) const;

    Simulation* simulation() { return simulation_.get(); }
    const SceneAssets& assets() const { return loaded_->assets; }
    /// The particles of the last blow, or of the first body before there is one; may still be missing.
    const BlowStress* stress(const Overlays& overlays, bool wait);
    void followBodies(render::OrbitCamera& camera, float seconds);
    render::Frame frame(const Overlays& overlays, const BlowStress* stress);

  private:
    std::optional<Loaded> loaded_;
    std::unique_ptr<Simulation> simulation_;
    SceneFrame scene_frame_;
    std::unique_ptr<StressView> stress_view_ = std::make_unique<StressView>();
    std::optional<SeenBlow> at_rest_;
    std::optional<float> distance_before_break_;
};

}  // namespace demo
