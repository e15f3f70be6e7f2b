#include "film/frame_times.h"

#include <algorithm>
#include <cmath>

namespace demo {
namespace {

/// 0 up to `from`, 1 after `to`, and smooth between them.
double smoothStep(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Simulated seconds a second of film.
double speedAt(double time_s, const FilmPace& pace, const SlowPart& slow) {
    if (slow.break_s < 0) return 1;
    const double lead_s = slow.shown_s / 4;  // before the break
    const double slowed = smoothStep(slow.break_s - 3 * lead_s, slow.break_s - lead_s, time_s);
    const double over = smoothStep(slow.break_s + slow.shown_s, slow.break_s + 2 * slow.shown_s, time_s);
    return std::pow(pace.slow, -slowed * (1 - over));
}

}  // namespace

std::vector<double> frameTimes(const FilmPace& pace, const SlowPart& slow, double duration_s) {
    constexpr int parts = 64;  // of a frame, so that no frame leaps into the slow part
    const double part_s = 1 / (pace.frames_per_second * parts);
    std::vector<double> times;
    double time_s = 0;
    while (time_s <= duration_s + part_s / 2) {  // sums are rounded
        times.push_back(std::min(time_s, duration_s));
        for (int part = 0; part < parts; ++part) time_s += speedAt(time_s, pace, slow) * part_s;
    }
    return times;
}

}  // namespace demo
