#include "render/surface_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace render {

namespace {
constexpr int shadow_unit = 0, behind_unit = 1;
}

bool hasClearItems(const Frame& frame) {
    return std::any_of(frame.items.begin(), frame.items.end(),
                       [](const Item& item) { return item.material.clear > 0; });
}

void SurfacePass::use(const Frame& frame, const View& view, const ShadowPass& shadows) const {
    program_.use();
    setLight(program_, frame.light);
    program_.set("view_projection", view.view_projection);
    program_.set("to_shadow", shadows.toShadow());
    program_.set("eye", view.eye);
    program_.set("shadow_softness", frame.light.softness);
    shadows.bindDepth(shadow_unit);
    program_.set("shadow_map", shadow_unit);
    program_.set("behind_map", behind_unit);  // of another kind than the shadow map, so never at its place
}

void SurfacePass::drawItem(const Item& item, const View& view) const {
    const Material& material = item.material;
    program_.set("model", item.place);
    program_.set("outside_colour", material.outside);
    program_.set("inside_colour", material.inside);
    program_.set("gloss", material.gloss);
    program_.set("roughness", material.roughness);
    program_.set("metal", material.metal);
    program_.set("clear", material.clear);
    program_.set("bent", material.bent);
    program_.set("pattern", int(material.pattern));
    program_.set("pattern_size", material.pattern_size);
    program_.set("grain", material.grain);
    program_.set("fog_distance", item.is_ground ? 12 * view.distance : 0.0f);
    item.mesh->draw();
}

void SurfacePass::drawOpaque(const Frame& frame, const View& view, const ShadowPass& shadows) const {
    use(frame, view, shadows);
    for (const Item& item : frame.items)
        if (item.material.clear <= 0) drawItem(item, view);
}

void SurfacePass::drawClear(const Frame& frame, const View& view, const ShadowPass& shadows,
                            const Target& behind) const {
    std::vector<std::pair<float, const Item*>> sorted;  // the furthest first
    for (const Item& item : frame.items)
        if (item.material.clear > 0) sorted.emplace_back((item.bounds().centre() - view.eye).norm(), &item);
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    use(frame, view, shadows);
    behind.bindColour(behind_unit);
    program_.set("picture_right", view.right);
    program_.set("picture_up", view.up);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_SRC1_COLOR);
    glDepthMask(GL_FALSE);
    glEnable(GL_CULL_FACE);
    for (const auto& [distance, item] : sorted)
        for (const GLenum hidden : {GL_FRONT, GL_BACK}) {  // its far side first
            glCullFace(hidden);
            drawItem(*item, view);
        }
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace render
