#include "prototype/script.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <thread>

#include "prototype/screen.h"
#include "viewer/conversions.h"

namespace prototype {
namespace {

using Clock = std::chrono::steady_clock;

/// Of this process, MB; 0 where the system does not tell so.
double residentMb() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (double kb = 0; std::sscanf(line.c_str(), "VmRSS: %lf", &kb) == 1) return kb / 1024;
    return 0;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// A run without hands.
class Script {
  public:
    Script(const Arguments& arguments, Screen& screen, ReadyLevel level)
        : arguments_(arguments),
          screen_(screen),
          game_(std::move(level)),
          picture_(game_.level()),
          steps_(std::max(1, int(std::lround(arguments.script_seconds / double(Game::step_s))))) {}

    void run() {
        memory_mb_.push_back(residentMb());
        const Clock::time_point begin = Clock::now();
        for (int step = 1; step <= steps_; ++step) {
            throwInTurn(step);
            stepOnce();
            if (step == steps_ / 2) memory_mb_.push_back(residentMb());
            if (arguments_.paced)
                std::this_thread::sleep_until(begin + step * std::chrono::duration_cast<Clock::duration>(
                                                                 std::chrono::duration<float>(Game::step_s)));
            drawSometimes(step);
        }
        memory_mb_.push_back(residentMb());
        if (!arguments_.screenshot.empty()) screen_.writePng(arguments_.screenshot);
    }

    void print();

  private:
    /// Throws at where each thing stands when it is there, in a fixed order; now and then a bomb.
    void throwInTurn(int step) {
        constexpr int steps_between_throws = 24, throws_between_bombs = 8;
        if (step % steps_between_throws != 1) return;
        const int number = step / steps_between_throws;
        const std::vector<Prop>& props = game_.level().props;
        const Prop& target = props[std::size_t(7 * number) % props.size()];
        const render::Vec3 aim = demo::toRender(target.home.getOrigin()) + render::Vec3(0, 0, 0.06f);
        const render::Vec3 eye = screen_.camera().eye();
        const render::Ray ray{eye, (aim - eye).normalized()};
        if (number % throws_between_bombs == throws_between_bombs - 1)
            game_.setOffBomb(ray);
        else
            game_.throwBall(ray);
    }

    void stepOnce() {
        const Clock::time_point begin = Clock::now();
        game_.advance(Game::step_s);
        step_ms_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
        for (const Happening& happening : game_.takeHappenings()) dust_.add(happening);
        dust_.advance(Game::step_s);
    }

    /// Off the screen nobody looks, and a picture may take longer than a step.
    void drawSometimes(int step) {
        constexpr int steps_between_pictures = 600;
        if (arguments_.off_screen && step != steps_ && step % steps_between_pictures != 0) return;
        screen_.begin(Game::step_s);
        screen_.draw(picture_.frame(game_, dust_), game_.score());
        // Panels that fit their contents are not shown before these are known.
        if (step != steps_) return;
        screen_.begin(Game::step_s);
        screen_.draw(picture_.frame(game_, dust_), game_.score());
    }

    const Arguments& arguments_;
    Screen& screen_;
    Game game_;
    Picture picture_;
    Dust dust_;
    int steps_;
    std::vector<double> step_ms_, memory_mb_;
};

/// The stages that took most, in ms a step.
template <class Times>
void printTimes(const char* what, const Times& times, int steps) {
    std::printf("  %s:", what);
    for (const sherd::TimeField<Times>& field : sherd::time_fields<Times>)
        if (times.*field.value > 0.02 * steps)
            std::printf(" %s %.2f", field.name, times.*field.value / steps);
    std::printf("\n");
}

void Script::print() {
    double sum = 0;
    int late = 0;
    for (const double ms : step_ms_) {
        sum += ms;
        late += ms > 1000 * double(Game::step_s);
    }
    const sherd::WorldTimes times = game_.fracture().times();
    std::printf("of %.2f ms a step Sherd %.2f, the rest Bullet and the rules; ms a step by stages\n",
                sum / steps_, times.whole / steps_);
    printTimes("blows", times.blows, steps_);
    printTimes("steps", times.steps, steps_);
    printTimes("beside the steps", times.workers, steps_);
    const sherd::BlowCounts counts = game_.fracture().counts();
    std::printf(
        "blows: %lld gate, %lld coarse, %lld reduced, %lld full; %lld foreseen, %lld waited, %lld dropped\n",
        counts.gate, counts.coarse, counts.reduced, counts.full, counts.foreseen, counts.waited,
        counts.dropped);
    const Score& score = game_.score();
    std::printf(
        "%zu steps in %.1f s: worst %.1f ms, 99th percentile %.2f ms, median %.2f ms, %d over %.1f ms\n",
        step_ms_.size(), sum / 1000, quantile(step_ms_, 1), quantile(step_ms_, 0.99), quantile(step_ms_, 0.5),
        late, 1000 * double(Game::step_s));
    std::printf("%d points: %d things broken, %.1f kg, %d pieces\n", score.points, score.breaks,
                score.broken_kg, score.pieces);
    std::printf(
        "%zu bodies alive; resident memory %.0f MB at the start, %.0f MB in the middle, %.0f MB at the end\n",
        game_.fracture().bodies().size(), memory_mb_[0], memory_mb_[memory_mb_.size() / 2],
        memory_mb_.back());
    std::printf("%zu OpenGL errors; %s\n", screen_.glErrors().size(), render::contextDescription().c_str());
}

}  // namespace

sherd::Status playScript(const Arguments& arguments, render::Context& context) {
    const Clock::time_point begin = Clock::now();
    auto level = Baking(arguments.baked).take();
    if (!level) return sherd::Error{level.error()};
    std::printf("ready after %.2f s, %d assets baked\n",
                std::chrono::duration<double>(Clock::now() - begin).count(), level.value().baked);
    Screen screen(context);
    Script script(arguments, screen, std::move(level).value());
    script.run();
    script.print();
    if (screen.glErrors().empty()) return sherd::success();
    std::string sentence = "OpenGL reported errors:";
    for (const std::string& message : screen.glErrors()) sentence += "\n  " + message;
    return sherd::Error{sentence};
}

}  // namespace prototype
