#pragma once

#include <string>
#include <vector>

namespace sherd {

struct Breakable;

/// Sentences about a body that breaks otherwise than its program may expect: those of its asset, and of what
/// the program has made of the body since.
std::vector<std::string> warningsOf(const Breakable& breakable);

}  // namespace sherd
