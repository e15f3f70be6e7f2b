#include "core/archive/checked_file.h"

#include <gtest/gtest.h>

#ifdef __linux__
#include <sys/stat.h>
#endif

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "support/temporary_path.h"

namespace {

using namespace sherd;

const FileFormat format{"test-it!", 3, "test file", "make it again"};

std::vector<std::byte> content() {
    std::vector<std::byte> bytes;
    for (int i = 0; i < 300; ++i) bytes.push_back(static_cast<std::byte>(7 * i));
    return bytes;
}

std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& bytes, const std::string& path) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// A sentence that names the file, what is wrong with it, and what to do.
void expectSentence(const std::string& path, const std::string& words) {
    const std::string sentence = readChecked(format, path).error();
    EXPECT_EQ(sentence.find(path), 0u) << sentence;
    EXPECT_NE(sentence.find(words), std::string::npos) << words << ": " << sentence;
    EXPECT_NE(sentence.find("; make it again."), std::string::npos) << sentence;
}

/// How many files there are whose names begin with that of `path`, itself left out.
int filesBeside(const std::string& path) {
    const std::filesystem::path whole(path);
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(whole.parent_path()))
        count += entry.path() != whole &&
                 entry.path().filename().string().rfind(whole.filename().string() + ".", 0) == 0;
    return count;
}

#ifdef __linux__
TEST(CheckedFile, LinksStayAndWhatIsNoFileIsLeftAlone) {
    const std::string file = temporaryPath("linked"), link = temporaryPath("link"),
                      pipe = temporaryPath("pipe");
    put("old", file);
    std::filesystem::remove(link);
    std::filesystem::create_symlink(file, link);
    ASSERT_TRUE(writeChecked(format, content(), link).ok());
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_TRUE(readChecked(format, file).ok());
    std::filesystem::remove(file);  // a link to nothing yet
    ASSERT_TRUE(writeChecked(format, content(), link).ok());
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_TRUE(readChecked(format, file).ok());
    std::filesystem::remove(link);
    std::filesystem::create_symlink(link, link);
    EXPECT_FALSE(writeChecked(format, content(), link).ok());
    std::filesystem::remove(link);
    std::filesystem::remove(file);
    std::filesystem::remove(pipe);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const Status written = writeChecked(format, content(), pipe);
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().find(pipe), std::string::npos) << written.error();
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    std::filesystem::remove(pipe);
}
#endif

TEST(CheckedFile, WhatWasWrittenIsRead) {
    const std::string path = temporaryPath("file");
    ASSERT_TRUE(writeChecked(format, content(), path).ok());
    const auto read = readChecked(format, path);
    ASSERT_TRUE(read.ok()) << read.error();
    const auto expected = content();
    ASSERT_EQ(read.value().size, expected.size());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), read.value().bytes.get()));
    EXPECT_EQ(filesBeside(path), 0);
}

TEST(CheckedFile, EveryKindOfWrongFileHasItsSentence) {
    const std::string path = temporaryPath("file"), wrong = temporaryPath("wrong");
    ASSERT_TRUE(writeChecked(format, content(), path).ok());
    const std::string whole = bytesOf(path);

    put("", wrong);
    expectSentence(wrong, "is empty");
    put(whole.substr(0, 20), wrong);
    expectSentence(wrong, "is cut short: it ends within its header");
    put(whole.substr(0, 32), wrong);
    expectSentence(wrong, "is cut short: it has 0 bytes after its header, of 300");
    put(whole.substr(0, 331), wrong);
    expectSentence(wrong, "is cut short: it has 299 bytes after its header, of 300");
    put(whole + "x", wrong);
    expectSentence(wrong, "goes on behind its end: it has 301 bytes after its header");
    put(std::string(400, 'v'), wrong);
    expectSentence(wrong, "is no test file");
    std::string other = whole;
    other[8] = 4;
    put(other, wrong);
    expectSentence(wrong, "has version 4 of the format of a test file, and this program reads version 3");
    std::filesystem::remove(wrong);
    expectSentence(wrong, "is missing");
    std::filesystem::create_directory(wrong);
    expectSentence(wrong, "is a folder, not a test file");
    std::filesystem::remove(wrong);
}

TEST(CheckedFile, OneByteChangedAnywhereIsSeen) {
    const std::string path = temporaryPath("file"), wrong = temporaryPath("wrong");
    ASSERT_TRUE(writeChecked(format, content(), path).ok());
    const std::string whole = bytesOf(path);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ (1 << at % 8));
        put(changed, wrong);
        EXPECT_FALSE(readChecked(format, wrong).ok()) << "byte " << at;
    }
    std::string changed = whole;
    changed[100] ^= 1;
    put(changed, wrong);
    expectSentence(wrong, "was changed since it was written");
}

TEST(CheckedFile, ManyMayWriteToOnePathAtOnce) {
    const std::string path = temporaryPath("file");
    std::atomic<int> failed{0};
    const auto writeAgainAndAgain = [&](std::byte filled, std::size_t size) {
        const std::vector<std::byte> bytes(size, filled);
        for (int i = 0; i < 60; ++i)
            failed += !writeChecked(format, bytes, path) || !readChecked(format, path);
    };
    std::thread other([&] { writeAgainAndAgain(std::byte{1}, 2000000); });
    writeAgainAndAgain(std::byte{2}, 3000000);
    other.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(filesBeside(path), 0);
}

TEST(CheckedFile, AFileThatCannotBeWrittenLeavesNothing) {
    const std::string nowhere = temporaryPath("no_such_folder") + "/file";
    const Status status = writeChecked(format, content(), nowhere);
    EXPECT_NE(status.error().find("Cannot write " + nowhere + ";"), std::string::npos) << status.error();
    const std::string folder = temporaryPath("folder");
    std::filesystem::create_directories(folder + "/inside");
    EXPECT_FALSE(writeChecked(format, content(), folder).ok());
    EXPECT_EQ(filesBeside(folder), 0);
    EXPECT_TRUE(std::filesystem::exists(folder + "/inside"));
    std::filesystem::remove_all(folder);
}

}  // namespace
