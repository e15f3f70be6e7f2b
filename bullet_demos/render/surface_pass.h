#pragma once

#include "render/frame.h"
#include "render/shadow_pass.h"
#include "render/target.h"

namespace render {

/// Draws the surfaces of a frame to the target that is bound.
class SurfacePass {
  public:
    void drawOpaque(const Frame& frame, const View& view, const ShadowPass& shadows) const;
    /// What is clear, the furthest first; `behind` is the picture without it.
    void drawClear(const Frame& frame, const View& view, const ShadowPass& shadows,
                   const Target& behind) const;

  private:
    void use(const Frame& frame, const View& view, const ShadowPass& shadows) const;
    void drawItem(const Item& item, const View& view) const;

    Program program_{"surface.vert", "surface.frag"};
};

bool hasClearItems(const Frame& frame);

}  // namespace render
