#pragma once

#include <vector>

namespace demo {

/// How a film goes on in simulated time.
struct FilmPace {
    double frames_per_second = 30;
    double slow = 1;  ///< how many times slower the film is around the first break, 1 or more
};

/// A break that a film is slow around: it slows down before, and goes back to its pace after `shown_s`.
struct SlowPart {
    double break_s = -1;  ///< -1: nothing broke, the film is never slow
    double shown_s = 0.1;
};

/// The simulated time of every frame, from 0 to `duration_s`.
std::vector<double> frameTimes(const FilmPace& pace, const SlowPart& slow, double duration_s);

}  // namespace demo
