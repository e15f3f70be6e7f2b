#pragma once

#include <cstring>

#include "core/mlpg/reduced/reduced_stress.h"
#include "core/mlpg/splines/archive.h"

namespace sherd {

template <class Archive>
void StressBounds::archiveBoxes(Archive& archive) {
    const auto used = static_cast<std::size_t>(width_ * width_);
    for (std::array<Interval, 3>& box : boxes_)
        for (Interval& interval : box) {
            auto& [coefficients, per_length] = interval;
            archive.raw(coefficients.data(), used * sizeof(float));
            sherd::archive(archive, per_length);
        }
}

template <class Archive>
void archiveModes(Archive& archive, const SplineSpace& space, ProperModes& modes) {
    auto& [count, entries, scales, unit_starts, unit_loads, combinations, accelerations] = modes;
    archiveAll(archive, count, entries, scales, combinations, accelerations);
    const auto function_count = static_cast<std::size_t>(space.function_count);
    archive.require(0 < count && count < 1 << 16 && count % ProperModes::lanes == 0);
    if (!archive.good()) return;
    const auto modes_count = static_cast<std::size_t>(count);
    archive.require(entries.size() == 3 * function_count * modes_count && scales.size() == modes_count &&
                    combinations.size() % (3 * modes_count) == 0 &&
                    accelerations.size() ==
                        6 * modes_count * static_cast<std::size_t>(space.component_count));
    const auto patches = static_cast<int>(combinations.size() / (3 * modes_count));
    archiveList(archive, unit_loads, sizeof(float) + 1, [&](ProperModes::UnitLoad& load) {
        auto& [patch, value] = load;
        archiveIndex(archive, patch, patches);
        sherd::archive(archive, value);
    });
    archiveStarts(archive, unit_starts, function_count, unit_loads.size());
}

/// The nine entries of a block, `bits` each.
template <class Archive>
void archiveEntries(Archive& archive, int bits, std::int16_t* entries) {
    constexpr int size = 9;
    std::array<std::uint8_t, 2 * size + 4> bytes{};  // with room for the last one to be read as four
    const int most = 1 << (bits - 1);
    const auto at = [&](int entry) { return bytes.data() + entry * bits / 8; };
    std::uint32_t four = 0;
    if constexpr (!Archive::reads)
        for (int e = 0; e < size; ++e) {
            std::memcpy(&four, at(e), sizeof four);
            four |= static_cast<std::uint32_t>(entries[e] + most) << (e * bits % 8);
            std::memcpy(at(e), &four, sizeof four);
        }
    archive.raw(bytes.data(), static_cast<std::size_t>((size * bits + 7) / 8));
    for (int e = 0; e < size; ++e) {
        std::memcpy(&four, at(e), sizeof four);
        entries[e] =
            static_cast<std::int16_t>(static_cast<int>(four >> (e * bits % 8) & (2 * most - 1)) - most);
    }
}

/// A block and its row, at or below the row of the block before it. Most couplings are weak, and few bits
/// hold them.
template <class Archive>
void archiveBlock(Archive& archive, int row_before, int end, int& row, std::int16_t* entries) {
    constexpr std::array<int, 4> bits = {8, 10, 12, 16};
    constexpr int far = 63;
    int kind = 0;
    if constexpr (!Archive::reads)
        for (int e = 0; e < 9; ++e)
            while (entries[e] < -(1 << (bits[kind] - 1)) || entries[e] >= 1 << (bits[kind] - 1)) ++kind;
    auto head = static_cast<std::uint8_t>(4 * std::min(row - row_before, far) + kind);
    archive.raw(&head, 1);
    const int step = head / 4;
    if (step == far)
        archiveIndex(archive, row, end);
    else
        row = row_before + step;
    archiveEntries(archive, bits[head % 4], entries);
}

template <class Archive>
void archiveStiffness(Archive& archive, const SplineSpace& space, PackedStiffness& stiffness) {
    auto& [starts, rows, entries, roots] = stiffness;
    const auto function_count = static_cast<std::size_t>(space.function_count);
    sherd::archive(archive, roots);
    const std::size_t blocks = archive.count(rows.size(), 10);
    archiveStarts(archive, starts, function_count, blocks);
    archive.require(roots.size() == 3 * function_count);
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

/// Where particles and surface points lie: the part of each is kept, and its place in it follows.
template <class Archive>
void archiveSamples(Archive& archive, const Discretisation& solid, std::vector<GridPoint>& samples) {
    std::vector<int> parts;
    for (const GridPoint& sample : samples) parts.push_back(sample.part);
    archiveIndices(archive, parts, static_cast<int>(solid.parts.parts.size()), -1);
    const std::size_t particles = solid.particles.size();
    archive.require(parts.size() == particles + solid.surface_points.size());
    if (!Archive::reads || !archive.good()) return;
    samples.assign(parts.size(), {});
    for (std::size_t s = 0; s < parts.size(); ++s) {
        if (parts[s] < 0) continue;
        const Vec3& x =
            s < particles ? solid.particles[s].position : solid.surface_points[s - particles].position;
        samples[s] = {parts[s], solid.parts.toCell(x, solid.parts.parts[parts[s]].cell)};
    }
}

/// Reads what answers blows on a solid without a factor, if there is no `written`.
template <class Archive>
std::shared_ptr<const ReducedStress> archiveReduced(Archive& archive,
                                                    const std::shared_ptr<const Discretisation>& sampling,
                                                    const Material& material, const ReducedStress* written) {
    PackedStiffness stiffness;
    ProperModes modes;
    ReducedModelLimits limits;
    std::vector<GridPoint> samples;
    std::vector<std::string> warnings;
    if (written) {
        const auto& [model, reading, trust] = *written;
        stiffness = model.stiffness();
        modes = model.modes();
        limits = model.limits();
        samples = reading.samples();
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
    archiveSamples(archive, *sampling, samples);
    if (!archive.good()) return nullptr;
    StressBounds bounds = written
                              ? written->reading.bounds()
                              : StressBounds(problem.parts(), problem.space->degree, problem.elasticity, {});
    bounds.archiveBoxes(archive);
    if (!Archive::reads || !archive.good()) return nullptr;
    ReducedModel model(made, std::move(stiffness), std::move(modes), limits);
    return std::make_shared<const ReducedStress>(ReducedStress{
        std::move(model), DamageReading(made, std::move(samples), std::move(bounds)), std::move(warnings)});
}

}  // namespace sherd
