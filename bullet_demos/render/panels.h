#pragma once

#include <imgui.h>

#include "render/context.h"
#include "render/target.h"

namespace render {

/// Dear ImGui over the picture, in a window or off the screen.
class Panels {
  public:
    explicit Panels(Context& context);
    ~Panels();
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;

    void begin(float seconds);  ///< since the last frame; panels may be described from here
    void draw(const Target& target);

  private:
    Context& context_;
};

}  // namespace render
