#pragma once

#include "render/context.h"
#include "viewer/arguments.h"

namespace demo {

/// Runs a script: so many steps, throws and pictures, the same every time. Says what came of it on the
/// standard output. The error is a sentence, also where OpenGL reported errors.
sherd::Status runScript(const ViewArguments& arguments, render::Context& context);

}  // namespace demo
