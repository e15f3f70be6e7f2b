#pragma once

namespace prototype {

/// What a thing sounds like when it is struck, and when it breaks.
enum class Timbre { ceramic, glass, plaster };

}  // namespace prototype
