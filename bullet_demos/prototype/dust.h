#pragma once

#include <random>
#include <vector>

#include "prototype/game.h"
#include "render/marks.h"

namespace prototype {

/// Puffs of dust where something broke.
class Dust {
  public:
    void add(const Happening& happening);
    void advance(float seconds);
    void drawInto(render::Marks& marks) const;

  private:
    struct Mote {
        render::Vec3 position, velocity, colour;
        float age_s = 0, life_s = 1, radius = 0.02f;
    };
    std::vector<Mote> motes_;
    std::minstd_rand random_;
};

}  // namespace prototype
