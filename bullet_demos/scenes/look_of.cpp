#include "scenes/scene.h"

namespace demo {

Look lookOf(const sherd::Material& material) {
    const std::string& name = material.name;
    if (name == "ceramic") return {{0.62, 0.55, 0.42}, {0.70, 0.36, 0.22}, 0.12};
    if (name == "glass") return {{0.25, 0.45, 0.40}, {0.55, 0.75, 0.70}, 0.3};
    if (name == "ice") return {{0.45, 0.60, 0.68}, {0.80, 0.90, 0.95}, 0.3};
    if (name == "wood") return {{0.42, 0.24, 0.11}, {0.72, 0.54, 0.32}, 0};
    if (name == "brick") return {{0.45, 0.14, 0.08}, {0.60, 0.25, 0.16}, 0};
    if (name == "concrete") return {{0.42, 0.41, 0.39}, {0.55, 0.54, 0.51}, 0};
    if (name == "stone") return {{0.55, 0.50, 0.41}, {0.72, 0.68, 0.58}, 0};
    return {{0.72, 0.68, 0.62}, {0.88, 0.84, 0.78}, 0};
}

bool isClear(const sherd::Material& material) {
    return material.name == "glass" || material.name == "ice";
}

}  // namespace demo
