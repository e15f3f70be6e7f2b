#include "table1/sheet.h"

#include <fstream>
#include <ostream>

#include "table1/paper_table.h"

namespace {

// In pixels of the sheet, from its upper left corner: two models a row, two pictures a model.
constexpr double picture_width = sheet_width / 4.0, picture_height = picture_width * 10 / 16,
                 row_height = sheet_height / 3.0;
constexpr double gap = 6, letter = 24;

/// POV-Ray's y goes up.
void writePicture(std::ostream& out, const std::string& png, double left, double top) {
    out << "polygon { 5, <0,0>, <1,0>, <1,1>, <0,1>, <0,0> pigment { image_map { png \"" << png
        << "\" interpolate 2 once } } finish { ambient 0 diffuse 0 emission 1 } scale <"
        << picture_width - gap << ',' << picture_height - gap << ",1> translate <" << left + gap / 2 << ','
        << sheet_height - top - picture_height + gap / 2 << ",0> }\n";
}

void writeCaption(std::ostream& out, const std::string& words, double left, double top) {
    out << "text { internal 2 \"" << words
        << "\" 0.1, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 emission 0 } scale <" << letter << ','
        << letter << ",1> translate <" << left + gap << ',' << sheet_height - top - 0.8 * letter << ",0> }\n";
}

}  // namespace

sherd::Status writeSheet(const std::string& folder, const std::string& path) {
    std::ofstream out(path);
    out << "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\nbackground { rgb 1 }\n"
        << "camera { orthographic location <" << sheet_width / 2.0 << ',' << sheet_height / 2.0
        << ",-10> direction z right x*" << sheet_width << " up y*" << sheet_height << " }\n";
    for (std::size_t i = 0; i < paper_table.size(); ++i) {
        const double left = static_cast<double>(i % 2) * 2 * picture_width,
                     top = static_cast<double>(i / 2) * row_height + gap;
        const std::string pictures = folder + "/" + paper_table[i].scene + "/";
        writeCaption(out, paper_table[i].model, left, top);
        writePicture(out, pictures + "before.png", left, top + letter + gap);
        writePicture(out, pictures + "after.png", left + picture_width, top + letter + gap);
    }
    out.flush();
    if (!out) return sherd::Error{"Cannot write " + path + "; is the disk full or the folder read-only?"};
    return sherd::success();
}
