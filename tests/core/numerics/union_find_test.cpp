#include "core/numerics/union_find.h"

#include <gtest/gtest.h>

namespace {

using namespace sherd;

TEST(UnionFind, TheRootIsTheLowestMemberInWhateverOrder) {
    const std::vector<int> expected = {0, 1, 0, 0, 1, 5};
    UnionFind forward(6), backward(6);
    forward.unite(0, 2);
    forward.unite(2, 3);
    forward.unite(1, 4);
    backward.unite(4, 1);
    backward.unite(3, 2);
    backward.unite(2, 0);
    EXPECT_EQ(forward.roots(), expected);
    EXPECT_EQ(backward.roots(), expected);
    EXPECT_TRUE(forward.isRoot(1));
    EXPECT_FALSE(forward.isRoot(4));
}

TEST(UnionFind, UnitingIntoASetKeepsItsRoot) {
    UnionFind sets(5);
    sets.uniteInto(4, 0);
    sets.uniteInto(0, 2);
    EXPECT_EQ(sets.roots(), (std::vector<int>{4, 1, 4, 3, 4}));
    sets.uniteInto(3, 2);
    EXPECT_EQ(sets.roots(), (std::vector<int>{3, 1, 3, 3, 3}));
}

}  // namespace
