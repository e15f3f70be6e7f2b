#include "prototype/play.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "prototype/screen.h"
#include "prototype/sound.h"

namespace prototype {
namespace {

/// Seconds since the last call.
class Stopwatch {
  public:
    float lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<float> passed = now - std::exchange(last_, now);
        return passed.count();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A loading bar, until the level is ready; none: the window was closed.
std::optional<sherd::Result<ReadyLevel>> load(const Arguments& arguments, Screen& screen) {
    Baking baking(arguments.baked);
    bool closed = false;
    while (!baking.done() && !closed) {
        screen.drawLoading(baking.share());
        // Baking takes what time is left.
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        closed = screen.context().closed();
    }
    auto level = baking.take();
    if (closed) return std::nullopt;
    return level;
}

/// Throws where the player clicks, turns the camera while he holds the right button; sets off a bomb where
/// the mouse points. False: he has had enough.
bool obey(const std::vector<int>& keys, Game& game, Screen& screen) {
    const ImGuiIO& io = ImGui::GetIO();
    const float x = io.MousePos.x / io.DisplaySize.x, y = io.MousePos.y / io.DisplaySize.y;
    for (const int key : keys) {
        if (key == GLFW_KEY_ESCAPE) return false;
        if (key == GLFW_KEY_SPACE) game.setOffBomb(screen.ray(x, y));
    }
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) game.throwBall(screen.ray(x, y));
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right))
        screen.camera().orbit(-2 * io.MouseDelta.x / io.DisplaySize.y,
                              -2 * io.MouseDelta.y / io.DisplaySize.y);
    return true;
}

}  // namespace

sherd::Status play(const Arguments& arguments, render::Context& context) {
    Screen screen(context);
    auto level = load(arguments, screen);
    if (!level) return sherd::success();
    if (!*level) return sherd::Error{level->error()};
    Game game(std::move(*level).value());
    Picture picture(game.level());
    Dust dust;
    Sound sound;
    Stopwatch watch;
    while (!context.closed()) {
        const float seconds = std::min(watch.lap(), 0.1f);
        screen.begin(seconds);
        if (!obey(context.takePressedKeys(), game, screen)) break;
        game.advance(seconds);
        sound.listenFrom(screen.camera());
        for (const Happening& happening : game.takeHappenings()) {
            sound.play(happening);
            dust.add(happening);
        }
        dust.advance(seconds);
        screen.draw(picture.frame(game, dust), game.score());
    }
    return sherd::success();
}

}  // namespace prototype
