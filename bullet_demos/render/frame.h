#pragma once

#include <vector>

#include "render/marks.h"
#include "render/material.h"
#include "render/mesh.h"
#include "render/program.h"

namespace render {

/// A mesh at a place.
struct Item {
    const Mesh* mesh = nullptr;  ///< outlives the draw
    Mat4 place = Mat4::Identity();
    Material material;
    bool is_ground = false;  ///< reaches to the horizon, where it fades; throws no shadow

    Bounds bounds() const;  ///< in the world
};

/// All that one frame shows.
struct Frame {
    std::vector<Item> items;
    Marks marks;
    bool marks_through = false;  ///< marks are seen through what lies before them
    Light light;
};

/// From where it is shown.
struct View {
    Vec3 eye, right, up;
    Mat4 projection, view_projection;
    float distance;  ///< to what is looked at
    Size size;
};

/// Gives the light to a program that has shaders/environment.glsl; it is in use.
void setLight(const Program& program, const Light& light);

}  // namespace render
