#include "core/mlpg/reduced/make_peak_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mlpg/reduced/peak_reading.h"

namespace sherd {

namespace {

constexpr double narrow = 0.25;  // radius of the narrow patches, in spacings: the grid tells no narrower load
constexpr double wide = 3;       // radius of the wide ones, in those that the modes were made of
constexpr int narrow_patches = 170, wide_patches = 80;
constexpr int narrow_edges = 60, even_edges = 30, wide_edges = 20;
constexpr double reach = 1.5;  // in radii of as many circles as there are patches

/// Patches of one radius with the coefficients of what unit loads on them do.
struct Group {
    double radius = 0;
    int on_faces = 0;  ///< the first ones; edges follow
    std::vector<PeakTable::Patch> patches;
    std::vector<std::vector<int>> far;  ///< parts under much stress
    Eigen::MatrixXf raw;                ///< 9 numbers a patch, a column a function
};

PeakTable::Patch placed(const UnitPatch& from) {
    PeakTable::Patch patch;
    patch.middle = from.middle.cast<float>();
    patch.inward = from.inward.cast<float>();
    patch.on_edge = from.on_edge;
    return patch;
}

using Work = Eigen::Matrix<float, PeakTable::modes, 3>;

void setWork(const Work& work, PeakTable::Patch& patch) {
    constexpr float most = 127;
    patch.work_scale = work.cwiseAbs().maxCoeff() / most;
    for (int i = 0; patch.work_scale > 0 && i < work.size(); ++i)
        patch.work[i] = static_cast<std::int8_t>(std::round(work.data()[i] / patch.work_scale));
}

/// The numbers of what 1 N on a patch does that say how soft it is.
void addSoftness(const UnitResponses& responses, int number, const ProperModes& modes,
                 PeakTable::Patch& patch) {
    Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero();
    Work work = Work::Zero();
    const int count = std::min(PeakTable::modes, modes.count);
    for (const auto& [function, value] : responses.loads[number]) {
        compliance += value * responses.displacements.block<3, 3>(3L * function, 3L * number);
        for (int k = 0; k < 3; ++k) {
            Eigen::VectorXf on_modes = Eigen::VectorXf::Zero(modes.count);
            modes.addWork(3 * function + k, static_cast<float>(value), on_modes);
            work.col(k).head(count) += on_modes.head(count);
        }
    }
    patch.compliance_m_n = static_cast<float>(compliance.norm());
    setWork(work, patch);
}

void append(const UnitResponses& responses, const std::vector<UnitPatch>& patches, const ProperModes& modes,
            const PeakReading& reading, Group& group) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
        group.patches.push_back(placed(patches[p]));
        addSoftness(responses, static_cast<int>(p), modes, group.patches.back());
    }
    const Eigen::MatrixXf more = reading.expand(responses.displacements);
    Eigen::MatrixXf all(group.raw.rows() + more.rows(), more.cols());
    all.topRows(group.raw.rows()) = group.raw;
    all.bottomRows(more.rows()) = more;
    group.raw = std::move(all);
}

/// The patch on a face that faces the same way, nearest to another one; its number.
int nearestTo(const PeakTable::Patch& patch, const Group& among) {
    float least = std::numeric_limits<float>::infinity();
    int nearest = 0;
    for (int p = 0; p < among.on_faces; ++p) {
        const PeakTable::Patch& other = among.patches[p];
        const float squared = (other.middle - patch.middle).squaredNorm();
        if (squared >= least || !(patch.inward.dot(other.inward) > 0)) continue;
        least = squared;
        nearest = p;
    }
    return nearest;
}

/// Where stress is large away from the load is a matter of the place, not of the patch.
void takeFarParts(const Group& from, Group& to) {
    while (to.far.size() < to.patches.size())
        to.far.push_back(from.far[nearestTo(to.patches[to.far.size()], from)]);
}

