#include "viewer/mesh_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace demo {
namespace {

std::string lowerEnding(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return ending;
}

/// Whether a PLY file keeps its triangles in strips: of these the importer reads the first triangle alone.
bool hasTriangleStrips(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    for (std::string line; std::getline(file, line) && line.rfind("end_header", 0) != 0;)
        if (line.rfind("element tristrips", 0) == 0) return true;
    return false;
}

void append(sherd::TriangleMesh& whole, const aiMesh& part) {
    const int first = int(whole.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v)
        whole.vertices.emplace_back(part.mVertices[v].x, part.mVertices[v].y, part.mVertices[v].z);
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
        const aiFace& face = part.mFaces[f];
        if (face.mNumIndices != 3) continue;  // lines and points are no surface
        whole.triangles.push_back(
            {first + int(face.mIndices[0]), first + int(face.mIndices[1]), first + int(face.mIndices[2])});
    }
}

}  // namespace

sherd::Result<sherd::TriangleMesh> importMesh(const std::string& path) {
    if (!std::filesystem::is_regular_file(path))
        return sherd::Error{"There is no file " + path + "; check its path."};
    if (lowerEnding(path) == ".obj") return sherd::readObj(path);
    if (lowerEnding(path) == ".ply" && hasTriangleStrips(path))
        return sherd::Error{path +
                            " keeps its triangles in strips (tristrips), which are not read; save it with "
                            "faces, or as OBJ."};
    Assimp::Importer importer;
    // What differs at the corners of triangles would keep apart vertices that are one.
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                    aiComponent_COLORS | aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS);
    const aiScene* scene = importer.ReadFile(
        path, aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_PreTransformVertices |
                  aiProcess_OptimizeMeshes | aiProcess_JoinIdenticalVertices);
    if (!scene) return sherd::Error{path + " cannot be read: " + importer.GetErrorString()};
    sherd::TriangleMesh mesh;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(mesh, *scene->mMeshes[m]);
    if (mesh.triangles.empty()) return sherd::Error{path + " has no triangles; a body needs a surface."};
    return mesh;
}

sherd::UpAxis usualUpAxis(const std::string& path) {
    const std::string ending = lowerEnding(path);
    return ending == ".gltf" || ending == ".glb" ? sherd::UpAxis::y : sherd::UpAxis::z;
}

}  // namespace demo
