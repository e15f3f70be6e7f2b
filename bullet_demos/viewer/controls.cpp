#include "viewer/controls.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>

namespace demo {

namespace {
constexpr float still_pixels = 4;  ///< a hand that clicks moves the mouse by less
}

void Controls::apply(ViewerState& state, render::OrbitCamera& camera, Simulation* simulation,
                     render::Context& context) {
    const ImGuiIO& io = ImGui::GetIO();
    const render::Size size = context.size();
    for (const int key : context.takePressedKeys())
        if (!io.WantTextInput) takeKey(state, key);
    if (io.WantCaptureMouse) {
        if (simulation) simulation->drag().letGo();
        moved_ = still_pixels;  // a press on a panel is no throw when it ends beside it
        return;
    }
    turnCamera(state, camera, size);
    const float x = io.MousePos.x / io.DisplaySize.x, y = io.MousePos.y / io.DisplaySize.y;
    if (simulation) throwOrDrag(state, camera.ray(x, y, size.aspect()), *simulation);
}

void Controls::turnCamera(ViewerState& state, render::OrbitCamera& camera, render::Size size) {
    const ImGuiIO& io = ImGui::GetIO();
    const float right = io.MouseDelta.x / float(size.height), down = io.MouseDelta.y / float(size.height);
    // What the mouse moved in a slow frame before the button went down is no drag.
    const bool just_now = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (just_now) moved_ = 0;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left) && !just_now;
    if (left) moved_ += std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y);
    const bool pans = ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyShift);
    if (pans && (right != 0 || down != 0)) {
        camera.pan(-right, down);
        state.follow = false;
    } else if (left && moved_ >= still_pixels) {
        camera.orbit(-4 * right, -4 * down);
    }
    if (io.MouseWheel != 0) camera.zoom(std::pow(0.88f, io.MouseWheel));
}

void Controls::throwOrDrag(ViewerState& state, const render::Ray& ray, Simulation& simulation) {
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && moved_ < still_pixels)
        simulation.throwBall(ray, state.throwing);
    const bool holds = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsKeyDown(GLFW_KEY_G);
    if (!holds) {
        simulation.drag().letGo();
    } else if (simulation.drag().holding()) {
        simulation.drag().moveTo(ray);
    } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) || ImGui::IsKeyPressed(GLFW_KEY_G, false)) {
        simulation.drag().take(ray);
    }
}

void Controls::takeKey(ViewerState& state, int key) {
    if (key == GLFW_KEY_SPACE) state.paused = !state.paused;
    if (key == GLFW_KEY_N) state.step_once = state.paused = true;
    if (key == GLFW_KEY_R) state.restart = true;
    if (key == GLFW_KEY_S) state.speed = state.speed < 1 ? 1.0f : 0.1f;
    if (key == GLFW_KEY_F) state.frame_view = state.follow = true;
    if (key == GLFW_KEY_H) state.panels = !state.panels;
    if (key == GLFW_KEY_P) state.screenshot = true;
    if (key == GLFW_KEY_V) state.recording = !state.recording;
    if (key == GLFW_KEY_C) state.overlays.coloured_pieces = !state.overlays.coloured_pieces;
}

}  // namespace demo
