#include "core/archive/checked_file.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include "core/archive/checksum.h"

namespace sherd {

namespace {

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t zero;
    std::uint64_t size;
    std::uint64_t checksum;
};
static_assert(sizeof(Header) == 32);

std::uint64_t checksumOf(const Header& header, const std::byte* content, std::size_t size) {
    return checksum(content, size, checksum(&header, offsetof(Header, checksum)));
}

/// Whether this processor has the order of bytes that files have.
bool lowestByteIsFirst() {
    const std::uint32_t one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string otherOrder(const FileFormat& format) {
    return std::string("A ") + format.name +
           " holds numbers with their lowest byte first, and this processor has the highest first; use one "
           "with the other order.";
}

/// What is wrong with a header, as the rest of a sentence about the file; empty: nothing.
std::string faultOf(const FileFormat& format, const Header& header) {
    if (std::memcmp(header.magic, format.magic, sizeof header.magic) != 0)
        return std::string("is no ") + format.name + ": it does not begin like one";
    if (header.version != format.version)
        return "has version " + std::to_string(header.version) + " of the format of a " + format.name +
               ", and this program reads version " + std::to_string(format.version);
    return "";
}

/// A size in the file is believed only if the file is as large as that.
std::string faultOfSize(const Header& header, std::uintmax_t file_size) {
    const std::uintmax_t content = file_size - sizeof header;
    if (content == header.size) return "";
    if (content < header.size)
        return "is cut short: it has " + std::to_string(content) + " bytes after its header, of " +
               std::to_string(header.size);
    return "goes on behind its end: it has " + std::to_string(content) +
           " bytes after its header, where there should be " + std::to_string(header.size);
}

/// Of the file that was opened: another may have taken its path since. Leaves it at its beginning; -1 if the
/// size cannot be had.
long sizeOf(std::FILE* file) {
    if (std::fseek(file, 0, SEEK_END) != 0) return -1;
    const long size = std::ftell(file);
    return std::fseek(file, 0, SEEK_SET) == 0 ? size : -1;
}

/// A name that no other program and no other thread takes that writes to the same path at the same time.
std::string nameBeside(const std::string& path) {
    std::random_device random;
    return path + "." + std::to_string(random()) + "-" + std::to_string(random()) + ".unfinished";
}

bool writeAll(const Header& header, const std::vector<std::byte>& content, const std::string& path) {
    File file(std::fopen(path.c_str(), "wbx"));  // x: nobody else's
    bool done = file && std::fwrite(&header, sizeof header, 1, file.get()) == 1 &&
                std::fwrite(content.data(), 1, content.size(), file.get()) == content.size();
    if (file) done = std::fclose(file.release()) == 0 && done;  // what is buffered may fail only here
    return done;
}

}  // namespace

Status writeChecked(const FileFormat& format, const std::vector<std::byte>& content,
                    const std::string& path) {
    if (!lowestByteIsFirst()) return Error{otherOrder(format)};
    if (path.empty()) return Error{"There is no path to write to (an empty text); give that of a file."};
    Header header{};
    std::memcpy(header.magic, format.magic, sizeof header.magic);
    header.version = format.version;
    header.size = content.size();
    header.checksum = checksumOf(header, content.data(), content.size());
    std::error_code trouble;
    // Links stay: what they lead to is written.
    std::filesystem::path end = path;
    constexpr int most_links = 40;
    for (int links = 0; std::filesystem::is_symlink(end, trouble); ++links) {
        const std::filesystem::path next = std::filesystem::read_symlink(end, trouble);
        if (trouble || links == most_links)
            return Error{"Cannot write " + path +
                         ": it is a link that leads nowhere; give the path of a file."};
        end = next.is_absolute() ? next : end.parent_path() / next;
    }
    const std::string target = end.string();
    const bool is_other = std::filesystem::exists(target, trouble) &&
                          !std::filesystem::is_regular_file(target, trouble) &&
                          !std::filesystem::is_directory(target, trouble);
    if (is_other) return Error{"Cannot write " + path + ": it is no file, but a device or the like."};
    const std::string unfinished = nameBeside(target);
    const bool written = writeAll(header, content, unfinished);
    trouble.clear();
    if (written) std::filesystem::rename(unfinished, target, trouble);
    if (written && !trouble) return success();
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    if (!written) return Error{"Cannot write " + path + "; is there such a folder, and room on the disk?"};
    return Error{"Cannot write " + path + ": " + trouble.message() + "; give the path of a file."};
}

Result<CheckedContent> readChecked(const FileFormat& format, const std::string& path) {
    if (!lowestByteIsFirst()) return Error{otherOrder(format)};
    if (path.empty()) return Error{"There is no path to read from (an empty text); give that of a file."};
    const auto wrong = [&](const std::string& fault) {
        return Error{path + " " + fault + "; " + format.remedy + "."};
    };
    std::error_code trouble;
    if (std::filesystem::is_directory(path, trouble))
        return wrong(std::string("is a folder, not a ") + format.name);
    if (!std::filesystem::exists(path, trouble)) return wrong("is missing: there is no file at that path");
    File file(std::fopen(path.c_str(), "rb"));
    const long size = file ? sizeOf(file.get()) : -1;
    if (size < 0) return wrong("cannot be opened");
    if (size == 0) return wrong("is empty");
    Header header{};
    const bool has_header = std::fread(&header, 1, sizeof header, file.get()) == sizeof header;
    if (!has_header) return wrong("is cut short: it ends within its header");
    if (const std::string fault = faultOf(format, header); !fault.empty()) return wrong(fault);
    if (const std::string fault = faultOfSize(header, static_cast<std::uintmax_t>(size)); !fault.empty())
        return wrong(fault);

    CheckedContent content;
    content.size = static_cast<std::size_t>(header.size);
    content.bytes.reset(new std::byte[content.size]);  // not set to zero, unlike make_unique
    if (std::fread(content.bytes.get(), 1, content.size, file.get()) != content.size)
        return wrong("cannot be read to its end");
    if (checksumOf(header, content.bytes.get(), content.size) != header.checksum)
        return wrong("was changed since it was written: its checksum is another");
    return content;
}

}  // namespace sherd
