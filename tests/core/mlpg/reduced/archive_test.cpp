#include "core/mlpg/reduced/archive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/mlpg/reduced/reduced_support.h"

namespace sherd {
namespace {

struct ReducedArchive : testing::Test {
    static const BothSolutions& wall() {
        static const BothSolutions both = bothSolutions(obliqueWall(), 0.03);
        return both;
    }
    const SplineSpace& space = *wall().problem->space;
};

template <class ArchiveIt>
std::vector<std::byte> written(const ArchiveIt& archiveIt) {
    ByteWriter writer;
    archiveIt(writer);
    EXPECT_TRUE(writer.good());
    return writer.bytes();
}

template <class ArchiveIt>
bool isRead(const std::vector<std::byte>& bytes, const ArchiveIt& archiveIt) {
    ByteReader reader(bytes.data(), bytes.size());
    archiveIt(reader);
    return reader.good() && reader.left() == 0;
}

/// Whether it is read as it was written, and no longer with what is not finite in the place of `number`.
template <class ArchiveIt>
void expectRefusedIfNotFinite(float number, const ArchiveIt& archiveIt) {
    const std::vector<std::byte> bytes = written(archiveIt);
    EXPECT_TRUE(isRead(bytes, archiveIt));
    std::array<std::byte, sizeof number> own;
    std::memcpy(own.data(), &number, sizeof number);
    const auto at = std::search(bytes.begin(), bytes.end(), own.begin(), own.end());
    ASSERT_NE(at, bytes.end());
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::vector<std::byte> changed = bytes;
        std::memcpy(changed.data() + (at - bytes.begin()), &wrong, sizeof wrong);
        EXPECT_FALSE(isRead(changed, archiveIt)) << wrong << " in the place of " << number;
    }
}

TEST_F(ReducedArchive, StiffnessComesBack) {
    const PackedStiffness& stiffness = wall().reduced.model.stiffness();
    PackedStiffness copy = stiffness, back;
    const auto bytes = written([&](auto& archive) { archiveStiffness(archive, space.function_count, copy); });
    EXPECT_LT(bytes.size(), 0.95 * 2 * stiffness.entries.size()) << "most blocks take fewer bits";
    ASSERT_TRUE(isRead(bytes, [&](auto& archive) { archiveStiffness(archive, space.function_count, back); }));
    EXPECT_EQ(back.starts, stiffness.starts);
    EXPECT_EQ(back.rows, stiffness.rows);
    EXPECT_EQ(back.entries, stiffness.entries);
    EXPECT_EQ(back.roots, stiffness.roots);
}

TEST_F(ReducedArchive, ModesComeBack) {
    const ProperModes& modes = wall().reduced.model.modes();
    ProperModes copy = modes, back;
    const auto bytes = written([&](auto& archive) { archiveModes(archive, space, copy); });
    ASSERT_TRUE(isRead(bytes, [&](auto& archive) { archiveModes(archive, space, back); }));
    EXPECT_EQ(back.count, modes.count);
    EXPECT_EQ(back.entries, modes.entries);
    EXPECT_EQ(back.scales, modes.scales);
    EXPECT_EQ(back.unit_starts, modes.unit_starts);
    EXPECT_EQ(back.combinations, modes.combinations);
    EXPECT_EQ(back.combination_scales, modes.combination_scales);
    EXPECT_EQ(back.accelerations, modes.accelerations);
    ASSERT_EQ(back.unit_loads.size(), modes.unit_loads.size());
    for (std::size_t i = 0; i < modes.unit_loads.size(); ++i) {
        EXPECT_EQ(back.unit_loads[i].patch, modes.unit_loads[i].patch);
        EXPECT_EQ(back.unit_loads[i].value, modes.unit_loads[i].value);
    }
}

TEST(ReducedArchiveOfRubber, StressIsReadAsBefore) {
    const BothSolutions both = bothSolutions(obliqueWall(), 0.03, {}, rubberLike());
    const SplineProblem& problem = *both.problem;
    ByteWriter writer;
    archiveProblem(writer, both.solid, rubberLike(), &problem);
    ASSERT_TRUE(writer.good());
    ByteReader reader(writer.bytes().data(), writer.bytes().size());
    const auto back = archiveProblem(reader, both.solid, rubberLike(), nullptr);
    ASSERT_TRUE(back && reader.good() && reader.left() == 0);
    ASSERT_TRUE(back->projection);
    Eigen::MatrixXf own(6, problem.space->raw_count);
    for (int f = 0; f < own.cols(); ++f)
        for (int k = 0; k < 6; ++k) own(k, f) = std::sin(static_cast<float>(7 * f + k));
    EXPECT_EQ(back->projection->dilatation<float>(own), problem.projection->dilatation<float>(own));

    for (const std::size_t cut : {writer.bytes().size() / 2, writer.bytes().size() - 1}) {
        ByteReader short_of(writer.bytes().data(), cut);
        EXPECT_FALSE(archiveProblem(short_of, both.solid, rubberLike(), nullptr) && short_of.good());
    }
}

TEST_F(ReducedArchive, NumbersThatAreNotFiniteAreRefused) {
    const ProperModes& modes = wall().reduced.model.modes();
    const auto archiveCopyOfModes = [&](auto& archive) {
        ProperModes copy = modes;
        archiveModes(archive, space, copy);
    };
    for (const float number : {modes.scales[3], modes.combination_scales[3], modes.accelerations[3],
                               modes.unit_loads.back().value})
        expectRefusedIfNotFinite(number, archiveCopyOfModes);
    expectRefusedIfNotFinite(wall().reduced.model.stiffness().roots[3], [&](auto& archive) {
        PackedStiffness copy = wall().reduced.model.stiffness();
        archiveStiffness(archive, space.function_count, copy);
    });
    const auto archiveCopyOfBoxes = [&](auto& archive) {
        StressBounds copy = wall().reduced.reading.bounds();
        copy.archiveBoxes(archive);
    };
    const auto boxes = written(archiveCopyOfBoxes);
    float first = 0;
    std::memcpy(&first, boxes.data(), sizeof first);
    expectRefusedIfNotFinite(first, archiveCopyOfBoxes);
}

TEST_F(ReducedArchive, PeaksThatAreNotFiniteAreRefused) {
    PeakTable::Patch patch;
    patch.middle = {1.1f, 1.2f, 1.3f};
    patch.inward = {0.36f, 0.48f, 0.8f};
    patch.compliance_m_n = 1.4f;
    patch.work_scale = 1.6f;
    const PeakTable::Level level{1.7f, 1.8f, 1.9f, {patch}};
    for (const float number : {patch.middle.z(), patch.inward.x(), patch.compliance_m_n, patch.work_scale,
                               level.radius_m, level.reach_m, level.unit_pa_n})
        expectRefusedIfNotFinite(number, [&](auto& archive) {
            PeakTable::Level copy = level;
            archiveAll(archive, copy);
        });
}

}  // namespace
}  // namespace sherd
