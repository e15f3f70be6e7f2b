#pragma once

#include <imgui.h>
#include <sherd/enum_names.h>

#include <optional>
#include <string>
#include <vector>

namespace demo {

/// A list to choose a value of an enum from, with "as the scene says" before them.
template <class Enum>
bool chooseEnum(const char* label, std::optional<Enum>& value) {
    bool changed = false;
    if (!ImGui::BeginCombo(label, value ? sherd::nameOf(*value) : "as the scene says")) return false;
    if (ImGui::Selectable("as the scene says", !value)) {
        value.reset();
        changed = true;
    }
    for (const auto& named : sherd::enum_names<Enum>) {
        if (!named.in_files || !ImGui::Selectable(named.name, value == named.value)) continue;
        value = named.value;
        changed = true;
    }
    ImGui::EndCombo();
    return changed;
}

/// The same of names; an empty one is shown as `empty`, and may be chosen if that is not null.
inline bool chooseName(const char* label, std::string& value, const std::vector<std::string>& names,
                       const char* empty) {
    bool changed = false;
    if (!ImGui::BeginCombo(label, value.empty() ? (empty ? empty : "") : value.c_str())) return false;
    if (empty && ImGui::Selectable(empty, value.empty())) {
        value.clear();
        changed = true;
    }
    for (const std::string& name : names) {
        if (!ImGui::Selectable(name.c_str(), name == value)) continue;
        value = name;
        changed = true;
    }
    ImGui::EndCombo();
    return changed;
}

}  // namespace demo
