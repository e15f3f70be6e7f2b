#pragma once

#include <sherd/outcome.h>
#include <sherd/repair.h>
#include <sherd/settings.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sherd {

/// A value of an enum and what files, command lines and reports call it.
template <class Enum>
struct NamedValue {
    const char* name;
    Enum value;
    bool in_files = true;  ///< false: only a program can choose it
};

/// The names of an enum's values, `enum_names<Basis>`: an array of NamedValue. A new value of an enum needs a
/// line here.
template <class Enum>
inline constexpr std::nullptr_t enum_names = nullptr;

template <>
inline constexpr NamedValue<TestFunction> enum_names<TestFunction>[] = {
    {"heaviside", TestFunction::heaviside},
    {"heaviside_paper", TestFunction::heaviside_paper},
    {"galerkin", TestFunction::galerkin},
};

template <>
inline constexpr NamedValue<TrialFunction> enum_names<TrialFunction>[] = {
    {"mls", TrialFunction::mls},
    {"gmls", TrialFunction::gmls},
    {"spline", TrialFunction::spline},
};

template <>
inline constexpr NamedValue<Basis> enum_names<Basis>[] = {
    {"linear", Basis::linear},
    {"quadratic", Basis::quadratic},
    {"cubic", Basis::cubic},
};

template <>
inline constexpr NamedValue<GuideField::Kind> enum_names<GuideField::Kind>[] = {
    {"none", GuideField::Kind::none},
    {"constant", GuideField::Kind::constant},
    {"radial", GuideField::Kind::radial},
    {"custom", GuideField::Kind::custom, false},  // needs a function
};

template <>
inline constexpr NamedValue<Debris> enum_names<Debris>[] = {
    {"unbreakable", Debris::unbreakable},
    {"merged", Debris::merged},
    {"dropped", Debris::dropped},
};

template <>
inline constexpr NamedValue<CrackPattern> enum_names<CrackPattern>[] = {
    {"stress", CrackPattern::stress},
    {"seeds", CrackPattern::seeds},
};

template <>
inline constexpr NamedValue<CollisionShape> enum_names<CollisionShape>[] = {
    {"automatic", CollisionShape::automatic},
    {"boxes", CollisionShape::boxes},
    {"hull", CollisionShape::hull},
    {"convex_parts", CollisionShape::convex_parts},
};

template <>
inline constexpr NamedValue<Repair::Mode> enum_names<Repair::Mode>[] = {
    {"off", Repair::Mode::off},
    {"mend", Repair::Mode::mend},
    {"automatic", Repair::Mode::automatic},
    {"wrap", Repair::Mode::wrap},
};

template <>
inline constexpr NamedValue<UpAxis> enum_names<UpAxis>[] = {
    {"x", UpAxis::x},
    {"y", UpAxis::y},
    {"z", UpAxis::z},
};

template <>
inline constexpr NamedValue<Quality> enum_names<Quality>[] = {
    {"preview", Quality::preview},
    {"game", Quality::game},
    {"film", Quality::film},
};

template <>
inline constexpr NamedValue<Outcome> enum_names<Outcome>[] = {
    {"broke", Outcome::broke},
    {"held", Outcome::held},
    {"failed", Outcome::failed},
    {"dropped", Outcome::dropped},
};

template <>
inline constexpr NamedValue<Level> enum_names<Level>[] = {
    {"none", Level::none},       {"gate", Level::gate}, {"coarse", Level::coarse},
    {"reduced", Level::reduced}, {"full", Level::full},
};

/// The name of a value; empty for what is none of the enum's values.
template <class Enum>
const char* nameOf(Enum value) {
    for (const NamedValue<Enum>& named : enum_names<Enum>)
        if (named.value == value) return named.name;
    return "";
}

/// The names that a file or a command line may give.
template <class Enum>
std::vector<std::string> namesInFiles() {
    std::vector<std::string> names;
    for (const NamedValue<Enum>& named : enum_names<Enum>)
        if (named.in_files) names.emplace_back(named.name);
    return names;
}

/// The value that a file or a command line gives by its name; none for other names.
template <class Enum>
std::optional<Enum> valueNamed(const std::string& name) {
    for (const NamedValue<Enum>& named : enum_names<Enum>)
        if (named.in_files && named.name == name) return named.value;
    return std::nullopt;
}

}  // namespace sherd
