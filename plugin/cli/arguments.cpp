#include "cli/arguments.h"

#include <sherd/fields.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cctype>
#include <optional>
#include <vector>

#include "cli/mesh_options.h"

namespace sherd::cli {

namespace {

constexpr double unlimited_millions = 1e6;  // of factor entries: what is asked for is done

/// An option that stands for the path of a setting.
struct ShortOption {
    const char* name;
    const char* path;
    const char* type;
};
constexpr std::array<ShortOption, 7> short_options = {{
    {"--spacing", "sampling.spacing_m", "M"},
    {"--basis", "stress.basis", "NAME"},
    {"--trial", "stress.trial_function", "NAME"},
    {"--test-function", "stress.test_function", "NAME"},
    {"--integration", "sampling.cells_per_spacing", "N"},
    {"--rounds", "stress.resampling_rounds", "N"},
    {"--support-radius", "stress.support_radius", "R"},
}};

/// Meaning and possible values of the setting with that path.
std::string describe(const std::string& path) {
    const Settings settings;
    std::string words;
    visitPaths(settings, [&](const std::string& visited, const Field& field, const auto& value) {
        if (visited == path) words = field.meaning + (" [" + possibleValues(field, value) + "]");
    });
    words[0] = static_cast<char>(std::toupper(words[0]));
    return words;
}

/// The options that change single settings; those not given leave what the quality says.
struct Overrides {
    std::array<std::optional<std::string>, short_options.size()> values;
    std::vector<std::string> assignments;
    std::optional<int> particles;

    void addTo(CLI::App& app) {
        for (std::size_t i = 0; i < short_options.size(); ++i)
            app.add_option(short_options[i].name, values[i], describe(short_options[i].path))
                ->type_name(short_options[i].type);
        app.add_option("--particles", particles, "About how many particles, instead of --spacing")
            ->check(CLI::PositiveNumber)
            ->type_name("N")
            ->excludes(app.get_option("--spacing"));
        app.add_option("--set", assignments, "Change settings by their paths, see below")
            ->type_name("PATH=VALUE ...");
        app.footer("\nPaths for --set:\n" + listFields(SamplingSettings(), "sampling.") +
                   listFields(StressSettings(), "stress."));
    }

    Status applyTo(Settings& settings) const {
        SamplingSettings& sampling = settings.sampling;
        if (particles) {
            sampling.spacing_m = 0;
            sampling.smallest_count = sampling.largest_count = *particles;
            sampling.largest_factor_millions = sampling.largest_factor_if_thin_millions = unlimited_millions;
        }
        std::vector<std::string> changes;
        for (std::size_t i = 0; i < short_options.size(); ++i)
            if (values[i]) changes.push_back(short_options[i].path + ("=" + *values[i]));
        for (const std::string& assignment : assignments) {
            const auto begins = [&](const char* path) { return assignment.rfind(path, 0) == 0; };
            if (begins("strength") || begins("fracture") || begins("stress.resample_contacts"))
                return Error{
                    "'" + assignment +
                    "' changes nothing here: it is about blows in a world. The stress under given loads has "
                    "settings in sampling and stress."};
            changes.push_back(assignment);
        }
        return settings.set(changes);
    }
};

std::string checkVtkName(const std::string& path) {
    const std::string end = path.size() < 4 ? "" : path.substr(path.size() - 4);
    return end == ".vtk" || end == ".vtu" ? "" : path + " has to end in .vtk or .vtu";
}

void addStress(CLI::App& stress, Arguments& arguments) {
    stress.add_option("CASE", arguments.case_file, "Body, material, loads and supports (JSON)")->required();
    stress.add_option("--points", arguments.points, "Points to evaluate (CSV with columns x,y,z)")
        ->type_name("P.csv");
    stress.add_option("--out", arguments.out, "Where the stresses go (CSV)")->required()->type_name("S.csv");
    stress.add_option("--report", arguments.report, "Counts, times, memory, residual and warnings (JSON)")
        ->type_name("R.json");
    stress.add_option("--vtk", arguments.vtk, "Particles and surface with their stress, for ParaView")
        ->check(checkVtkName)
        ->type_name("FILE.vtk|.vtu");
    stress.add_option("--quality", arguments.quality, "Preset that the options below change")
        ->check(CLI::IsMember(namesInFiles<Quality>()))
        ->capture_default_str();
}

void addBake(CLI::App& app, BakeArguments& bake) {
    app.add_option("MESH", bake.mesh, "Surface of the body (OBJ)")->required()->type_name("FILE.obj");
    app.add_option("--material", bake.material,
                   "What it is made of: a name (ceramic, glass, ...) or a JSON file")
        ->required()
        ->type_name("NAME|FILE.json");
    app.add_option("-o,--out", bake.out, "Where the baked asset goes")->required()->type_name("FILE.sherd");
    auto* quality = app.add_option("--quality", bake.quality, "Preset that --set changes")
                        ->check(CLI::IsMember(namesInFiles<Quality>()))
                        ->capture_default_str();
    app.add_option("--settings", bake.settings, "Settings, with their preset (JSON)")
        ->type_name("FILE.json")
        ->excludes(quality);
    app.add_option("--set", bake.changes, "Change settings by their paths, see below")
        ->type_name("PATH=VALUE ...");
    app.footer("\nPaths for --set:\n" + listFields(Settings()));
}

}  // namespace

Result<Arguments> parseArguments(int argc, const char* const* argv) {
    Arguments arguments;
    Overrides overrides;
    MeshOptions stress_mesh, bake_mesh;

    CLI::App app("Brittle fracture without a mesh: work on single bodies from the command line.");
    app.name("sherd");
    app.require_subcommand(1);
    CLI::App* stress = app.add_subcommand("stress", "Stress in a body under loads on its surface");
    addStress(*stress, arguments);
    stress_mesh.addTo(*stress, "the case");
    overrides.addTo(*stress);
    CLI::App* bake = app.add_subcommand("bake", "What answers blows on a body, as a file that loads at once");
    addBake(*bake, arguments.bake);
    bake_mesh.addTo(*bake, "the body");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = stress->parsed() ? stress->help(app.get_name())
                         : bake->parsed() ? bake->help(app.get_name())
                                          : app.help();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return Error{std::string(error.what()) + " (see --help)"};
    }
    if (bake->parsed()) {
        arguments.command = Arguments::Command::bake;
        arguments.bake.repair = bake_mesh.chosen();
        return arguments;
    }
    arguments.settings = Settings::forQuality(*valueNamed<Quality>(arguments.quality));
    if (const Status applied = overrides.applyTo(arguments.settings); !applied)
        return Error{applied.error() + " (see --help)"};
    arguments.repair = stress_mesh.chosen();
    return arguments;
}

}  // namespace sherd::cli
