#pragma once

#include <sherd/result.h>

#include "cli/arguments.h"

namespace sherd::cli {

/// `sherd stress`: case in, stresses, report and picture out. Warnings go to standard error.
Status runStress(const Arguments& arguments);

}  // namespace sherd::cli
