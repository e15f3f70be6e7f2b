// An animated glTF, read back by another reader and looked at number by number.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "film/gltf_file.h"
#include "struck_wall.h"
#include "support/temporary_path.h"

namespace {

using namespace demo;
using nlohmann::json;

/// The parts of a binary glTF.
struct Glb {
    json document;
    std::string buffer;

    explicit Glb(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        const std::string all((std::istreambuf_iterator<char>(in)), {});
        EXPECT_EQ(all.substr(0, 4), "glTF");
        EXPECT_EQ(numberAt(all, 4), 2u);
        EXPECT_EQ(numberAt(all, 8), all.size());
        const std::size_t json_size = numberAt(all, 12);
        EXPECT_EQ(all.substr(16, 4), "JSON");
        document = json::parse(all.substr(20, json_size));
        EXPECT_EQ(all.substr(24 + json_size, 4), std::string("BIN\0", 4));
        EXPECT_EQ(json_size % 4, 0u);
        buffer = all.substr(28 + json_size);
        EXPECT_EQ(numberAt(all, 20 + json_size), buffer.size());
    }
    std::vector<float> floats(int accessor) const {
        const json& said = document.at("accessors").at(accessor);
        const json& view = document.at("bufferViews").at(said.at("bufferView").get<std::size_t>());
        std::vector<float> values(view.at("byteLength").get<std::size_t>() / sizeof(float));
        std::memcpy(values.data(), buffer.data() + view.at("byteOffset").get<std::size_t>(),
                    values.size() * sizeof(float));
        return values;
    }
    static std::uint32_t numberAt(const std::string& bytes, std::size_t place) {
        std::uint32_t number = 0;
        std::memcpy(&number, bytes.data() + place, sizeof number);
        return number;
    }
};

int componentsOf(const std::string& type) {
    return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
}

/// A run and the file that was made of it.
struct Written {
    Scene scene = struckWall();
    SceneRun run = runOf(scene);
    std::string path = temporaryPath("struck_wall.glb");

    Written() { EXPECT_TRUE(writeGltf(run.tracks, path).ok()); }
    ~Written() { std::remove(path.c_str()); }
};

/// Built once: a run takes half a second.
const Written& written() {
    static const Written only;
    return only;
}

TEST(Gltf, EveryAccessorFitsItsViewAndEveryViewTheBuffer) {
    const Glb glb(written().path);
    EXPECT_EQ(glb.document["asset"]["version"], "2.0");
    const std::size_t size = glb.document["buffers"][0]["byteLength"];
    EXPECT_LE(size, glb.buffer.size());
    ASSERT_GT(glb.document["accessors"].size(), 10u);
    for (const json& accessor : glb.document["accessors"]) {
        const json& view = glb.document["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
        const std::size_t count = accessor["count"], offset = view["byteOffset"], length = view["byteLength"];
        EXPECT_GT(count, 0u);
        EXPECT_EQ(count * componentsOf(accessor["type"]) * 4, length);
        EXPECT_EQ(offset % 4, 0u);
        EXPECT_LE(offset + length, size);
    }
}

TEST(Gltf, TimesRiseAndTurnsAreUnitQuaternions) {
    const Written& file = written();
    const Glb glb(file.path);
    const json& animation = glb.document["animations"].at(0);
    ASSERT_GT(animation["channels"].size(), 1u);
    for (const json& channel : animation["channels"]) {
        const json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
        const std::vector<float> times = glb.floats(sampler["input"]), values = glb.floats(sampler["output"]);
        const std::string path = channel["target"]["path"];
        EXPECT_EQ(values.size(), times.size() * (path == "rotation" ? 4 : 3));
        EXPECT_EQ(sampler["interpolation"], path == "scale" ? "STEP" : "LINEAR");
        for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LT(times[i - 1], times[i]);
        EXPECT_GE(times.front(), 0);
        EXPECT_LE(times.back(), file.scene.duration_s + 1e-6);
        for (std::size_t i = 0; path == "rotation" && i < values.size(); i += 4)
            EXPECT_NEAR(std::hypot(std::hypot(values[i], values[i + 1], values[i + 2]), values[i + 3]), 1,
                        1e-5);
    }
}

TEST(Gltf, AnotherReaderFindsEveryBodyWhereItWas) {
    const Written& file = written();
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.path, aiProcess_ValidateDataStructure);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumAnimations, 1u);
    EXPECT_EQ(scene->mRootNode->mNumChildren, file.run.tracks.size() + 1) << "and the floor";
    const aiAnimation& animation = *scene->mAnimations[0];
    const double ticks = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 1;
    EXPECT_NEAR(animation.mDuration / ticks, file.scene.duration_s, 1e-4);
    std::map<std::string, const aiNodeAnim*> moved;
    for (unsigned i = 0; i < animation.mNumChannels; ++i)
        moved[animation.mChannels[i]->mNodeName.C_Str()] = animation.mChannels[i];
    for (std::size_t i = 0; i < file.run.tracks.size(); ++i) {
        const Track& track = file.run.tracks[i];
        const aiNode& node = *scene->mRootNode->mChildren[i + 1];
        ASSERT_TRUE(moved.count(node.mName.C_Str())) << node.mName.C_Str();
        const aiNodeAnim& channel = *moved[node.mName.C_Str()];
        const aiVector3D last = channel.mPositionKeys[channel.mNumPositionKeys - 1].mValue;
        EXPECT_LT((Vec3(last.x, last.y, last.z) - track.keys.back().placed.translation()).norm(), 1e-5);
        unsigned faces = 0;
        for (unsigned m = 0; m < node.mNumMeshes; ++m) faces += scene->mMeshes[node.mMeshes[m]]->mNumFaces;
        if (track.body.asset) {
            EXPECT_EQ(faces, track.body.asset->surface().triangles.size());
        }
    }
}

