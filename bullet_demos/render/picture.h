#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/target.h"

namespace render {

/// Colours of a screen, three bytes a pixel, from the top left.
struct Picture {
    Size size;
    std::vector<std::uint8_t> bytes;
};

Picture readBack(const Target& target);

/// Writes a PNG. Throws Failure with the name of the file where that cannot be.
void writePng(const Picture& picture, const std::string& path);

}  // namespace render
