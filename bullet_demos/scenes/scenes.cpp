#include "scenes/scenes.h"

#include <algorithm>
#include <filesystem>

namespace demo {

namespace fs = std::filesystem;

std::vector<std::string> sceneFiles(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code failure;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure))
        if (at->path().extension() == ".json") files.push_back(at->path().string());
    std::sort(files.begin(), files.end());
    return files;
}

sherd::Result<std::string> sceneFile(const std::string& name, const std::string& folder) {
    if (fs::path(name).extension() == ".json") return name;
    std::string names;
    for (const std::string& file : sceneFiles(folder)) {
        const std::string known = fs::path(file).stem().string();
        if (known == name) return file;
        names += (names.empty() ? "" : ", ") + known;
    }
    if (names.empty())
        return sherd::Error{"There are no scene files in " + folder + "; name the folder with --scenes."};
    return sherd::Error{"There is no scene '" + name + "'; choose one of: " + names +
                        ", or name a file that ends in .json; a mesh is named with its ending, as mug.obj, "
                        "and takes --view."};
}

}  // namespace demo
