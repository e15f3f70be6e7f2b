#include "prototype/dust.h"

#include <algorithm>
#include <cmath>

#include "viewer/conversions.h"

namespace prototype {

void Dust::add(const Happening& happening) {
    constexpr std::size_t most_motes = 1500;
    if (!happening.shatters || motes_.size() > most_motes) return;
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> share(0.5f, 1.0f);
    const float size = std::cbrt(happening.mass_kg);  // of the thing, about in tenths of a metre
    const int count = std::clamp(int(40 * size), 14, 90);
    for (int i = 0; i < count; ++i) {
        const render::Vec3 way(normal(random_), normal(random_), normal(random_));
        Mote mote;
        mote.position = demo::toRender(happening.position) + 0.03f * size * way;
        mote.velocity = 0.5f * std::sqrt(size) * way + render::Vec3(0, 0, 0.25f);
        mote.colour = share(random_) * happening.colour;
        mote.life_s = 0.6f + share(random_);
        mote.radius = (0.035f + 0.03f * size) * share(random_);
        motes_.push_back(mote);
    }
}

void Dust::advance(float seconds) {
    const float kept = std::exp(-3 * seconds);  // of the speed, in still air
    for (Mote& mote : motes_) {
        mote.age_s += seconds;
        mote.velocity = kept * mote.velocity - render::Vec3(0, 0, 0.25f * seconds);
        mote.position += seconds * mote.velocity;
        mote.position.z() = std::max(mote.position.z(), 0.01f);
    }
    motes_.erase(std::remove_if(motes_.begin(), motes_.end(),
                                [](const Mote& mote) { return mote.age_s > mote.life_s; }),
                 motes_.end());
}

void Dust::drawInto(render::Marks& marks) const {
    for (const Mote& mote : motes_) {
        const float age = mote.age_s / mote.life_s;
        marks.puffs.push_back({mote.position, mote.colour, mote.radius * (0.6f + 1.8f * std::sqrt(age)),
                               0.2f * (1 - age) * (1 - age)});
    }
}

}  // namespace prototype
