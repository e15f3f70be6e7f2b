#include <limits>

#include "core/sampling/sampling_support.h"

namespace sherd {
namespace {

std::string sentence(const TriangleMesh& mesh, double spacing, const SamplingSettings& settings = {}) {
    const Result<Discretisation> result = sampleSolid(mesh, spacing, settings);
    EXPECT_FALSE(result.ok());
    return result.error();
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

TEST(SamplingErrors, OpenSurface) {
    // Each triangle in turn is the one that is missing.
    for (const TriangleMesh& whole : {shapes::slab({1, 1, 1}), shapes::icosphere(0.5, 1)})
        for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
            TriangleMesh open = whole;
            open.triangles.erase(open.triangles.begin() + long(t));
            EXPECT_TRUE(contains(sentence(open, 0.2), "The surface is not closed near")) << t;
        }
}

TEST(SamplingErrors, InsideOut) {
    EXPECT_TRUE(
        contains(sentence(shapes::inverted(shapes::icosphere(0.5, 2)), 0.1), "The surface is inside out"));
}

TEST(SamplingErrors, OverlappingParts) {
    const TriangleMesh two =
        shapes::joined(shapes::icosphere(0.5, 2), shapes::translated(shapes::icosphere(0.5, 2), {0.3, 0, 0}));
    EXPECT_TRUE(contains(sentence(two, 0.1), "Parts of the solid overlap"));
}

TEST(SamplingErrors, TooFineAGridNamesASpacingThatWillDo) {
    const TriangleMesh box = shapes::slab({1, 1, 1});
    EXPECT_TRUE(contains(sentence(box, 1e-5), "use a spacing of at least"));
    const std::string text = sentence(box, 0.008);
    const std::size_t start = text.find("at least ") + 9;
    const double enough = std::stod(text.substr(start));
    EXPECT_GT(enough, 0.008);
    EXPECT_LT(enough, 0.03);
    const TriangleMesh far_apart = shapes::joined(
        shapes::slab({0.1, 0.1, 0.1}), shapes::translated(shapes::slab({0.1, 0.1, 0.1}), {50, 50, 50}));
    EXPECT_TRUE(contains(sentence(far_apart, 0.05), "over its bounding box"));
    EXPECT_TRUE(contains(sentence(shapes::slab({1e300, 1, 1}), 1e-300), "more than the limit"));
}

TEST(SamplingErrors, EmptyAndImpossibleInput) {
    const TriangleMesh box = shapes::slab({1, 1, 1});
    EXPECT_TRUE(contains(sentence({}, 0.1), "no triangles"));
    for (const double spacing :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(contains(sentence(box, spacing), "positive length"));
    TriangleMesh bad = box;
    bad.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(contains(sentence(bad, 0.1), "Vertex 3 "));
    bad = box;
    bad.triangles[2][1] = 99;
    EXPECT_TRUE(contains(sentence(bad, 0.1), "does not exist"));
    SamplingSettings settings;
    settings.cells_per_spacing = 5;
    EXPECT_TRUE(contains(sentence(box, 0.1, settings), "cells_per_spacing is 5 but must be between 1 and 4"));
}

TEST(SamplingErrors, FlatSurfaceHasNoSolid) {
    TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    flat.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_TRUE(contains(sentence(flat, 0.1), "encloses no volume"));
}

}  // namespace
}  // namespace sherd
