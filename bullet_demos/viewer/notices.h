#pragma once

#include "render/context.h"
#include "viewer/state.h"

namespace demo {

/// A bar in the middle while something is loaded (`share` below 0: nobody knows how far that is) or prepared;
/// with `may_start`, a button that does not wait for it.
void drawProgress(ViewerState& state, const std::string& what, float share, bool may_start,
                  render::Size size);

/// What was said of what was loaded, and the last notice.
void drawNotices(ViewerState& state, render::Size size);

}  // namespace demo
