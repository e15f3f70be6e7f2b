#pragma once

#include <gtest/gtest.h>

#include "support/shapes.h"

/// Bodies that are cut many times.
namespace sherd::fragment_support {

struct SweptBody {
    const char* name;
    TriangleMesh (*mesh)();
    double spacing;  // of the particles, m
};

inline TriangleMesh plate() {
    return shapes::slab({1, 1, 0.09}, 24, 24, 3);
}

inline TriangleMesh coffeeCup() {
    const auto cup = readObj(SHERD_ASSETS "/coffee_cup.obj");
    EXPECT_TRUE(cup) << cup.error();
    return cup ? cup.value() : TriangleMesh();
}

// Walls thinner than the particles are apart.
inline TriangleMesh thinBowl() {
    return shapes::bowl(0.08, 0.003, 48, 16);
}

}  // namespace sherd::fragment_support