/// Loads on wide patches are the means of those on the even ones within.
Group widened(const Group& even, const std::vector<UnitPatch>& patches, double radius) {
    Group group;
    group.radius = radius;
    group.raw.setZero(9 * static_cast<Eigen::Index>(patches.size()), even.raw.cols());
    for (std::size_t w = 0; w < patches.size(); ++w) {
        PeakTable::Patch patch = placed(patches[w]);
        std::vector<int> within;
        for (int p = 0; p < even.on_faces; ++p)
            if ((even.patches[p].middle - patch.middle).norm() <= radius &&
                even.patches[p].inward.dot(patch.inward) > 0)
                within.push_back(p);
        if (within.empty()) within.push_back(nearestTo(patch, even));
        const float share = 1.0f / static_cast<float>(within.size());
        Work work = Work::Zero();
        for (const int p : within) {
            const PeakTable::Patch& other = even.patches[p];
            group.raw.middleRows<9>(9 * static_cast<Eigen::Index>(w)) +=
                share * even.raw.middleRows<9>(9L * p);
            patch.compliance_m_n = std::max(patch.compliance_m_n, other.compliance_m_n);
            for (int k = 0; k < 3; ++k) work.col(k) += share * other.workOf(Eigen::Vector3f::Unit(k));
        }
        setWork(work, patch);
        group.patches.push_back(patch);
    }
    return group;
}

PeakTable::Level levelOf(Group group, double reach_m, const PeakReading& reading) {
    const auto peaks = reading.read({group.raw, group.patches, group.far, group.radius});
    PeakTable::Level level;
    level.radius_m = static_cast<float>(group.radius);
    level.reach_m = static_cast<float>(reach_m);
    float largest = 0;
    for (const PeakReading::Peaks& of_patch : peaks)
        largest = std::max(largest, *std::max_element(of_patch.begin(), of_patch.end()));
    constexpr float octaves = 254.0f / PeakTable::steps_per_octave;
    level.unit_pa_n = largest * std::exp2(-octaves);
    for (std::size_t p = 0; p < peaks.size(); ++p)
        for (int d = 0; d < PeakTable::directions; ++d)
            group.patches[p].peaks[d] = level.numberOf(peaks[p][d]);
    level.patches = std::move(group.patches);
    return level;
}

}  // namespace

Result<PeakTable> makePeakTable(const SolvedPatches& solved, const std::vector<GridPoint>& samples,
                                const Material& material) {
    const Discretisation& solid = *solved.problem.solid;
    const PeakReading reading(solved.problem, samples, material);
    const auto responses = [&](const std::vector<UnitPatch>& patches) {
        return unitResponses(solved.problem, solved.factor, solved.pinned, patches);
    };
    Group even;
    even.on_faces = static_cast<int>(solved.patches.size());
    even.radius = evenRadius(solid, even.on_faces);
    append(solved.responses, solved.patches, solved.modes, reading, even);
    even.far = reading.mostStressedParts(even.raw);
    const auto edges = edgePatches(solid, even_edges, even.radius);
    if (!edges.empty()) {
        const auto of_edges = responses(edges);
        if (!of_edges) return Error{of_edges.error()};
        append(of_edges.value(), edges, solved.modes, reading, even);
    }
    std::vector<UnitPatch> at = unitPatches(solid, wide_patches, wide * even.radius);
    for (UnitPatch& patch : edgePatches(solid, wide_edges, wide * even.radius))
        at.push_back(std::move(patch));
    Group widest = widened(even, at, wide * even.radius);
    takeFarParts(even, widest);

    PeakTable table;
    Group narrowest;
    narrowest.radius = narrow * solid.spacing;
    if (narrowest.radius < even.radius) {
        at = unitPatches(solid, narrow_patches, narrowest.radius);
        for (UnitPatch& patch : edgePatches(solid, narrow_edges, narrowest.radius))
            at.push_back(std::move(patch));
        const auto of_narrow = responses(at);
        if (!of_narrow) return Error{of_narrow.error()};
        append(of_narrow.value(), at, solved.modes, reading, narrowest);
        takeFarParts(even, narrowest);
        table.levels.push_back(
            levelOf(std::move(narrowest), reach * evenRadius(solid, narrow_patches), reading));
    }
    takeFarParts(even, even);
    const double even_reach = reach * even.radius;
    table.levels.push_back(levelOf(std::move(even), even_reach, reading));
    table.levels.push_back(levelOf(std::move(widest), reach * evenRadius(solid, wide_patches), reading));
    return table;
}

}  // namespace sherd
