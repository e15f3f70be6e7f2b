// Writes the meshes of assets/ : sherd_make_assets FOLDER

#include <sherd/triangle_mesh.h>

#include <iostream>
#include <string>

#include "generators/coffee_cup.h"
#include "generators/implicit_mesher.h"

namespace {

bool write(const sherd::Result<sherd::TriangleMesh>& mesh, const std::string& path) {
    if (!mesh) {
        std::cerr << path << ": " << mesh.error() << '\n';
        return false;
    }
    const sherd::Status written = sherd::writeObj(mesh.value(), path);
    if (!written) std::cerr << written.error() << '\n';
    if (written) std::cout << path << ": " << mesh.value().triangles.size() << " triangles\n";
    return written.ok();
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::cerr << "usage: sherd_make_assets FOLDER\n";
        return 2;
    }
    const std::string folder = std::string(arguments[1]) + "/";
    const sherd::generators::ImplicitSolid cup = sherd::generators::coffeeCup({});
    return write(meshImplicitSolid(cup, cup.fineness), folder + "coffee_cup.obj") ? 0 : 1;
}
