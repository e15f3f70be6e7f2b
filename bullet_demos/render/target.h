#pragma once

#include <cstdint>

#include "render/types.h"

namespace render {

/// A picture in the memory of the graphics card that is drawn to: a colour, and a depth if wanted.
class Target {
  public:
    struct Kind {
        bool light = false;  ///< colours above 1, as floating-point numbers
        bool depth = false;
        int samples = 0;  ///< of each pixel; 0: plain textures, which shaders can read
    };
    Target(Size size, Kind kind);
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    void bind() const;  ///< what is drawn next goes here
    /// The mean of the samples goes to `other`, of the same size.
    void resolveTo(const Target& other, bool with_depth) const;
    void copyToWindow(Size window) const;
    void bindColour(int unit) const;
    void bindDepth(int unit) const;
    Size size() const { return size_; }
    std::uint32_t name() const { return frame_; }

  private:
    std::uint32_t attach(std::uint32_t attachment, std::uint32_t format) const;

    Size size_;
    Kind kind_;
    std::uint32_t frame_ = 0, colour_ = 0, depth_ = 0;
};

/// A depth seen from the light, which shaders compare with.
class ShadowMap {
  public:
    explicit ShadowMap(int width);
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

    void bind() const;
    void bindDepth(int unit) const;

  private:
    int width_;
    std::uint32_t frame_ = 0, depth_ = 0;
};

}  // namespace render
