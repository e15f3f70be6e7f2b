#include "viewer/viewer.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <thread>
#include <utility>

#include "render/picture.h"
#include "viewer/blow_panel.h"
#include "viewer/notices.h"
#include "viewer/scene_panel.h"

namespace demo {

Viewer::Viewer(const ViewArguments& arguments, render::Context& context)
    : arguments_(arguments),
      context_(context),
      samples_(arguments.samples.value_or(render::isSoftware() ? 0 : 4)),
      panels_(context),
      state_(arguments.state) {
    load();
}

void Viewer::run() {
    auto last = std::chrono::steady_clock::now();
    while (!context_.closed()) {
        const auto now = std::chrono::steady_clock::now();
        const float seconds = std::chrono::duration<float>(now - last).count();
        last = now;
        if (context_.size().width > 0 && context_.size().height > 0) drawFrame(seconds);
        // Preparation takes what time is left, and a driver without a graphics card takes all there is.
        if (waiting()) std::this_thread::sleep_for(std::chrono::milliseconds(60));
    }
}

void Viewer::drawFrame(float seconds) {
    const render::Size size = context_.size();
    takeLoaded();
    panels_.begin(seconds);
    controls_.apply(state_, camera_, show_.simulation(), context_);
    simulate(seconds);
    const BlowStress* stress = show_.stress(state_.overlays, false);
    const render::Frame frame = show_.simulation() ? show_.frame(state_.overlays, stress) : render::Frame();
    renderer_.draw(frame, camera_, size, samples_);
    writePictures();
    drawPanels(stress);
    panels_.draw(renderer_.picture());
    renderer_.picture().copyToWindow(size);
    errors_.check();
    context_.show();
    obeyWishes();
}

void Viewer::load() {
    state_.said.clear();
    state_.throwing.ball_diameter_m = show_.simulation() ? 0 : arguments_.state.throwing.ball_diameter_m;
    loading_ = std::make_unique<Loading>(state_.choices, arguments_.meshes);
}

void Viewer::takeLoaded() {
    if (loading_ && loading_->done()) {
        auto loaded = loading_->take();
        loading_.reset();
        if (!loaded) {
            std::cerr << loaded.error() << "\n";
            state_.said = {loaded.error()};
        } else {
            state_.said = loaded.value().said;
            for (const std::string& sentence : state_.said) std::cerr << sentence << "\n";
            show_.begin(std::move(loaded).value(), state_, camera_, context_.size().aspect());
            preparation_ = arguments_.prepare ? std::make_unique<Preparation>(show_.assets()) : nullptr;
            preparing_ = preparation_ != nullptr;
        }
    }
    if (state_.start_now || (preparation_ && preparation_->done())) preparing_ = false;
    state_.start_now = false;
}

void Viewer::simulate(float seconds) {
    Simulation* simulation = show_.simulation();
    if (!simulation || waiting()) return;
    if (std::exchange(state_.step_once, false)) simulation->stepOnce();
    // After a long frame the world goes on from where it was.
    constexpr float longest_frame_s = 1.0f / 20;
    if (!state_.paused) simulation->advance(double(state_.speed * std::min(seconds, longest_frame_s)));
    if (state_.follow) show_.followBodies(camera_, seconds);
}

void Viewer::drawPanels(const BlowStress* stress) {
    // Not the picture's where the system scales windows.
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const render::Size size{int(window.x), int(window.y)};
    if (loading_) drawProgress(state_, "reading and sampling", -1, false, size);
    if (preparing_)
        drawProgress(state_, "preparing, so that blows take milliseconds", preparation_->share(), true, size);
    if (!state_.panels) return;
    const BudgetChoice budget = state_.budget;
    drawScenePanel(state_, arguments_.scene_files);
    drawNotices(state_, size);
    if (!show_.simulation()) return;
    if (budget != state_.budget) show_.simulation()->setBudget(state_.budget);
    drawBlowPanel(*show_.simulation(), size);
    if (stress) drawColourBar(*stress, state_.overlays.particles, size);
}

void Viewer::obeyWishes() {
    const bool idle = !loading_;
    if (idle && std::exchange(state_.reload, false))
        load();
    else if (idle && std::exchange(state_.restart, false) && show_.simulation())
        show_.restart(state_, camera_);
    if (std::exchange(state_.frame_view, false) && show_.simulation())
        show_.frameView(camera_, context_.size().aspect());
}

void Viewer::writePictures() {
    namespace fs = std::filesystem;
    const bool wanted = std::exchange(state_.screenshot, false);
    if (!wanted && !state_.recording) return;
    char name[40];
    std::snprintf(name, sizeof name, state_.recording ? "frames/%05d.png" : "view_%03d.png",
                  state_.recording ? ++frames_ : ++pictures_);
    const fs::path file = fs::path(arguments_.pictures) / name;
    try {
        fs::create_directories(file.parent_path());
        render::writePng(render::readBack(renderer_.picture()), file.string());
        state_.notice = "written: " + file.string();
    } catch (const std::exception& failure) {
        state_.recording = false;
        state_.notice = failure.what();
    }
}

}  // namespace demo
