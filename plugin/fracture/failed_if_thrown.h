#pragma once

#include <functional>

#include "fracture/blow_outcome.h"

namespace sherd {

/// Runs the stages of a blow. They write to the outcome as they go; whatever they throw, the outcome then
/// says what failed, and the body stays whole. Nothing may leave through Bullet's step.
BlowOutcome failedIfThrown(const std::function<void(BlowOutcome&)>& stages);

}  // namespace sherd
