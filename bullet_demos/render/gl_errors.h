#pragma once

#include <string>
#include <vector>

namespace render {

/// Watches for errors of OpenGL in the current context: through the driver's own messages (KHR_debug) where
/// it has them, and through glGetError in any case.
class GlErrors {
  public:
    GlErrors();
    ~GlErrors();
    GlErrors(const GlErrors&) = delete;
    GlErrors& operator=(const GlErrors&) = delete;

    /// Asks glGetError too; call it once a frame. Each message is kept once, of up to 20.
    void check();
    const std::vector<std::string>& messages() const { return messages_; }
    void add(const std::string& message);

  private:
    std::vector<std::string> messages_;
};

}  // namespace render
