#pragma once

#include <sherd/result.h>

#include "prototype/arguments.h"
#include "render/context.h"

namespace prototype {

/// The game in a window, until it is closed. The error says why it cannot begin.
sherd::Status play(const Arguments& arguments, render::Context& context);

}  // namespace prototype
