#pragma once

#include <sherd/settings.h>

#include <string>
#include <utility>
#include <vector>

namespace sherd::cli {

/// What the command line and the report call the choices there are.
template <class Choice>
using Names = std::vector<std::pair<std::string, Choice>>;

inline const Names<Basis> basis_names = {
    {"linear", Basis::linear}, {"quadratic", Basis::quadratic}, {"cubic", Basis::cubic}};
inline const Names<TrialFunction> trial_names = {
    {"mls", TrialFunction::mls}, {"gmls", TrialFunction::gmls}, {"spline", TrialFunction::spline}};
inline const Names<TestFunction> test_names = {{"heaviside", TestFunction::heaviside},
                                               {"heaviside_paper", TestFunction::heaviside_paper},
                                               {"galerkin", TestFunction::galerkin}};
inline const Names<Quality> quality_names = {
    {"preview", Quality::preview}, {"game", Quality::game}, {"film", Quality::film}};

template <class Choice>
std::string nameOf(const Names<Choice>& names, Choice choice) {
    for (const auto& [name, named] : names)
        if (named == choice) return name;
    return "";
}

/// `name` has to be one of them.
template <class Choice>
Choice choiceOf(const Names<Choice>& names, const std::string& name) {
    for (const auto& [known, choice] : names)
        if (known == name) return choice;
    return names.front().second;
}

}  // namespace sherd::cli
