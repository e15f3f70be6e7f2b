#include "cli/mesh_options.h"

#include <sherd/fields.h>

namespace sherd::cli {

void MeshOptions::addTo(CLI::App& app, const std::string& in_metres) {
    app.add_option("--repair", repair_, "What may be changed in a mesh that is no closed surface")
        ->check(CLI::IsMember(namesInFiles<Repair::Mode>()))
        ->capture_default_str();
    app.add_option("--scale", scale_,
                   "Multiplies the mesh's coordinates; " + in_metres + " is in m after that")
        ->check(CLI::PositiveNumber)
        ->type_name("S");
    app.add_option("--up-axis", up_axis_, "The mesh's axis that points up; it is turned to z")
        ->check(CLI::IsMember(namesInFiles<UpAxis>()))
        ->capture_default_str();
    app.add_option("--shell-thickness", shell_thickness_m_,
                   "Makes the body hollow, with such walls; of an open sheet it makes walls")
        ->check(CLI::PositiveNumber)
        ->type_name("M");
    app.add_option("--wrap-detail", wrap_detail_, "What a wrap closes, over the size of the mesh")
        ->check(CLI::Range(0.001, 0.1))
        ->capture_default_str();
}

Repair MeshOptions::chosen() const {
    Repair taken;
    taken.mode = *valueNamed<Repair::Mode>(repair_);
    taken.up_axis = *valueNamed<UpAxis>(up_axis_);
    taken.scale = scale_;
    taken.shell_thickness_m = shell_thickness_m_;
    taken.wrap_detail = wrap_detail_;
    return taken;
}

std::string withOptions(const std::string& sentence) {
    return withNames(sentence, {{"Repair::automatic()", "--repair automatic"},
                                {"Repair::scale", "--scale"},
                                {"Repair::shell_thickness_m", "--shell-thickness"},
                                {"Repair::wrap_detail", "--wrap-detail"}});
}

}  // namespace sherd::cli
