#include "render/picture.h"

#include <epoxy/gl.h>
#include <stb/stb_image_write.h>

#include <algorithm>

namespace render {

Picture readBack(const Target& target) {
    Picture picture{target.size(), {}};
    const std::size_t row = std::size_t(picture.size.width) * 3;
    picture.bytes.resize(row * std::size_t(picture.size.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture.size.width, picture.size.height, GL_RGB, GL_UNSIGNED_BYTE,
                 picture.bytes.data());
    for (int y = 0; y < picture.size.height / 2; ++y) {  // OpenGL begins at the bottom
        auto* top = picture.bytes.data() + std::size_t(y) * row;
        std::swap_ranges(top, top + row,
                         picture.bytes.data() + std::size_t(picture.size.height - 1 - y) * row);
    }
    return picture;
}

void writePng(const Picture& picture, const std::string& path) {
    if (!stbi_write_png(path.c_str(), picture.size.width, picture.size.height, 3, picture.bytes.data(),
                        picture.size.width * 3))
        throw Failure("The picture cannot be written to " + path +
                      ": is there such a folder, and may it be written to?");
}

}  // namespace render
