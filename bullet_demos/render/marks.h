#pragma once

#include <cstdint>
#include <vector>

#include "render/types.h"

namespace render {

/// Points and lines in plain colours over a scene, made anew each frame.
struct Marks {
    struct Point {
        Vec3 position = Vec3::Zero();
        Vec3 colour = Vec3::Ones();
        float radius = 0;   ///< m
        float opacity = 1;  ///< of the middle of a puff
    };
    std::vector<Point> points;  ///< drawn as little balls
    std::vector<Point> ends;    ///< of lines, two each
    std::vector<Point> puffs;   ///< drawn as soft clouds, which hide nothing quite

    void line(const Vec3& from, const Vec3& to, const Vec3& colour) {
        ends.push_back({from, colour, 0, 1});
        ends.push_back({to, colour, 0, 1});
    }
    bool empty() const { return points.empty() && ends.empty() && puffs.empty(); }
};

/// The buffer that marks are drawn from.
class MarkBuffer {
  public:
    MarkBuffer();
    ~MarkBuffer();
    MarkBuffer(const MarkBuffer&) = delete;
    MarkBuffer& operator=(const MarkBuffer&) = delete;

    /// `mode` is one of OpenGL's kinds of primitives.
    void draw(const std::vector<Marks::Point>& marks, std::uint32_t mode) const;

  private:
    std::uint32_t array_ = 0, buffer_ = 0;
};

}  // namespace render
