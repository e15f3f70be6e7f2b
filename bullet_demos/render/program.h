#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "render/types.h"

namespace render {

/// A linked pair of shaders from shaders/, by the names of their files. Throws Failure with what the driver
/// says of them.
class Program {
  public:
    Program(const std::string& vertex_shader, const std::string& fragment_shader);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const;
    // Of the program in use; a name that the shaders do not use is passed over.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const Vec2& value) const;
    void set(const char* name, const Vec3& value) const;
    void set(const char* name, const Mat4& value) const;

  private:
    int location(const char* name) const;

    std::uint32_t program_ = 0;
    mutable std::map<std::string, int> locations_;
};

/// The text of a file of shaders/, which is built in.
const std::string& shaderText(const std::string& file);

}  // namespace render
