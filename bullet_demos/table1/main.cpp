// sherd_table1 FOLDER: prints the paper's Table 1 with ours beside it from the reports below FOLDER, and
// writes table1.md and table1.pov there.

#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include "table1/measured.h"
#include "table1/paper_table.h"
#include "table1/sheet.h"

namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

/// Both kinds of row have the same members.
template <class Row>
std::string line(const char* model, const char* whose, const Row& row) {
    constexpr double thousand = 1000;
    return formatted("| %s | %s | 1 -> %d | %.1fk / %.1fk | %d | %.3g | %.2g | %.3g | %.4g | %.3g |\n", model,
                     whose, row.bodies_after, row.triangles_before / thousand, row.triangles_after / thousand,
                     row.particles, row.grid_ms, row.dynamics_ms, row.stress_s, row.fragmentation_ms,
                     row.render_s);
}

sherd::Result<std::string> table(const std::string& folder) {
    std::string text =
        "| model | | # rigid | # triangles | # particles | grid & table, ms | dynamics & collision, ms a "
        "step | stress, s | "
        "fragmentation, ms | render, s a frame |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const PaperRow& paper : paper_table) {
        const auto measured = readMeasured(folder + "/" + paper.scene);
        if (!measured) return sherd::Error{measured.error()};
        text += line(paper.model, "Sherd", measured.value()) + line("", "paper", paper);
    }
    return text +
           "\nAfter the first break. Paper: N. Liu, X. He, S. Li, G. Wang, Meshless simulation of brittle "
           "fracture, Computer "
           "Animation and Virtual Worlds 22 (2011), Table 1, on a processor of 2.93 GHz. Grid & table: "
           "sampling. Stress: "
           "assembling, factoring, solving and recovery. Fragmentation: damage, clusters and surfaces.\n";
}

sherd::Status writeAll(const std::string& folder) {
    const auto text = table(folder);
    if (!text) return sherd::Error{text.error()};
    std::cout << text.value();
    std::ofstream out(folder + "/table1.md");
    out << text.value();
    out.flush();
    if (!out)
        return sherd::Error{"Cannot write " + folder +
                            "/table1.md; is the disk full or the folder read-only?"};
    return writeSheet(folder, folder + "/table1.pov");
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::cerr << "usage: sherd_table1 FOLDER\n";
        return 2;
    }
    const sherd::Status written = writeAll(arguments[1]);
    if (!written) std::cerr << written.error() << '\n';
    return written ? 0 : 1;
}
