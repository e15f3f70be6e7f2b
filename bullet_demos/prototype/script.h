#pragma once

#include <sherd/result.h>

#include "prototype/arguments.h"
#include "render/context.h"

namespace prototype {

/// Plays without hands for some seconds of the game, throws at everything in turn, and prints how long steps
/// took. The error says why it cannot begin, or what OpenGL reported.
sherd::Status playScript(const Arguments& arguments, render::Context& context);

}  // namespace prototype
