#include "generators/mesh_store.h"

#include <filesystem>

#include "generators/generators.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

/// Under another name first: a run that is stopped leaves no half of a file that the next would take for the
/// whole.
sherd::Status store(const sherd::TriangleMesh& mesh, const fs::path& path) {
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    if (failure)
        return sherd::Error{"Cannot make the folder " + path.parent_path().string() + ": " +
                            failure.message() + "."};
    const fs::path part = path.string() + ".part";
    const sherd::Status written = sherd::writeObj(mesh, part.string());
    if (!written) return written;
    fs::rename(part, path, failure);
    if (failure) return sherd::Error{"Cannot write " + path.string() + ": " + failure.message() + "."};
    return sherd::success();
}

}  // namespace

sherd::Result<sherd::TriangleMesh> storedMesh(const std::string& name, int triangles,
                                              const std::string& folder,
                                              const std::function<void(const std::string&)>& announce) {
    const fs::path path = fs::path(folder) / (name + "_" + std::to_string(triangles) + ".obj");
    if (fs::exists(path)) return sherd::readObj(path.string());
    announce("making " + path.filename().string() + " (once, some seconds)");
    auto mesh = sherd::generators::generate(name, triangles);
    if (!mesh) return mesh;
    const sherd::Status stored = store(mesh.value(), path);
    if (!stored) return sherd::Error{stored.error()};
    return mesh;
}

}  // namespace demo
