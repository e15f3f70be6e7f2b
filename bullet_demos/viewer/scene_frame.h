#pragma once

#include "render/renderer.h"
#include "viewer/body_meshes.h"
#include "viewer/overlays.h"

namespace demo {

/// Makes render::Frame of a simulation: the ground, bodies, balls and overlays.
class SceneFrame {
  public:
    /// The extent of the bodies; they and the ground are drawn with patterns that fit.
    void begin(Simulation& simulation);
    render::Frame make(Simulation& simulation, const Overlays& overlays, const BlowStress* stress);

    /// Around the bodies as they were at the start.
    const render::Bounds& bounds() const { return bounds_; }

  private:
    void addBodies(render::Frame& frame, PlacedScene& scene, const Overlays& overlays);
    void addBalls(render::Frame& frame, const PlacedScene& scene);

    BodyMeshes meshes_;
    render::Mesh ground_{render::squareMesh(20)}, ball_{render::sphereMesh(1)};  ///< 20 m: as PlacedScene's
    render::Bounds bounds_;
    float body_size_m_ = 1;
};

/// The middle of where bodies are, whatever flies far away.
render::Vec3 medianPlace(Simulation& simulation);

/// How far most bodies are from there at most.
float spread(Simulation& simulation, const render::Vec3& middle);

}  // namespace demo
