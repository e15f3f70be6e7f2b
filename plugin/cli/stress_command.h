#pragma once

#include <sherd/result.h>

#include <iosfwd>

#include "cli/arguments.h"

namespace sherd::cli {

/// `sherd stress`: case in, stresses, report and picture out, and a line on `out`. Warnings go to standard
/// error.
Status runStress(const Arguments& arguments, std::ostream& out);

}  // namespace sherd::cli
