#include "example_browser/example_table.h"

#include <algorithm>
#include <iostream>

#include "example_browser/fracture_example.h"
#include "scenes/scene_file.h"
#include "scenes/scenes.h"

namespace demo {
namespace {

/// A scene that can be chosen, with its sliders, which stay where they are when it is chosen again.
struct Choice {
    std::string file;
    Knobs knobs;
    BrowserEntry entry;
};

CommonExampleInterface* create(CommonExampleOptions& options);

/// coffee_cup becomes Coffee cup.
std::string titleOf(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

std::vector<Choice> readChoices() {
    std::vector<Choice> choices;
    for (const std::string& file : sceneFiles(SHERD_DEMO_SCENES)) {
        const auto scene = readScene(file);
        if (!scene) {
            std::cerr << scene.error() << '\n';
            continue;
        }
        const int option = static_cast<int>(choices.size());
        choices.push_back({file,
                           knobsOf(scene.value()),
                           {1, titleOf(scene.value().name), scene.value().summary, create, option}});
    }
    return choices;
}

std::vector<Choice>& choices() {
    static std::vector<Choice> all = readChoices();
    return all;
}

CommonExampleInterface* create(CommonExampleOptions& options) {
    Choice& choice = choices().at(static_cast<std::size_t>(options.m_option));
    return new FractureExample(options.m_guiHelper, choice.file, SHERD_DEMO_MESHES, choice.knobs);
}

std::vector<BrowserEntry> makeEntries() {
    std::vector<BrowserEntry> entries = {
        {0, "Brittle fracture", "Bodies that break where the stress of a blow is too much", nullptr, 0}};
    for (const Choice& choice : choices()) entries.push_back(choice.entry);
    return entries;
}

}  // namespace

const std::vector<BrowserEntry>& brittleFractureEntries() {
    static const std::vector<BrowserEntry> entries = makeEntries();
    return entries;
}

}  // namespace demo
