#include "core/mlpg/reduced/peak_table.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"

namespace sherd {

namespace {

using Eigen::Vector3f;

constexpr float root_half = 0.70710678f, root_two = 1.41421356f;

/// Two axes along the surface.
struct Frame {
    Vector3f first, second;
    explicit Frame(const Vector3f& normal) : first(normal.unitOrthogonal()), second(normal.cross(first)) {}

    Vector3f tangent(int number) const {
        constexpr float cosines[] = {1, root_half, 0, -root_half, -1, -root_half, 0, root_half};
        static_assert(std::size(cosines) == PeakTable::tangents);
        return cosines[number] * first + cosines[(number + 6) % PeakTable::tangents] * second;
    }
};

/// What a force along a surface is of two neighbouring tangents; both factors are 0 or more.
struct Lateral {
    int first = 0, second = 0;
    float of_first = 0, of_second = 0;

    Lateral(const Frame& frame, const Vector3f& force) {
        constexpr float eighth = static_cast<float>(pi / 4);
        const float angle = std::atan2(force.dot(frame.second), force.dot(frame.first));
        first = (static_cast<int>(std::floor(angle / eighth)) + PeakTable::tangents) % PeakTable::tangents;
        second = (first + 1) % PeakTable::tangents;
        const float s = force.dot(frame.tangent(first)), t = force.dot(frame.tangent(second));
        of_first = std::max(0.0f, 2 * (s - root_half * t));
        of_second = std::max(0.0f, 2 * (t - root_half * s));
    }
    float sum() const { return of_first + of_second; }
    /// The same sum of other numbers.
    float of(const float* numbers) const { return of_first * numbers[first] + of_second * numbers[second]; }
};

const std::array<float, 256>& powersOfTwo() {
    static const std::array<float, 256> powers = [] {
        std::array<float, 256> made{};
        for (int i = 0; i < 256; ++i)
            made[i] = static_cast<float>(std::exp2(static_cast<double>(i) / PeakTable::steps_per_octave));
        return made;
    }();
    return powers;
}

}  // namespace

Vector3f PeakTable::Patch::direction(int number) const {
    if (number == 0) return inward;
    if (number == directions - 1) return -inward;
    const Vector3f along = Frame(inward).tangent((number - 1) % tangents);
    return number > tangents ? along : Vector3f(root_half * (inward + along));
}

Eigen::Matrix<float, PeakTable::modes, 1> PeakTable::Patch::workOf(const Vector3f& force) const {
    const Eigen::Map<const Eigen::Matrix<std::int8_t, modes, 3>> entries(work.data());
    return work_scale * (entries.cast<float>() * force);
}

float PeakTable::Level::peakOf(std::uint8_t number) const {
    return number == 0 ? 0 : unit_pa_n * powersOfTwo()[number];
}

std::uint8_t PeakTable::Level::numberOf(float peak) const {
    constexpr float most = 255;
    if (!(peak > 0)) return 0;
    return static_cast<std::uint8_t>(
        std::clamp(std::ceil(steps_per_octave * std::log2(peak / unit_pa_n)), 1.0f, most));
}

// The largest equivalent stress is a convex function of the force, and proportional to it, as the equivalent
// stress is one of the stress. So that of a sum of directions is no more than the sum of theirs.
float PeakTable::Level::peak(const Patch& patch, const Vector3f& force) const {
    std::array<float, directions> peaks;
    for (int d = 0; d < directions; ++d) peaks[d] = peakOf(patch.peaks[d]);
    const float *tilted = peaks.data() + 1, *along = tilted + tangents;
    const float normal = force.dot(patch.inward);
    const Lateral lateral(Frame(patch.inward), force);
    if (normal <= 0) return -normal * peaks.back() + lateral.of(along);
    if (lateral.sum() <= normal) return (normal - lateral.sum()) * peaks[0] + root_two * lateral.of(tilted);
    const float share = normal / lateral.sum();
    return share * root_two * lateral.of(tilted) + (1 - share) * lateral.of(along);
}

PeakTable::At::Near PeakTable::At::near(const Level& level, const Push& push) {
    float nearest = std::numeric_limits<float>::infinity();
    const Patch* first = nullptr;
    for (const Patch& patch : level.patches) {
        const float squared = (patch.middle - push.point).squaredNorm();
        if (squared >= nearest || !patch.takes(push.against)) continue;
        nearest = squared;
        first = &patch;
    }
    Near found{&level, {}};
    if (!first) return found;
    found.patches.push_back(first);
    const float within = std::sqrt(nearest) + level.reach_m;
    for (const Patch& patch : level.patches)
        if (&patch != first && (patch.middle - push.point).squaredNorm() <= within * within &&
            patch.takes(push.against))
            found.patches.push_back(&patch);
    return found;
}

PeakTable::At::At(const PeakTable& table, const Push& push) {
    // A push near an edge acts on one of its faces, and so on a smaller place than its radius says.
    const float radius = root_half * push.radius_m;
    const auto& levels = table.levels;
    std::size_t below = 0;
    while (below + 1 < levels.size() && levels[below + 1].radius_m <= radius) ++below;
    narrow_ = near(levels[below], push);
    if (below + 1 == levels.size() || radius <= levels[below].radius_m) return;
    wide_ = near(levels[below + 1], push);
    share_ = std::log(radius / levels[below].radius_m) /
             std::log(levels[below + 1].radius_m / levels[below].radius_m);
}

float PeakTable::At::largest(const Near& near, const Vector3f& force) const {
    if (near.patches.empty()) return std::numeric_limits<float>::infinity();
    float peak = 0;
    for (const Patch* patch : near.patches) peak = std::max(peak, near.level->peak(*patch, force));
    return peak;
}

/// A bound for the push's radius: it falls between the levels as a power of the radius.
float PeakTable::At::between(float narrow, float wide) const {
    return wide > 0 && wide < narrow ? narrow * std::pow(wide / narrow, share_) : narrow;
}

float PeakTable::At::stress(const Vector3f& force) const {
    const float narrow = largest(narrow_, force);
    return share_ > 0 ? between(narrow, largest(wide_, force)) : narrow;
}

float PeakTable::At::stressOfAny() const {
    constexpr float largest_sum = 1.2f;  // of the factors of the directions that a unit force is made of
    const auto any = [](const Near& near) {
        if (near.patches.empty()) return std::numeric_limits<float>::infinity();
        std::uint8_t most = 0;
        for (const Patch* patch : near.patches)
            most = std::max(most, *std::max_element(patch->peaks.begin(), patch->peaks.end()));
        return largest_sum * near.level->peakOf(most);
    };
    const float narrow = any(narrow_);
    return share_ > 0 ? between(narrow, any(wide_)) : narrow;
}

float PeakTable::At::compliance() const {
    float largest = 0;
    for (const Patch* patch : narrow_.patches) largest = std::max(largest, patch->compliance_m_n);
    return narrow_.patches.empty() ? std::numeric_limits<float>::infinity() : largest;
}

Eigen::Matrix<float, PeakTable::modes, 1> PeakTable::At::work(const Vector3f& force) const {
    const Near& near = share_ > 0 ? wide_ : narrow_;
    if (near.patches.empty()) return Eigen::Matrix<float, modes, 1>::Zero();
    return near.patches.front()->workOf(force);
}

}  // namespace sherd
