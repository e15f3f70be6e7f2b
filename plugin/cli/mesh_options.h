#pragma once

#include <sherd/repair.h>

#include <CLI/CLI.hpp>
#include <string>

namespace sherd::cli {

/// The options that say how a mesh is taken in.
class MeshOptions {
  public:
    /// `in_metres`: what is in metres once the mesh is scaled ("the case").
    void addTo(CLI::App& app, const std::string& in_metres);

    Repair chosen() const;

  private:
    std::string repair_ = "off", up_axis_ = "z";
    double scale_ = 1, shell_thickness_m_ = 0, wrap_detail_ = Repair().wrap_detail;
};

/// A sentence about a mesh, with the options in the place of the fields of Repair that it names.
std::string withOptions(const std::string& sentence);

}  // namespace sherd::cli
