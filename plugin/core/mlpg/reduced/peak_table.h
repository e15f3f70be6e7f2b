#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <vector>

namespace sherd {

/// Bounds of what a force anywhere on a solid's surface does: the largest equivalent stress of the material's
/// criterion, and the energy. They come from unit loads on patches of several sizes all over the surface, and
/// cost microseconds to ask. A load between the patches may do a little more than they say.
struct PeakTable {
    static constexpr int tangents = 8;  ///< along the surface, half a right angle apart
    static constexpr int directions =
        2 + 2 * tangents;  ///< inwards, half inwards, along the surface, outwards
    static constexpr int modes = 8;
    static constexpr int steps_per_octave = 16;

    struct Patch {
        Eigen::Vector3f middle = Eigen::Vector3f::Zero();  ///< m
        Eigen::Vector3f inward = Eigen::Vector3f::Zero();  ///< unit
        std::uint8_t on_edge = 0;  ///< 1: faces meet there at an angle; a push on either is one on it
        /// The largest equivalent stress anywhere under 1 N along each direction: as peakOf has it.
        std::array<std::uint8_t, directions> peaks{};
        float compliance_m_n = 0;  ///< largest displacement under 1 N
        float work_scale = 0;      ///< of `work`
        /// What 1 N in x, y and z does on the first modes, which have the energy 1/2 each.
        std::array<std::int8_t, 3 * modes> work{};

        bool takes(const Eigen::Vector3f& push) const { return on_edge || inward.dot(push) > 0; }
        /// Unit direction of a number.
        Eigen::Vector3f direction(int number) const;
        Eigen::Matrix<float, modes, 1> workOf(const Eigen::Vector3f& force_n) const;
    };

    /// Patches of one radius.
    struct Level {
        float radius_m = 0;
        float reach_m = 0;    ///< how far a place may be from the patches that stand for it, about
        float unit_pa_n = 0;  ///< the least stress that is told from none
        std::vector<Patch> patches;

        /// The stress that a number stands for, Pa/N; rounded up.
        float peakOf(std::uint8_t number) const;
        std::uint8_t numberOf(float peak_pa_n) const;
        /// Bound of the equivalent stress under a force on a patch, Pa.
        float peak(const Patch& patch, const Eigen::Vector3f& force_n) const;
    };
    std::vector<Level> levels;  ///< radii ascending; empty: there is no table

    /// A push on a place of the surface.
    struct Push {
        Eigen::Vector3f point = Eigen::Vector3f::Zero();    ///< m
        Eigen::Vector3f against = Eigen::Vector3f::Zero();  ///< unit: into the faces that it acts on
        float radius_m = 0;                                 ///< of what it is spread over, at least
    };
    class At;
};

/// What the table knows of a place.
class PeakTable::At {
  public:
    At(const PeakTable& table, const Push& push);

    /// Bound of the equivalent stress anywhere, Pa.
    float stress(const Eigen::Vector3f& force_n) const;
    /// Bound of the stress under 1 N in any direction, Pa.
    float stressOfAny() const;
    /// Bound of the displacement under 1 N, m/N.
    float compliance() const;
    /// What a force does on the first modes; about, and rather less.
    Eigen::Matrix<float, modes, 1> work(const Eigen::Vector3f& force_n) const;

  private:
    struct Near {
        const Level* level = nullptr;
        std::vector<const Patch*> patches;  ///< the nearest first
    };
    static Near near(const Level& level, const Push& push);
    float largest(const Near& near, const Eigen::Vector3f& force_n) const;
    float between(float narrow, float wide) const;

    Near narrow_, wide_;  ///< levels below and above the push
    float share_ = 0;     ///< of the wide one
};

}  // namespace sherd
