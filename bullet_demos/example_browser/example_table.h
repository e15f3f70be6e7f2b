#pragma once

#include <CommonInterfaces/CommonExampleInterface.h>

#include <string>
#include <vector>

namespace demo {

/// A line of the browser's tree. Without a function it is the heading of the lines below it.
struct BrowserEntry {
    int menu_level;
    std::string name, description;
    CommonExampleInterface::CreateFunc* create;
    int option;  ///< for `create`: which scene
};

/// "Brittle fracture" and below it all scenes of the tree. Scenes that cannot be read are left out, with a
/// sentence on the standard error stream. The entries stay where they are until the program ends.
const std::vector<BrowserEntry>& brittleFractureEntries();

}  // namespace demo
