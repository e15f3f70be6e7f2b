#pragma once

#include <sherd/sherd.h>

#include <string>
#include <vector>

#include "prototype/timbre.h"
#include "render/material.h"

namespace prototype {

/// A kind of thing that breaks. Its asset is made once, and all things of this kind share it.
struct Kind {
    std::string name;  ///< also of the file that keeps the asset
    sherd::TriangleMesh surface;
    sherd::Material material;
    sherd::Settings settings;
    std::vector<sherd::SurfaceRegion> supports;  ///< parts that the hall holds; none: it stands loose
    Timbre timbre = Timbre::ceramic;
    int points = 1;  ///< a piece
};

/// A thing and where it stands. The place is that of the mesh's own coordinates.
struct Prop {
    std::size_t kind = 0;  ///< index into Level::kinds
    btTransform home = btTransform::getIdentity();
    render::Material look;
};

/// A box that never breaks.
struct Block {
    render::Vec3 centre = render::Vec3::Zero(), size = render::Vec3::Ones();
    render::Material look;
};

/// What stands in the hall. x goes to the right, y away from the player, z up; the floor is z = 0.
struct Level {
    std::vector<Kind> kinds;
    std::vector<Prop> props;
    std::vector<Block> blocks;
};

/// The hall: crockery on shelves, a window, plaster walls. The folder `meshes` keeps generated meshes. The
/// error says which mesh cannot be had.
sherd::Result<Level> makeLevel(const std::string& meshes);

}  // namespace prototype
