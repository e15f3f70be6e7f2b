#include "viewer/scripted.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <utility>

#include "render/gl_errors.h"
#include "render/panels.h"
#include "render/picture.h"
#include "render/renderer.h"
#include "viewer/blow_panel.h"
#include "viewer/notices.h"
#include "viewer/scene_panel.h"
#include "viewer/show.h"

namespace demo {
namespace {

/// A run without hands.
class ScriptedRun {
  public:
    ScriptedRun(const ViewArguments& arguments, render::Context& context, Loaded loaded)
        : arguments_(arguments),
          script_(arguments.script),
          context_(context),
          panels_(context),
          state_(arguments.state) {
        state_.said = loaded.said;
        show_.begin(std::move(loaded), state_, camera_, size().aspect());
        camera_.zoom(arguments.zoom);
    }

    void run() {
        for (int step = 1; step <= script_.steps; ++step) {
            for (const PlannedThrow& planned : script_.throws)
                if (planned.step == step) show_.simulation()->throwBall(rayOf(planned), state_.throwing);
            show_.simulation()->stepOnce();
            show_.followBodies(camera_, float(show_.simulation()->scene().time_step_s));
            if (!script_.frames.empty() && step % script_.steps_per_frame == 0)
                draw(frameFile(step / script_.steps_per_frame));
        }
        draw(script_.screenshot);
    }

    /// What came of it, as a sentence.
    std::string summary() {
        Simulation& simulation = *show_.simulation();
        const std::string failed = simulation.failures() == 0 ? ""
                                                              : std::to_string(simulation.failures()) +
                                                                    " blows that could not be decided (" +
                                                                    simulation.firstFailure() + "), ";
        return std::to_string(simulation.steps()) + " steps, " + std::to_string(simulation.breaks()) +
               " breaks, " + failed + std::to_string(simulation.placed().fracture().bodies().size()) +
               " bodies, " + std::to_string(errors_.messages().size()) + " OpenGL errors; " +
               render::contextDescription();
    }
    const std::vector<std::string>& glErrors() const { return errors_.messages(); }

  private:
    render::Size size() const { return context_.size(); }

    render::Ray rayOf(const PlannedThrow& planned) {
        if (!planned.at_body) return camera_.ray(planned.at.x(), planned.at.y(), size().aspect());
        const render::Vec3 towards = medianPlace(*show_.simulation()) - camera_.eye();
        return {camera_.eye(), towards.normalized()};
    }

    std::string frameFile(int number) const {
        char name[24];
        std::snprintf(name, sizeof name, "%05d.png", number);
        return (std::filesystem::path(script_.frames) / name).string();
    }

    /// Draws, and writes the picture where `file` is not empty.
    void draw(const std::string& file) {
        const BlowStress* stress = show_.stress(state_.overlays, true);
        renderer_.draw(show_.frame(state_.overlays, stress), camera_, size(), arguments_.samples.value_or(4));
        drawPanels(stress);
        errors_.check();
        if (context_.window()) renderer_.picture().copyToWindow(size());
        context_.show();
        if (!file.empty()) render::writePng(render::readBack(renderer_.picture()), file);
    }

    void drawPanels(const BlowStress* stress) {
        // Twice: panels that fit their contents are not shown before these are known.
        for (int times = 0; times < 2; ++times) {
            panels_.begin(1.0f / 60);
            if (script_.panels) {
                drawScenePanel(state_, arguments_.scene_files);
                drawBlowPanel(*show_.simulation(), size());
                drawNotices(state_, size());
            }
            if (stress) drawColourBar(*stress, state_.overlays.particles, size());
            panels_.draw(renderer_.picture());
        }
    }

    const ViewArguments& arguments_;
    const Script& script_;
    render::Context& context_;
    render::GlErrors errors_;
    render::Renderer renderer_;
    render::Panels panels_;
    render::OrbitCamera camera_;
    ViewerState state_;
    Show show_;
};

}  // namespace

sherd::Status runScript(const ViewArguments& arguments, render::Context& context) {
    auto loaded = load(arguments.state.choices, arguments.meshes);
    if (!loaded) return sherd::Error{loaded.error()};
    for (const std::string& sentence : loaded.value().said) std::cerr << sentence << "\n";
    if (!arguments.script.frames.empty()) std::filesystem::create_directories(arguments.script.frames);
    ScriptedRun run(arguments, context, std::move(loaded).value());
    run.run();
    std::cout << run.summary() << std::endl;
    if (run.glErrors().empty()) return sherd::success();
    std::string sentence = "OpenGL reported errors:";
    for (const std::string& message : run.glErrors()) sentence += "\n  " + message;
    return sherd::Error{sentence};
}

}  // namespace demo
