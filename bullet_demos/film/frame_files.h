#pragma once

#include <sherd/result.h>

#include <string>

#include "film/frame_times.h"
#include "headless/scene_run.h"
#include "scenes/scene.h"

namespace demo {

/// A film as a sequence of pictures.
struct Film {
    std::string folder;  ///< for scene files and pictures; empty: no film is wanted
    FilmPace pace;
    int width = 640;  ///< of a picture, in pixels; its height is 10/16 of that
};

/// Writes film.json, one scene file of POV-Ray a frame (frame_0001.pov, ...) and one file a body, which the
/// frames include. The camera stands still where it sees the scene just before the first break and in
/// after.png. What an earlier film left in the folder is deleted first.
sherd::Status writeFrames(const Scene& scene, const SceneRun& run, const Film& film);

}  // namespace demo
