#include "core/archive/archive.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/archive/fields.h"
#include "core/archive/mesh.h"
#include "support/altered_fields.h"

namespace sherd {

struct Nested {
    std::vector<double> numbers;
    std::string text;
    bool flag = false;
};

template <class Archive>
void archiveFields(Archive& archive, Nested& nested) {
    auto& [numbers, text, flag] = nested;
    archiveAll(archive, numbers, text, flag);
}

namespace {

template <class Value>
std::vector<std::byte> written(Value value) {
    ByteWriter writer;
    archive(writer, value);
    EXPECT_TRUE(writer.good());
    return writer.bytes();
}

/// Whether the bytes are those of a value, all of them.
template <class Value>
bool read(const std::vector<std::byte>& bytes, Value& value) {
    ByteReader reader(bytes.data(), bytes.size());
    archive(reader, value);
    return reader.good() && reader.left() == 0;
}

TEST(Archive, WhatWasWrittenIsRead) {
    const double odd = std::nextafter(0.1, 1);
    const std::vector<Nested> list = {{{odd, -0.0, std::numeric_limits<double>::infinity()}, "cup", true},
                                      {{}, "", false},
                                      {{1e-310}, std::string("a\0b", 3), true}};
    std::vector<Nested> back(7);
    ASSERT_TRUE(read(written(list), back));
    ASSERT_EQ(back.size(), list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(back[i].numbers, list[i].numbers);
        EXPECT_EQ(back[i].text, list[i].text);
        EXPECT_EQ(back[i].flag, list[i].flag);
    }
    EXPECT_TRUE(std::signbit(back[0].numbers[1]));

    Eigen::Matrix4Xd matrix = Eigen::Matrix4Xd::Random(4, 5), matrix_back;
    ASSERT_TRUE(read(written(matrix), matrix_back));
    EXPECT_EQ(matrix, matrix_back);
}

TEST(Archive, SettingsKeepEveryField) {
    Settings settings;
    alterFields(settings);
    settings.sampling.moment_order = 6;
    Settings back;
    ASSERT_TRUE(read(written(settings), back));
    EXPECT_EQ(valuesOf(back), valuesOf(settings));
    Material material;
    alterFields(material);
    Material material_back;
    ASSERT_TRUE(read(written(material), material_back));
    EXPECT_EQ(valuesOf(material_back), valuesOf(material));
}

TEST(Archive, BytesThatEndEarlyAreRefusedWhereverTheyEnd) {
    const std::vector<Nested> list = {{{1, 2}, "cup", true}, {{3}, "plate", false}};
    const std::vector<std::byte> bytes = written(list);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        std::vector<Nested> back;
        EXPECT_FALSE(read(std::vector<std::byte>(bytes.begin(), bytes.begin() + long(size)), back)) << size;
    }
}

TEST(Archive, ASizeThatCannotBeAllocatesNothing) {
    const std::vector<std::byte> bytes(100, std::byte{0xff});
    std::vector<std::array<double, 3>> numbers;
    std::vector<Nested> nested;
    std::string text;
    EXPECT_FALSE(read(bytes, numbers));
    EXPECT_FALSE(read(bytes, nested));
    EXPECT_FALSE(read(bytes, text));
    EXPECT_EQ(numbers.capacity() + nested.capacity(), 0u);
    bool flag = false;
    EXPECT_FALSE(read({std::byte{2}}, flag));
}

TEST(Archive, IndicesTakeTheBytesThatTheyNeed) {
    for (const auto& [end, bytes] : {std::pair{256, 1}, {257, 2}, {65536, 2}, {65537, 4}}) {
        std::vector<int> list = {0, end - 1, end / 2};
        ByteWriter writer;
        archiveIndices(writer, list, end);
        EXPECT_EQ(writer.bytes().size(), sizeof(std::uint32_t) + 3u * static_cast<unsigned>(bytes));
        ByteReader reader(writer.bytes().data(), writer.bytes().size());
        std::vector<int> back;
        archiveIndices(reader, back, end);
        EXPECT_TRUE(reader.good());
        EXPECT_EQ(back, list);
    }
    ByteWriter writer;
    int none = -1;
    archiveIndex(writer, none, 10, -1);
    ByteReader reader(writer.bytes().data(), writer.bytes().size());
    int back = 5;
    archiveIndex(reader, back, 10, -1);
    EXPECT_TRUE(reader.good());
    EXPECT_EQ(back, -1);
}

TEST(Archive, IndicesOutOfRangeAreNeitherWrittenNorRead) {
    for (const int wrong : {-1, 10, std::numeric_limits<int>::max()}) {
        ByteWriter writer;
        int index = wrong;
        archiveIndex(writer, index, 10);
        EXPECT_FALSE(writer.good()) << wrong;
    }
    const std::byte eleven{11};
    ByteReader reader(&eleven, 1);
    int index = 0;
    archiveIndex(reader, index, 10);
    EXPECT_FALSE(reader.good());
    EXPECT_EQ(index, 0);
}

TEST(Archive, AMeshKeepsWhatItLooksLike) {
    TriangleMesh mesh;
    for (int v = 0; v < 300; ++v) mesh.vertices.push_back(Vec3::Random());
    mesh.triangles = {{0, 1, 299}, {7, 8, 9}};
    mesh.kinds = {SurfaceKind::crack, SurfaceKind::original};
    mesh.file_faces = {70000, 3};
    mesh.texture_coordinates.resize(2);
    mesh.normals.resize(2);
    for (int c = 0; c < 3; ++c) {
        mesh.texture_coordinates[1][c] = Vec2(c, 0.1);
        mesh.normals[0][c] = Vec3::Unit(c);
        mesh.normals[1][c] = Vec3::Zero();
        mesh.texture_coordinates[0][c] = Vec2::Zero();
    }
    mesh.material = {1, 0};
    mesh.materials = {"glaze", "crack"};
    mesh.colours.assign(300, Vec3(0.1, 0.2, 0.3));

    TriangleMesh back;
    ASSERT_TRUE(read(written(mesh), back));
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.triangles, mesh.triangles);
    EXPECT_EQ(back.kinds, mesh.kinds);
    EXPECT_EQ(back.file_faces, mesh.file_faces);
    EXPECT_EQ(back.texture_coordinates, mesh.texture_coordinates);
    EXPECT_EQ(back.normals, mesh.normals);
    EXPECT_EQ(back.material, mesh.material);
    EXPECT_EQ(back.materials, mesh.materials);
    EXPECT_EQ(back.colours, mesh.colours);

    mesh.colours.pop_back();
    ByteWriter writer;
    archive(writer, mesh);
    EXPECT_FALSE(writer.good()) << "299 colours for 300 vertices";
}

}  // namespace
}  // namespace sherd
