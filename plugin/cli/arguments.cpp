#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <optional>

#include "cli/form_names.h"

namespace sherd::cli {

namespace {

constexpr double unlimited_millions = 1e6;  // of factor entries: what is asked for is done

template <class Choice>
std::vector<std::string> wordsOf(const Names<Choice>& choices) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    return names;
}

/// The options that change single settings; those not given leave what the quality says.
struct Overrides {
    std::optional<double> spacing_m, support_radius;
    std::optional<int> particles, integration, rounds;
    std::optional<std::string> basis, trial, test_function;

    void addTo(CLI::App& app) {
        auto* spacing = app.add_option("--spacing", spacing_m, "Distance between particles")
                            ->check(CLI::PositiveNumber)
                            ->type_name("M");
        app.add_option("--particles", particles, "About how many particles, instead of --spacing")
            ->check(CLI::PositiveNumber)
            ->type_name("N")
            ->excludes(spacing);
        app.add_option("--basis", basis, "Polynomials that the trial functions reproduce")
            ->check(CLI::IsMember(wordsOf(basis_names)));
        app.add_option("--trial", trial, "Trial functions; gmls has gradients as unknowns")
            ->check(CLI::IsMember(wordsOf(trial_names)));
        app.add_option("--test-function", test_function, "Test function of the weak form")
            ->check(CLI::IsMember(wordsOf(test_names)));
        app.add_option("--integration", integration, "Integration cells per spacing and direction")
            ->check(CLI::Range(1, 4))
            ->type_name("N");
        app.add_option("--rounds", rounds, "How often the grid is made finer around loads")
            ->check(CLI::Range(0, 4))
            ->type_name("N");
        app.add_option("--support-radius", support_radius, "Radius of the supports, in spacings")
            ->check(CLI::PositiveNumber)
            ->type_name("R");
    }

    void applyTo(Settings& settings) const {
        SamplingSettings& sampling = settings.sampling;
        if (spacing_m) sampling.spacing_m = *spacing_m;
        if (particles) {
            sampling.spacing_m = 0;
            sampling.smallest_count = sampling.largest_count = *particles;
            sampling.largest_factor_millions = sampling.largest_factor_if_thin_millions = unlimited_millions;
        }
        if (integration) sampling.cells_per_spacing = *integration;
        StressSettings& stress = settings.stress;
        if (basis) stress.basis = choiceOf(basis_names, *basis);
        if (trial) stress.trial_function = choiceOf(trial_names, *trial);
        if (test_function) stress.test_function = choiceOf(test_names, *test_function);
        if (rounds) stress.resampling_rounds = *rounds;
        if (support_radius) stress.support_radius = *support_radius;
    }
};

std::string checkVtkName(const std::string& path) {
    const std::string end = path.size() < 4 ? "" : path.substr(path.size() - 4);
    return end == ".vtk" || end == ".vtu" ? "" : path + " has to end in .vtk or .vtu";
}

}  // namespace

Result<Arguments> parseArguments(int argc, const char* const* argv) {
    Arguments arguments;
    Overrides overrides;

    CLI::App app("Brittle fracture without a mesh: work on single bodies from the command line.");
    app.name("sherd");
    app.require_subcommand(1);
    CLI::App* stress = app.add_subcommand("stress", "Stress in a body under loads on its surface");
    stress->add_option("CASE", arguments.case_file, "Body, material, loads and supports (JSON)")->required();
    stress->add_option("--points", arguments.points, "Points to evaluate (CSV with columns x,y,z)")
        ->type_name("P.csv");
    stress->add_option("--out", arguments.out, "Where the stresses go (CSV)")->required()->type_name("S.csv");
    stress->add_option("--report", arguments.report, "Counts, times, memory, residual and warnings (JSON)")
        ->type_name("R.json");
    stress->add_option("--vtk", arguments.vtk, "Particles and surface with their stress, for ParaView")
        ->check(checkVtkName)
        ->type_name("FILE.vtk|.vtu");
    stress->add_option("--quality", arguments.quality, "Preset that the other options change")
        ->check(CLI::IsMember(wordsOf(quality_names)))
        ->capture_default_str();
    overrides.addTo(*stress);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = stress->parsed() ? stress->help() : app.help();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return Error{std::string(error.what()) + " (see --help)"};
    }
    arguments.settings = Settings::forQuality(choiceOf(quality_names, arguments.quality));
    overrides.applyTo(arguments.settings);
    return arguments;
}

}  // namespace sherd::cli
