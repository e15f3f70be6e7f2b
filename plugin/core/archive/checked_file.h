#pragma once

#include <sherd/result.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sherd {

/// What a kind of file begins with, and what sentences call it.
struct FileFormat {
    char magic[9];  ///< eight characters
    std::uint32_t version;
    const char* name;    ///< "baked asset"
    const char* remedy;  ///< "bake the asset again"
};

// Such a file is a header of 32 bytes (magic, version, a zero, size and checksum of what follows; the
// checksum is also of the header before it), then the content. Numbers have their lowest byte first.

/// Writes to a name of its own beside `path` first, so that no file there is ever half written: if several
/// programs write to one path at once, the file of the last of them stands there.
Status writeChecked(const FileFormat& format, const std::vector<std::byte>& content, const std::string& path);

/// The content of a file that is complete and as it was written.
struct CheckedContent {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t size = 0;
};
/// The error names the file, and says what is wrong with it and what to do.
Result<CheckedContent> readChecked(const FileFormat& format, const std::string& path);

}  // namespace sherd
