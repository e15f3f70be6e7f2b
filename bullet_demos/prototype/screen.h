#pragma once

#include <string>
#include <vector>

#include "prototype/picture.h"
#include "render/gl_errors.h"
#include "render/panels.h"
#include "render/renderer.h"

namespace prototype {

/// What the player sees: the picture, and the score over it.
class Screen {
  public:
    explicit Screen(render::Context& context);

    /// Begins a frame; the mouse may be asked from here.
    void begin(float seconds);
    /// Ends it.
    void draw(const render::Frame& frame, const Score& score);
    /// A frame while the level is not ready.
    void drawLoading(float share);
    void writePng(const std::string& file) const;

    /// Through a point of the picture, from (0, 0) at its upper left to (1, 1).
    render::Ray ray(float x, float y) const { return camera_.ray(x, y, context_.size().aspect()); }
    render::OrbitCamera& camera() { return camera_; }
    render::Context& context() { return context_; }
    const std::vector<std::string>& glErrors() const { return errors_.messages(); }

  private:
    void show(const render::Frame& frame);

    render::Context& context_;
    render::GlErrors errors_;
    render::Renderer renderer_;
    render::Panels panels_;
    render::OrbitCamera camera_;
    int samples_;
};

}  // namespace prototype
