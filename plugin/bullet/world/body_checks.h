#pragma once

#include <sherd/body_options.h>
#include <sherd/result.h>

class btDiscreteDynamicsWorld;

namespace sherd {

inline constexpr double speed_of_light_m_s = 299792458;

/// Says which of the options is no place, no velocity, or out of its range.
Status checkOptions(const BodyOptions& options);

/// Says why bodies cannot break in a world: its kind does not call the solver as Sherd needs it.
Status checkWorld(const btDiscreteDynamicsWorld& world);

}  // namespace sherd
