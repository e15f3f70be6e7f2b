#pragma once

#include <cmath>
#include <cstdint>

#include "core/archive/finite.h"
#include "core/mlpg/reduced/reduced_stress.h"
#include "core/mlpg/reduced/stiffness_archive.h"
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
            archive.require(areFinite(coefficients) && std::isfinite(per_length));
        }
}

inline bool isFiniteSize(float value) {
    return std::isfinite(value) && value >= 0;
}

template <class Archive>
void archiveFields(Archive& archive, PeakTable::Patch& patch) {
    auto& [middle, inward, on_edge, peaks, compliance_m_n, work_scale, work] = patch;
    archiveAll(archive, middle, inward, on_edge, peaks, compliance_m_n, work_scale, work);
    constexpr float rounding = 1e-3f;
    archive.require(on_edge <= 1 && areFinite(middle) && std::abs(inward.norm() - 1) < rounding &&
                    isFiniteSize(compliance_m_n) && isFiniteSize(work_scale));
}

template <class Archive>
void archiveFields(Archive& archive, PeakTable::Level& level) {
    auto& [radius_m, reach_m, unit_pa_n, patches] = level;
    archiveAll(archive, radius_m, reach_m, unit_pa_n, patches);
    archive.require(radius_m > 0 && reach_m > 0 && isFiniteSize(radius_m) && isFiniteSize(reach_m) &&
                    isFiniteSize(unit_pa_n));
}

template <class Archive>
void archiveModes(Archive& archive, const SplineSpace& space, ProperModes& modes) {
    auto& [count, entries, scales, unit_starts, unit_loads, combinations, combination_scales, accelerations] =
        modes;
    archiveAll(archive, count, entries, scales, combinations, combination_scales, accelerations);
    const auto function_count = static_cast<std::size_t>(space.function_count);
    archive.require(0 < count && count < 1 << 16 && count % ProperModes::lanes == 0);
    if (!archive.good()) return;
    const auto modes_count = static_cast<std::size_t>(count), width = scales.size();
    archive.require(
        entries.size() == 3 * function_count * width && modes_count <= width && width <= 2 * modes_count &&
        width % ProperModes::lanes == 0 && combinations.size() % (3 * modes_count) == 0 &&
        combination_scales.size() == modes_count && areFinite(scales) && areFinite(combination_scales) &&
        areFinite(accelerations) &&
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

/// None, or as many as there are proper modes.
template <class Archive>
void archiveVibrations(Archive& archive, const ProperModes& modes, VibrationModes& vibrations) {
    bool any = vibrations.rates_rad_s.size() > 0;
    sherd::archive(archive, any);
    if (!any || !archive.good()) return;
    Eigen::ArrayXd& rates = vibrations.rates_rad_s;
    Eigen::MatrixXf& shapes = vibrations.shapes;
    if (Archive::reads) {
        rates.resize(modes.count);
        shapes.resize(modes.count, modes.count);
    }
    archive.raw(rates.data(), static_cast<std::size_t>(rates.size()) * sizeof(double));
    archive.raw(shapes.data(), static_cast<std::size_t>(shapes.size()) * sizeof(float));
    archive.require(rates.allFinite() && rates.minCoeff() > 0 && shapes.allFinite());
    Eigen::MatrixXf& hot_pa = vibrations.hot_pa;
    auto places = static_cast<std::int32_t>(hot_pa.rows()),
         slowest = static_cast<std::int32_t>(hot_pa.cols());
    archiveAll(archive, places, slowest);
    archive.require(0 <= places && places <= VibrationModes::most_hot_places && 0 <= slowest &&
                    slowest <= modes.count);
    if (!archive.good()) return;
    if (Archive::reads) hot_pa.resize(places, slowest);
    archive.raw(hot_pa.data(), static_cast<std::size_t>(hot_pa.size()) * sizeof(float));
    archive.require(hot_pa.allFinite());
}

/// The lower half.
template <class Archive>
void archiveCompliance(Archive& archive, const SplineSpace& space, ComplianceMatrix& compliance) {
    const Eigen::Index size = 3L * space.function_count;
    // A larger one is never written.
    archive.require(size <= ReducedModelLimits{}.direct_unknowns);
    if (!archive.good()) return;
    Eigen::MatrixXf& entries = compliance.entries;
    if (Archive::reads) entries.resize(size, size);
    for (Eigen::Index column = 0; column < size; ++column)
        archive.raw(&entries(column, column), static_cast<std::size_t>(size - column) * sizeof(float));
    if (Archive::reads) entries.triangularView<Eigen::StrictlyUpper>() = entries.transpose();
    archive.require(entries.allFinite());
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
        bool has_area = !point.area.isZero(0);
        sherd::archive(archive, has_area);
        if (has_area) sherd::archive(archive, point.area);
        archive.require(areFinite(point.area));
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
    VibrationModes vibrations;
    ComplianceMatrix compliance;
    ReducedModelLimits limits;
    bool is_direct = false;
    ReadingPoints points;
    PeakTable peaks;
    std::vector<std::string> warnings;
    if (written) {
        const auto& [model, reading, table, trust] = *written;
        stiffness = model.stiffness();
        modes = model.modes();
        vibrations = model.vibrations();
        compliance = model.compliance();
        limits = model.limits();
        is_direct = model.isDirect();
        points = reading.points();
        peaks = table;
        warnings = trust;
    }
    const auto made =
        archiveProblem(archive, sampling, material, written ? &written->model.problem() : nullptr);
    if (Archive::reads && !made) return nullptr;
    const SplineProblem& problem = written ? written->model.problem() : *made;
    auto& [patches, mode_limit, local_functions, direct_unknowns] = limits;
    archiveAll(archive, patches, mode_limit, local_functions, direct_unknowns, is_direct, peaks.levels,
               warnings);
    archive.require(local_functions > 0);
    if (is_direct) {
        archiveCompliance(archive, *problem.space, compliance);
    } else {
        archiveStiffness(archive, problem.space->function_count, stiffness);
    }
    bool has_modes = modes.count > 0;  // a small solid may do without
    sherd::archive(archive, has_modes);
    archive.require(has_modes || is_direct);
    if (has_modes) {
        archiveModes(archive, *problem.space, modes);
        archiveVibrations(archive, modes, vibrations);
    }
    archivePoints(archive, *sampling, points);
    if (!archive.good()) return nullptr;
    StressBounds bounds = written
                              ? written->reading.bounds()
                              : StressBounds(problem.parts(), problem.space->degree, problem.elasticity, {});
    bounds.archiveBoxes(archive);
    if (!Archive::reads || !archive.good()) return nullptr;
    ReducedModel model =
        is_direct ? ReducedModel(made, std::move(compliance), std::move(modes), std::move(vibrations))
                  : ReducedModel(made, std::move(stiffness), std::move(modes), std::move(vibrations), limits);
    return std::make_shared<const ReducedStress>(
        ReducedStress{std::move(model), DamageReading(made, std::move(points), std::move(bounds)),
                      std::move(peaks), std::move(warnings)});
}

}  // namespace sherd
