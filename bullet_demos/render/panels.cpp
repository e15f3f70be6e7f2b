#include "render/panels.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

namespace render {
namespace {

void setLook() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6;
    style.FrameRounding = 4;
    style.GrabRounding = 4;
    style.WindowBorderSize = 0;
    style.ItemSpacing = ImVec2(8, 5);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.10f, 0.11f, 0.86f);
    style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.10f, 0.22f, 0.26f, 1);
    style.Colors[ImGuiCol_PlotHistogram] = ImVec4(0.25f, 0.62f, 0.68f, 1);
}

}  // namespace

Panels::Panels(Context& context) : context_(context) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is written beside the program
    setLook();
    if (context.window()) ImGui_ImplGlfw_InitForOpenGL(context.window(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Panels::~Panels() {
    ImGui_ImplOpenGL3_Shutdown();
    if (context_.window()) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Panels::begin(float seconds) {
    ImGui_ImplOpenGL3_NewFrame();
    if (context_.window()) {
        ImGui_ImplGlfw_NewFrame();
    } else {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = ImVec2(float(context_.size().width), float(context_.size().height));
        io.DeltaTime = seconds;
    }
    ImGui::NewFrame();
}

void Panels::draw(const Target& target) {
    ImGui::Render();
    target.bind();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace render
