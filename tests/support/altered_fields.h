#pragma once

#include <sherd/fields.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace sherd {

/// Gives every field that a file can give another value that is possible: JSON that leaves one out is found
/// out. Rules that join several fields hold if all lie low in their ranges.
template <class Struct>
void alterFields(Struct& altered) {
    visitFields(altered, [](const Field& field, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if (field.in_file == InFile::never) return;
        if constexpr (has_fields<Value>) {
            alterFields(value);
        } else if constexpr (std::is_enum_v<Value>) {
            for (const NamedValue<Value>& named : enum_names<Value>)
                if (named.in_files && named.value != value) {
                    value = named.value;
                    break;
                }
        } else if constexpr (std::is_same_v<Value, double>) {
            value = std::isinf(value) ? 7e8 / 3 : value * 4 / 3 + 1e-4;
            if (!field.range.allows(value)) value = (field.range.least + field.range.most) / 3;
        } else if constexpr (std::is_same_v<Value, bool>) {
            value = !value;
        } else if constexpr (std::is_same_v<Value, std::string>) {
            if (field.names.empty())
                value += " of another kind";
            else
                value = field.names.front() == value ? field.names.back() : field.names.front();
        } else if constexpr (std::is_same_v<Value, Vec3>) {
            value += Vec3(1.0 / 3, -2, 1e-7);
        } else {
            value += 1;
        }
    });
}

/// All values with 17 digits, to compare bit for bit.
template <class Struct>
std::string valuesOf(const Struct& written) {
    std::ostringstream text;
    text << std::setprecision(17);
    visitPaths(written, [&](const std::string& path, const Field&, const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        text << path << " = ";
        if constexpr (std::is_enum_v<Value>)
            text << nameOf(value);
        else if constexpr (std::is_same_v<Value, Vec3>)
            text << value.transpose();
        else
            text << value;
        text << "\n";
    });
    return text.str();
}

}  // namespace sherd
