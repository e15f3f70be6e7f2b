#include "render/program.h"

#include <epoxy/gl.h>

namespace render {
namespace {

/// Shaders share a few functions: `#include "FILE"` on a line of its own stands for the text of that file.
std::string withIncludes(std::string text) {
    const std::string mark = "#include \"";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
        const std::size_t from = at + mark.size(), to = text.find('"', from);
        text.replace(at, to + 1 - at, shaderText(text.substr(from, to - from)));
    }
    return text;
}

GLuint compile(GLenum kind, const std::string& file) {
    const std::string text = "#version 330 core\n" + withIncludes(shaderText(file));
    const char* source = text.c_str();
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done) return shader;
    char log[2000] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw Failure("The graphics driver cannot compile the shader " + file + ": " + log);
}

}  // namespace

Program::Program(const std::string& vertex_shader, const std::string& fragment_shader)
    : program_(glCreateProgram()) {
    for (const GLuint shader :
         {compile(GL_VERTEX_SHADER, vertex_shader), compile(GL_FRAGMENT_SHADER, fragment_shader)}) {
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program_);
    GLint done = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &done);
    if (done) return;
    char log[2000] = "";
    glGetProgramInfoLog(program_, sizeof log, nullptr, log);
    throw Failure("The graphics driver cannot link " + vertex_shader + " and " + fragment_shader + ": " +
                  log);
}

Program::~Program() {
    glDeleteProgram(program_);
}

void Program::use() const {
    glUseProgram(program_);
}

int Program::location(const char* name) const {
    const auto [known, is_new] = locations_.try_emplace(name, -1);
    if (is_new) known->second = glGetUniformLocation(program_, name);
    return known->second;
}

void Program::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}

void Program::set(const char* name, float value) const {
    glUniform1f(location(name), value);
}

void Program::set(const char* name, const Vec2& value) const {
    glUniform2fv(location(name), 1, value.data());
}

void Program::set(const char* name, const Vec3& value) const {
    glUniform3fv(location(name), 1, value.data());
}

void Program::set(const char* name, const Mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
}

}  // namespace render
