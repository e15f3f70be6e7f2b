#include "prototype/clinks.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace prototype {
namespace {

using Wave = std::vector<float>;

struct Voice {
    float pitch_hz, ring_s;  ///< of the lowest partial
    float click, click_s;    ///< of the noise
    float dull;              ///< 0 to 1: how much of the noise's high part is taken away
    int pieces;              ///< heard in a break
    float spread_s;          ///< over which they are
};

Voice voiceOf(Timbre timbre) {
    if (timbre == Timbre::glass) return {3100, 0.22f, 0.5f, 0.012f, 0.1f, 46, 0.75f};
    if (timbre == Timbre::plaster) return {170, 0.05f, 1.4f, 0.07f, 0.86f, 26, 0.55f};
    return {1750, 0.09f, 0.6f, 0.008f, 0.3f, 24, 0.5f};
}

/// Adds a knock that begins at a sample.
void addKnock(Wave& wave, std::size_t begin, const Voice& voice, float pitch, float loudness,
              std::minstd_rand& random) {
    constexpr float ratios[] = {1, 1.59f, 2.33f, 2.91f, 4.15f};  // of a plate, not of a string
    constexpr float two_pi = 6.2831853f;
    std::uniform_real_distribution<float> noise(-1, 1);
    float low = 0;
    for (std::size_t i = begin; i < wave.size(); ++i) {
        const float t = float(i - begin) / sound_rate_hz;
        if (t > 6 * std::max(voice.ring_s, voice.click_s)) break;
        float sum = 0;
        for (const float ratio : ratios)
            sum += std::sin(two_pi * pitch * ratio * t) * std::exp(-t * ratio / voice.ring_s) / ratio;
        low = voice.dull * low + (1 - voice.dull) * noise(random);
        wave[i] += loudness * (0.5f * sum + voice.click * low * std::exp(-t / voice.click_s));
    }
}

Samples toSamples(const Wave& wave) {
    float peak = 1e-6f;
    for (const float value : wave) peak = std::max(peak, std::abs(value));
    Samples samples;
    for (const float value : wave) samples.push_back(std::int16_t(30000 * value / peak));
    return samples;
}

}  // namespace

Samples knock(Timbre timbre) {
    const Voice voice = voiceOf(timbre);
    std::minstd_rand random;
    Wave wave(std::size_t(sound_rate_hz * 6 * std::max(voice.ring_s, voice.click_s)));
    addKnock(wave, 0, voice, voice.pitch_hz, 1, random);
    return toSamples(wave);
}

Samples shatter(Timbre timbre) {
    const Voice voice = voiceOf(timbre);
    std::minstd_rand random;
    std::uniform_real_distribution<float> share(0, 1);
    Wave wave(std::size_t(sound_rate_hz * (voice.spread_s + 6 * voice.ring_s)));
    addKnock(wave, 0, voice, 0.8f * voice.pitch_hz, 1.5f, random);
    for (int i = 0; i < voice.pieces; ++i) {
        const float late = share(random) * share(random);  // most of them soon
        const float pitch = voice.pitch_hz * (0.9f + 1.3f * share(random));
        addKnock(wave, std::size_t(sound_rate_hz * voice.spread_s * late), voice, pitch, 0.7f * (1 - late),
                 random);
    }
    return toSamples(wave);
}

}  // namespace prototype
