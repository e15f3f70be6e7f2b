#pragma once

#include <memory>
#include <vector>

#include "prototype/dust.h"
#include "prototype/game.h"
#include "render/frame.h"
#include "viewer/body_meshes.h"

namespace prototype {

/// What is to be drawn of a game.
class Picture {
  public:
    explicit Picture(const Level& level);

    render::Frame frame(Game& game, const Dust& dust);

    /// From where the player looks.
    static render::OrbitCamera camera(float aspect);

  private:
    void addThings(render::Frame& frame, Game& game);
    void addBalls(render::Frame& frame, const Hall& hall);

    demo::BodyMeshes meshes_;
    render::Mesh ball_, ground_;
    std::vector<std::unique_ptr<render::Mesh>> blocks_;
    render::Frame still_;  ///< what never moves
};

}  // namespace prototype
