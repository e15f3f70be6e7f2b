#pragma once

#include <LinearMath/btTransform.h>
#include <sherd/settings.h>
#include <sherd/surface_region.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class btMotionState;

namespace sherd {

/// What is said of a body when it becomes breakable.
struct BreakableOptions {
    std::string name;  ///< for the app's own use: events carry it, fragments inherit it
    /// A body with a seed of its own, and whatever comes of it, breaks along the same cracks under the same
    /// blows, in any world; its strength scatters in a way of its own, too. Without one,
    /// FractureSettings::seed and the order in which bodies became breakable decide where it cracks, and
    /// bodies of one asset are equally strong at equal places (StrengthSettings::seed).
    std::optional<std::uint64_t> seed;
    /// Parts of the surface that the world holds, in the asset frame; empty: those of the asset, if it is
    /// anchored. The stress of a blow is solved with these parts at rest. A body that `add` makes with
    /// supports is static, and one of mass 0 becomes breakable only with them. Its fragments stay as static
    /// bodies where a support holds them by more than a line; the others fall.
    std::vector<SurfaceRegion> supports;
};

/// What `FractureWorld::add` makes a body with; all of it may be left out. A transform alone is a body at
/// rest there.
struct BodyOptions : BreakableOptions {
    BodyOptions(const btTransform& its_start = btTransform::getIdentity()) : start(its_start) {}

    btTransform start;  ///< where the asset's own coordinates stand; a rotation and a translation
    btVector3 velocity = btVector3(0, 0, 0);  ///< of the centre of mass, m/s; has to be 0 with supports
    btVector3 angular_velocity = btVector3(0, 0, 0);  ///< rad/s; has to be 0 with supports
    std::optional<FractureSettings> fracture;         ///< how it breaks; none: as the asset says
    std::optional<int> collision_group;               ///< none: Bullet's own choice
    std::optional<int> collision_mask;                ///< none: Bullet's own choice
    void* user_pointer = nullptr;
    int user_index = -1;
    /// The app's, which outlives the body; it is told `start` at once (what it throws leaves `add`). None:
    /// the body gets one of its own, a btDefaultMotionState whose `m_graphicsWorldTrans` is where to draw the
    /// asset's surface.
    btMotionState* motion_state = nullptr;
};

}  // namespace sherd
