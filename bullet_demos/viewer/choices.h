#pragma once

#include <sherd/sherd.h>

#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace demo {

/// How a mesh of the user's own becomes a body.
struct OwnMesh {
    std::string material = "ceramic";
    bool repair = false;
    double scale = 1;              ///< multiplies the file's coordinates
    double size_m = 0;             ///< above 0: the longest side of its box, whatever the scale
    double shell_thickness_m = 0;  ///< above 0: the mesh is made hollow, with walls of that
    double drop_height_m = 1;
    std::optional<sherd::UpAxis> up_axis;  ///< none: what is usual in the format
};

/// What is shown. Empty ones are as the scene says.
struct Choices {
    std::string file;                  ///< of a scene, or of a mesh
    OwnMesh own_mesh;                  ///< where `file` is a mesh
    std::string preset;                ///< of the scene's file
    std::vector<std::string> changes;  ///< to the scene, PATH=VALUE (scenes/scene_changes.h)

    // Of the assets: they are made anew when one of these changes.
    std::string material;
    std::optional<sherd::Quality> quality;
    float strength_factor = 1;

    // Of how the bodies break: the scene starts anew with the same assets.
    std::optional<int> fragment_count;
    std::optional<sherd::GuideField::Kind> guide;
    std::uint64_t seed = 1;

    bool isScene() const;
};

/// Puts what concerns the assets into a scene. The error is a sentence about a material or a size.
sherd::Status chooseMaterials(Scene& scene, const Choices& choices);
/// Puts into it how the bodies break.
void chooseFracture(Scene& scene, const Choices& choices);

/// Names of the materials that the library has.
const std::vector<std::string>& materialNames();

}  // namespace demo