TEST(Gltf, FragmentsAppearWhenTheWholeBodyGoes) {
    const Glb glb(written().path);
    const json& animation = glb.document["animations"].at(0);
    std::map<std::string, std::vector<float>> times, sizes;
    for (const json& channel : animation["channels"]) {
        if (channel["target"]["path"] != "scale") continue;
        const json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
        const std::string node =
            glb.document["nodes"].at(channel["target"]["node"].get<std::size_t>())["name"];
        times[node] = glb.floats(sampler["input"]);
        sizes[node] = glb.floats(sampler["output"]);
    }
    ASSERT_EQ(sizes.at("body_1"), (std::vector<float>{1, 1, 1, 0, 0, 0}));
    EXPECT_EQ(sizes.at("fragment_3"), (std::vector<float>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(times.at("body_1").back(), times.at("fragment_3").back());
    EXPECT_EQ(sizes.count("ball_2"), 0u) << "it is always there";
}

TEST(Gltf, WhatBreaksInTheFirstStepIsNeverThere) {
    const SceneRun run = runOf(struckWall(0.001));
    ASSERT_TRUE(run.tracks.front().is_replaced);
    ASSERT_EQ(run.tracks.front().keys.size(), 1u);
    const std::string path = temporaryPath("first_step.glb");
    ASSERT_TRUE(writeGltf(run.tracks, path).ok());
    const Glb glb(path);
    std::remove(path.c_str());
    EXPECT_EQ(glb.document["nodes"][1]["scale"], (std::vector<int>{0, 0, 0}));
    EXPECT_FALSE(glb.document["nodes"][3].contains("scale"));
    EXPECT_EQ(glb.document["nodes"][3]["name"], "fragment_3");
    for (const json& channel : glb.document["animations"][0]["channels"])
        EXPECT_NE(channel["target"]["node"], 1);
}

TEST(Gltf, LightGoesThroughGlassAlone) {
    Scene scene = struckWall(5);
    scene.duration_s = 0.02;
    const auto clearIn = [](const Scene& one) {
        const std::string path = temporaryPath("clear.glb");
        EXPECT_TRUE(writeGltf(runOf(one).tracks, path).ok());
        const json document = Glb(path).document;
        std::remove(path.c_str());
        int clear = 0;
        for (const json& material : document["materials"]) {
            if (!material.contains("extensions")) continue;
            ++clear;
            EXPECT_GT(material["extensions"]["KHR_materials_transmission"]["transmissionFactor"], 0.5);
            EXPECT_EQ(document["extensionsUsed"], json::array({"KHR_materials_transmission"}));
        }
        EXPECT_EQ(document.contains("extensionsUsed"), clear > 0);
        return clear;
    };
    EXPECT_EQ(clearIn(scene), 0);
    scene.bodies[0].material = sherd::Material::glass();
    EXPECT_EQ(clearIn(scene), 1);
}

TEST(Gltf, SaysWhichFileCannotBeWritten) {
    const auto status = writeGltf(written().run.tracks, "/proc/nowhere/run.glb");
    ASSERT_FALSE(status.ok());
    EXPECT_NE(status.error().find("/proc/nowhere/run.glb"), std::string::npos) << status.error();
}

}  // namespace
