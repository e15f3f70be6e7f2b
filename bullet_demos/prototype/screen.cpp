#include "prototype/screen.h"

#include "prototype/looks.h"
#include "render/picture.h"

namespace prototype {
namespace {

constexpr ImGuiWindowFlags plain_window =
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoInputs;

void describeScore(const Score& score) {
    ImGui::SetNextWindowPos(ImVec2(16, 16));
    ImGui::Begin("##score", nullptr, plain_window);
    ImGui::SetWindowFontScale(2);
    ImGui::Text("%d points", score.points);
    ImGui::SetWindowFontScale(1);
    ImGui::Text("%d things broken, %.1f kg, in %d pieces", score.breaks, score.broken_kg, score.pieces);
    ImGui::TextDisabled("click: throw    Space: bomb    right button: look around    Esc: leave");
    ImGui::End();
}

}  // namespace

Screen::Screen(render::Context& context)
    : context_(context),
      panels_(context),
      camera_(Picture::camera(context.size().aspect())),
      samples_(context.window() && render::isSoftware() ? 0 : 4) {}

void Screen::begin(float seconds) {
    panels_.begin(seconds);
}

void Screen::draw(const render::Frame& frame, const Score& score) {
    describeScore(score);
    show(frame);
}

void Screen::drawLoading(float share) {
    begin(0.03f);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(window.x / 2, window.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin("##loading", nullptr, plain_window);
    ImGui::TextUnformatted("Preparing what breaks; the next start is at once.");
    ImGui::ProgressBar(share, ImVec2(360, 0));
    ImGui::End();
    render::Frame empty;
    empty.light = daylight();
    show(empty);
}

void Screen::show(const render::Frame& frame) {
    const render::Size size = context_.size();
    if (size.width <= 0 || size.height <= 0) {  // an iconified window
        ImGui::EndFrame();
        return;
    }
    renderer_.draw(frame, camera_, size, samples_);
    panels_.draw(renderer_.picture());
    if (context_.window()) renderer_.picture().copyToWindow(size);
    errors_.check();
    context_.show();
}

void Screen::writePng(const std::string& file) const {
    render::writePng(render::readBack(renderer_.picture()), file);
}

}  // namespace prototype
