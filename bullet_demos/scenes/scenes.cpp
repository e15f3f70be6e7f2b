#include "scenes.h"

namespace demo {

std::vector<Scene> allScenes() {
    return {coffeeCup(), plasterWall(), glassWall(), woodWall()};
}

sherd::Result<Scene> sceneNamed(const std::string& name) {
    std::string names;
    for (const Scene& scene : allScenes()) {
        if (scene.name == name) return scene;
        names += (names.empty() ? "" : ", ") + scene.name;
    }
    return sherd::Error{"There is no scene '" + name + "'; choose one of: " + names + "."};
}

}  // namespace demo
