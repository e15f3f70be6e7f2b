#include "core/clustering/merge_labels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace sherd;

/// A row of cubes of volume 1, one particle and one label each, that share a face of area `i + 1` between i
/// and i + 1.
Discretisation row(const std::vector<double>& volumes) {
    Discretisation solid;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        solid.particles.push_back({Vec3(static_cast<double>(i), 0, 0), volumes[i], 1});
        solid.cells.push_back({{}, static_cast<int>(i)});
        const int n = static_cast<int>(i);
        if (i > 0) solid.faces.push_back({{n - 1, n}, Vec3(n, 0, 0), Vec3::Zero()});
    }
    return solid;
}

FragmentLabels each(int count) {
    FragmentLabels labels;
    labels.count = count;
    for (int i = 0; i < count; ++i) labels.of_particle.push_back(i);
    return labels;
}

TEST(MergeLabels, NothingSmallNothingMerged) {
    FragmentLabels labels = each(4);
    mergeSmallest(row({1, 2, 3, 4}), 1, 4, labels);
    EXPECT_EQ(labels.of_particle, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(labels.count, 4);
}

TEST(MergeLabels, TheSmallJoinWhomTheyShareMostWith) {
    FragmentLabels labels = each(5);
    mergeSmallest(row({4, 4, 0.5, 4, 4}), 1, 10, labels);  // faces of area 2 and 3 beside the small one
    EXPECT_EQ(labels.of_particle, (std::vector<int>{0, 1, 2, 2, 3}));
    EXPECT_EQ(labels.count, 4);
}

TEST(MergeLabels, AChainOfSmallOnesGrowsUntilItIsLargeEnough) {
    FragmentLabels labels = each(6);
    mergeSmallest(row({0.5, 0.5, 0.5, 0.5, 0.5, 0.5}), 0.9, 10, labels);
    EXPECT_EQ(labels.count, 3);
    for (int label = 0; label < labels.count; ++label)
        EXPECT_GE(std::count(labels.of_particle.begin(), labels.of_particle.end(), label), 2);
}

TEST(MergeLabels, TheSmallestGoUntilFewEnoughAreLeft) {
    FragmentLabels labels = each(6);
    mergeSmallest(row({9, 1, 8, 2, 7, 3}), 0, 3, labels);
    EXPECT_EQ(labels.count, 3);
    EXPECT_EQ(labels.of_particle[1], labels.of_particle[2]);
    EXPECT_EQ(labels.of_particle[3], labels.of_particle[4]);
    EXPECT_EQ(labels.of_particle[5], labels.of_particle[4]);
}

TEST(MergeLabels, WhatTouchesNothingStays) {
    FragmentLabels labels = each(2);
    Discretisation apart = row({1, 1});
    apart.faces.clear();
    mergeSmallest(apart, 5, 1, labels);
    EXPECT_EQ(labels.count, 2);
}

}  // namespace
