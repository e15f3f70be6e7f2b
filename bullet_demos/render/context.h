#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/types.h"

struct GLFWwindow;

namespace render {

/// A context of OpenGL 3.3 core, current on this thread, with or without a window.
class Context {
  public:
    /// A window. Throws Failure where there is no display, or no such OpenGL.
    static std::unique_ptr<Context> inWindow(Size size, const std::string& title);
    /// No window and no display: what is drawn is read back. Throws Failure where the driver has no such
    /// thing.
    static std::unique_ptr<Context> offScreen(Size size);

    virtual ~Context() = default;
    virtual Size size() const = 0;           ///< of the picture, pixels
    virtual GLFWwindow* window() const = 0;  ///< nullptr without a window
    virtual bool closed() = 0;               ///< takes what the user did; true: the window is to be closed
    /// Keys of GLFW that were pressed since the last call, also those that were let go of within a slow
    /// frame.
    virtual std::vector<int> takePressedKeys() { return {}; }
    virtual void show() = 0;  ///< what was drawn to the window
};

/// What OpenGL calls itself and its driver.
std::string contextDescription();
/// Whether the driver does without a graphics card, and takes a tenth of a second and more for a frame.
bool isSoftware();

}  // namespace render
