#include "example_browser/knobs.h"

#include <CommonInterfaces/CommonGUIHelperInterface.h>
#include <CommonInterfaces/CommonParameterInterface.h>

#include <cmath>

#include "scenes/scene_file.h"

namespace demo {
namespace {

void registerSlider(CommonParameterInterface& panel, const char* name, btScalar& value, float lowest,
                    float highest, bool is_whole = false) {
    SliderParams slider(name, &value);
    slider.m_minVal = lowest;
    slider.m_maxVal = highest;
    slider.m_clampToIntegers = is_whole;
    panel.registerSliderFloatParameter(slider);
}

}  // namespace

Knobs knobsOf(const Scene& scene) {
    Knobs knobs;
    if (!scene.balls.empty()) knobs.ball_speed_m_s = btScalar(scene.balls.front().velocity.norm());
    return knobs;
}

void registerSliders(GUIHelperInterface& helper, Knobs& knobs) {
    CommonParameterInterface* panel = helper.getParameterInterface();
    if (!panel) return;
    registerSlider(*panel, "strength, %", knobs.strength_percent, 10, 400);
    registerSlider(*panel, "fragments (0: by energy)", knobs.fragments, 0, 36, true);
    registerSlider(*panel, "ball speed, m/s", knobs.ball_speed_m_s, 1, 60);
    registerSlider(*panel, "quality (0: preview, 2: film)", knobs.quality, 0, 2, true);
}

sherd::Result<Scene> sceneWith(const std::string& file, const Knobs& knobs) {
    std::vector<std::string> changes;
    if (knobs.quality < 0.5f) changes = {"bodies[*].settings.quality=preview"};
    if (knobs.quality > 1.5f) changes = {"bodies[*].settings.quality=film"};
    auto scene = readScene(file, "", changes);
    if (!scene) return scene;
    for (BreakableBody& body : scene.value().bodies) {
        body.material.tensile_strength_pa *= double(knobs.strength_percent) / 100;
        const int fragments = static_cast<int>(std::lround(knobs.fragments));
        if (fragments > 0) body.settings.fracture.fragment_count = fragments;
    }
    for (Ball& ball : scene.value().balls)
        if (ball.velocity.norm() > 0) ball.velocity = knobs.ball_speed_m_s * ball.velocity.normalized();
    return scene;
}

}  // namespace demo
