#pragma once

#include <string>
#include <vector>

namespace sherd {

struct Breakable;

/// Sentences about a body that breaks otherwise than its program may expect, by how it was made: those of its
/// asset among them.
std::vector<std::string> warningsOfMaking(const Breakable& breakable);

/// By what the program has made of the body since: its mass and its shape, each told once.
std::vector<std::string> warningsOfChanges(Breakable& breakable);

}  // namespace sherd
