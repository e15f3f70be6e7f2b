#pragma once

#include <cstdint>
#include <memory>

#include "render/camera.h"
#include "render/frame.h"
#include "render/shadow_pass.h"
#include "render/surface_pass.h"
#include "render/target.h"

namespace render {

/// Draws frames: shadows of the sun from one map, ambient light that corners get less of, glass last, marks,
/// and all of it bent to the colours of a screen. Needs a current context of OpenGL 3.3.
class Renderer {
  public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// `samples` a pixel smooth the edges; 0: none.
    void draw(const Frame& frame, const OrbitCamera& camera, Size size, int samples = 4);

    /// The last frame; what else is to be seen over it may be drawn there.
    const Target& picture() const { return *picture_; }

  private:
    void resize(Size size, int samples);
    void drawBackground(const Frame& frame, const View& view) const;
    void darkenCorners(const View& view) const;
    void drawMarks(const Frame& frame, const View& view) const;
    void drawPuffs(const Frame& frame) const;
    void drawScreen() const;

    ShadowPass shadows_;
    SurfacePass surfaces_;
    Program background_{"screen.vert", "background.frag"}, occlusion_{"screen.vert", "occlusion.frag"},
        tone_{"screen.vert", "tone.frag"}, mark_{"marks.vert", "marks.frag"};
    MarkBuffer mark_buffer_;
    std::unique_ptr<Target> light_, flat_light_, picture_;
    int samples_ = 0;
    std::uint32_t no_buffer_ = 0;  ///< of what is drawn without one; a core context asks for it
};

}  // namespace render
