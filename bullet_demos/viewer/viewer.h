#pragma once

#include <memory>
#include <string>

#include "render/gl_errors.h"
#include "render/panels.h"
#include "render/renderer.h"
#include "viewer/arguments.h"
#include "viewer/controls.h"
#include "viewer/show.h"

namespace demo {

/// The window: loads, steps and draws what its state asks for, until it is closed.
class Viewer {
  public:
    Viewer(const ViewArguments& arguments, render::Context& context);
    void run();
    const render::GlErrors& errors() const { return errors_; }

  private:
    void drawFrame(float seconds);
    void load();
    void takeLoaded();
    void simulate(float seconds);
    void drawPanels(const BlowStress* stress);
    void obeyWishes();
    void writePictures();
    bool waiting() const { return loading_ || preparing_; }

    const ViewArguments& arguments_;
    render::Context& context_;
    const int samples_;
    render::GlErrors errors_;
    render::Renderer renderer_;
    render::Panels panels_;
    render::OrbitCamera camera_;
    ViewerState state_;
    Controls controls_;
    Show show_;
    std::unique_ptr<Loading> loading_;
    std::unique_ptr<Preparation> preparation_;
    bool preparing_ = false;  ///< the user waits for it
    int pictures_ = 0, frames_ = 0;
};

}  // namespace demo
