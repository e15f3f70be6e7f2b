#include "viewer/looks.h"

namespace demo {
namespace {

using render::Pattern;

Pattern patternOf(const std::string& material, const Look& look) {
    constexpr double light_glaze = 0.3;
    if (material == "wood") return Pattern::wood;
    if (material == "ceramic" && look.outside.minCoeff() > light_glaze) return Pattern::speckle;
    return look.gloss > 0 ? Pattern::plain : Pattern::plaster;
}

}  // namespace

render::Material renderMaterial(const sherd::BreakableAsset& asset, const Look& look, float size_m) {
    render::Material material;
    material.outside = look.outside.cast<float>();
    material.inside = look.crack.cast<float>();
    material.gloss = float(look.gloss);
    material.roughness = 0.12f;
    material.pattern = patternOf(asset.material().name, look);
    material.pattern_size = size_m;
    const sherd::GuideField& guide = asset.settings().fracture.guide;
    if (guide.kind == sherd::GuideField::Kind::constant) material.grain = guide.direction.cast<float>();
    if (asset.material().name == "wood") material.pattern_size = 0.35f * size_m;
    if (isClear(asset.material())) {
        material.pattern = Pattern::plain;
        material.clear = 0.94f;
        material.bent = 0.55f;
    }
    return material;
}

render::Material steel() {
    render::Material material;
    material.outside = {0.56f, 0.57f, 0.60f};
    material.metal = 1;
    material.roughness = 0.15f;
    return material;
}

render::Material floorStone(float size_m) {
    render::Material material;
    material.outside = {0.235f, 0.23f, 0.225f};
    material.pattern = Pattern::stone;
    material.pattern_size = size_m;
    return material;
}

}  // namespace demo
