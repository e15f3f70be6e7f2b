#pragma once

#include <array>
#include <cmath>
#include <cstring>

#include "core/mlpg/reduced/reduced_stress.h"
#include "core/mlpg/splines/archive.h"

namespace sherd {

/// What is not finite would make sums of all that is beside it not finite either.
template <class Numbers>
bool areFinite(const Numbers& numbers) {
    bool are = true;
    for (const auto number : numbers) are &= std::isfinite(number);
    return are;
}

template <class Archive>
void StressBounds::archiveBoxes(Archive& archive) {
    const auto used = static_cast<std::size_t>(width_ * width_);
    for (std::array<Interval, 3>& box : boxes_)
        for (Interval& interval : box) {
            auto& [coefficients, per_length] = interval;
            archive.raw(coefficients.data(), used * sizeof(float));
            sherd::archive(archive, per_length);
            archive.require(areFinite(coefficients) && std::isfinite(per_length));
        }
}

template <class Archive>
void archiveModes(Archive& archive, const SplineSpace& space, ProperModes& modes) {
    auto& [count, entries, scales, unit_starts, unit_loads, combinations, combination_scales, accelerations] =
        modes;
    archiveAll(archive, count, entries, scales, combinations, combination_scales, accelerations);
    const auto function_count = static_cast<std::size_t>(space.function_count);
    archive.require(0 < count && count < 1 << 16 && count % ProperModes::lanes == 0);
    if (!archive.good()) return;
    const auto modes_count = static_cast<std::size_t>(count);
    archive.require(
        entries.size() == 3 * function_count * modes_count && scales.size() == modes_count &&
        combinations.size() % (3 * modes_count) == 0 && combination_scales.size() == modes_count &&
        areFinite(scales) && areFinite(combination_scales) && areFinite(accelerations) &&
        accelerations.size() == 6 * modes_count * static_cast<std::size_t>(space.component_count));
    const auto patches = static_cast<int>(combinations.size() / (3 * modes_count));
    archiveList(archive, unit_loads, sizeof(float) + 1, [&](ProperModes::UnitLoad& load) {
        auto& [patch, value] = load;
        archiveIndex(archive, patch, patches);
        sherd::archive(archive, value);
        archive.require(std::isfinite(value));
    });
    archiveStarts(archive, unit_starts, function_count, unit_loads.size());
}

inline constexpr int entries_of_block = 9;
inline constexpr std::array<int, 4> bits_of_entries = {8, 10, 12, 16};  // by their kind

/// Without branches on their kind, which nothing foretells. Four bytes are read from where an entry begins.
inline void unpackEntries(const std::byte* from, int kind, std::int16_t* entries) {
    const int bits = bits_of_entries[static_cast<std::size_t>(kind)], most = 1 << (bits - 1);
    for (int e = 0; e < entries_of_block; ++e) {
        std::uint32_t four = 0;
        std::memcpy(&four, from + e * bits / 8, sizeof four);
        const auto own = static_cast<int>(four >> (e * bits % 8) & static_cast<std::uint32_t>(2 * most - 1));
        entries[e] = static_cast<std::int16_t>(own - most);
    }
}

inline void packEntries(const std::int16_t* entries, int kind, std::byte* to) {
    const int bits = bits_of_entries[static_cast<std::size_t>(kind)], most = 1 << (bits - 1);
    for (int e = 0; e < entries_of_block; ++e) {
        std::uint32_t four = 0;
        std::memcpy(&four, to + e * bits / 8, sizeof four);
        four |= static_cast<std::uint32_t>(entries[e] + most) << (e * bits % 8);
        std::memcpy(to + e * bits / 8, &four, sizeof four);
    }
}

/// The nine entries of a block, as many bits each as their kind says.
template <class Archive>
void archiveEntries(Archive& archive, int kind, std::int16_t* entries) {
    constexpr std::size_t most = 2 * entries_of_block + sizeof(std::uint32_t);
    const auto used = static_cast<std::size_t>(
        (entries_of_block * bits_of_entries[static_cast<std::size_t>(kind)] + 7) / 8);
    std::array<std::byte, most> bytes{};
    if constexpr (Archive::reads) {
        const std::byte* from = archive.next(most);
        if (from) {
            archive.skip(used);
        } else {  // near the end
            archive.raw(bytes.data(), used);
            from = bytes.data();
        }
        unpackEntries(from, kind, entries);
    } else {
        packEntries(entries, kind, bytes.data());
        archive.raw(bytes.data(), used);
    }
}

/// The kind of the fewest bits that hold the entries of a block.
inline int kindOfEntries(const std::int16_t* entries) {
    std::size_t kind = 0;
    for (int e = 0; e < entries_of_block; ++e)
        while (entries[e] < -(1 << (bits_of_entries[kind] - 1)) ||
               entries[e] >= 1 << (bits_of_entries[kind] - 1))
            ++kind;
    return static_cast<int>(kind);
}

/// A block and its row, at or below the row of the block before it. Most couplings are weak, and few bits
/// hold them.
template <class Archive>
void archiveBlock(Archive& archive, int row_before, int end, int& row, std::int16_t* entries) {
    constexpr int far = 63;
    std::uint8_t head = 0;
    if constexpr (!Archive::reads)
        head = static_cast<std::uint8_t>(4 * std::min(row - row_before, far) + kindOfEntries(entries));
    archive.raw(&head, 1);
    const int step = head / 4;
    if (step == far)
        archiveIndex(archive, row, end);
    else
        row = row_before + step;
    archiveEntries(archive, head % 4, entries);
}

template <class Archive>
void archiveStiffness(Archive& archive, const SplineSpace& space, PackedStiffness& stiffness) {
    auto& [starts, rows, entries, roots] = stiffness;
    const auto function_count = static_cast<std::size_t>(space.function_count);
    sherd::archive(archive, roots);
    const std::size_t blocks = archive.count(rows.size(), 10);
    archiveStarts(archive, starts, function_count, blocks);
    archive.require(roots.size() == 3 * function_count && areFinite(roots));
    if (!archive.good()) return;
    if constexpr (Archive::reads) {
        rows.resize(blocks);
        entries.resize(9 * blocks);
    }
    for (int column = 0; column < space.function_count; ++column) {
        int row = column;
        for (int b = starts[column]; b < starts[column + 1]; ++b) {
            archiveBlock(archive, row, space.function_count, rows[b], entries.data() + 9L * b);
            row = rows[b];
            archive.require(column <= row && row < space.function_count);
            if (!archive.good()) return;
        }
    }
}

/// Three numbers of a reading point.
template <class Archive>
void archiveSteps(Archive& archive, Eigen::Vector3f& x) {
    constexpr int bits = 21;
    constexpr std::int64_t middle = 1 << (bits - 1);
    static_assert(ReadingPoint::limit / ReadingPoint::step < middle);
    std::uint64_t packed = 0;
    if constexpr (!Archive::reads)
        for (int d = 0; d < 3; ++d) {
            const auto steps = static_cast<std::int64_t>(x[d] / ReadingPoint::step) + middle;
            packed |= static_cast<std::uint64_t>(steps) << (d * bits);
        }
    archive.raw(&packed, sizeof packed);
    if constexpr (Archive::reads)
        for (int d = 0; d < 3; ++d) {
            const auto steps = static_cast<std::int64_t>(packed >> (d * bits) & (2 * middle - 1));
            x[d] = static_cast<float>(steps - middle) * ReadingPoint::step;
        }
}

template <class Archive>
void archivePoints(Archive& archive, const Discretisation& solid, ReadingPoints& points) {
    const auto particle_count = static_cast<int>(solid.particles.size());
    archiveList(archive, points.points, sizeof(std::uint64_t) + 2, [&](ReadingPoint& point) {
        archiveSteps(archive, point.xi);
        archiveIndex(archive, point.particle, particle_count);
        bool has_normal = !point.normal.isZero(0);
        sherd::archive(archive, has_normal);
        if (has_normal) archiveSteps(archive, point.normal);
    });
    archiveStarts(archive, points.starts, solid.parts.parts.size(), points.points.size());
}

/// Reads what answers blows on a solid without a factor, if there is no `written`.
template <class Archive>
std::shared_ptr<const ReducedStress> archiveReduced(Archive& archive,
                                                    const std::shared_ptr<const Discretisation>& sampling,
                                                    const Material& material, const ReducedStress* written) {
    PackedStiffness stiffness;
    ProperModes modes;
    ReducedModelLimits limits;
    ReadingPoints points;
    std::vector<std::string> warnings;
    if (written) {
        const auto& [model, reading, trust] = *written;
        stiffness = model.stiffness();
        modes = model.modes();
        limits = model.limits();
        points = reading.points();
        warnings = trust;
    }
    const auto made =
        archiveProblem(archive, sampling, material, written ? &written->model.problem() : nullptr);
    if (Archive::reads && !made) return nullptr;
    const SplineProblem& problem = written ? written->model.problem() : *made;
    auto& [patches, mode_limit, local_functions] = limits;
    archiveAll(archive, patches, mode_limit, local_functions, warnings);
    archiveStiffness(archive, *problem.space, stiffness);
    archiveModes(archive, *problem.space, modes);
    archivePoints(archive, *sampling, points);
    if (!archive.good()) return nullptr;
    StressBounds bounds = written
                              ? written->reading.bounds()
                              : StressBounds(problem.parts(), problem.space->degree, problem.elasticity, {});
    bounds.archiveBoxes(archive);
    if (!Archive::reads || !archive.good()) return nullptr;
    ReducedModel model(made, std::move(stiffness), std::move(modes), limits);
    return std::make_shared<const ReducedStress>(ReducedStress{
        std::move(model), DamageReading(made, std::move(points), std::move(bounds)), std::move(warnings)});
}

}  // namespace sherd
