#include "headless/scene_keys.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <sstream>
#include <utility>

#include "scenes/box_mesh.h"

namespace demo {
namespace {

using sherd::Error;
using sherd::Status;

struct Key {
    std::string name;
    std::string values;  ///< what it takes, with the unit
    std::string meaning;
    std::function<bool(Scene&, const std::string&)> apply;  ///< false: not a value that the key takes
};

std::string text(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

/// A key that takes a number within limits.
Key number(std::string name, double least, double most, const std::string& unit, std::string meaning,
           std::function<void(Scene&, double)> set) {
    const auto apply = [=](Scene& scene, const std::string& value) {
        double parsed = 0;
        const char* end = value.data() + value.size();
        const auto [stop, failure] = std::from_chars(value.data(), end, parsed);
        // Written so that NaN is refused too.
        if (failure != std::errc() || stop != end || !(parsed >= least && parsed <= most)) return false;
        set(scene, parsed);
        return true;
    };
    const std::string range = text(least) + " to " + text(most) + (unit.empty() ? "" : " " + unit);
    return {std::move(name), range, std::move(meaning), apply};
}

/// A whole number within limits.
Key count(std::string name, double least, double most, std::string meaning,
          std::function<void(Scene&, double)> set) {
    Key key = number(std::move(name), least, most, "", std::move(meaning), std::move(set));
    key.apply = [inner = key.apply](Scene& scene, const std::string& value) {
        return value.find_first_not_of("0123456789") == std::string::npos && inner(scene, value);
    };
    return key;
}

/// A key that takes one of a few words.
template <class Choice>
Key choice(std::string name, std::vector<std::pair<std::string, Choice>> choices, std::string meaning,
           std::function<void(sherd::Settings&, Choice)> set) {
    std::string words;
    for (const auto& [word, unused] : choices) words += (words.empty() ? "" : ", ") + word;
    const auto apply = [=](Scene& scene, const std::string& value) {
        for (const auto& [word, chosen] : choices) {
            if (word != value) continue;
            for (BreakableBody& body : scene.bodies) set(body.settings, chosen);
            return true;
        }
        return false;
    };
    return {std::move(name), words, std::move(meaning), apply};
}

/// Turns "set this of one breakable body" into "set this of all".
template <class Set>
std::function<void(Scene&, double)> everyBody(Set set) {
    return [set](Scene& scene, double value) {
        for (BreakableBody& body : scene.bodies) set(body, value);
    };
}

/// The striking balls fly with this speed; where there are none the breakable bodies do, straight down if
/// they stood still.
void setSpeed(Scene& scene, double speed) {
    const auto scale = [speed](Vec3& velocity) {
        velocity = speed * (velocity.norm() > 0 ? velocity.normalized().eval() : Vec3(0, 0, -1));
    };
    for (Ball& ball : scene.balls) scale(ball.velocity);
    if (!scene.balls.empty()) return;
    for (BreakableBody& body : scene.bodies) scale(body.velocity);
}

void setTriangles(Scene& scene, double triangles) {
    for (BreakableBody& body : scene.bodies) {
        if (auto* mesh = std::get_if<Generated>(&body.shape)) mesh->triangles = static_cast<int>(triangles);
        if (auto* box = std::get_if<Box>(&body.shape))
            box->edge_m = boxEdge(box->size_m, static_cast<int>(triangles));
    }
}

std::vector<Key> sceneKeys() {
    using B = BreakableBody;
    return {
        count("seed", 0, 1e9, "another seed, another break",
              everyBody([](B& b, double v) { b.settings.fracture.seed = static_cast<std::uint64_t>(v); })),
        number("duration", 0.01, 60, "s", "simulated time", [](Scene& s, double v) { s.duration_s = v; }),
        number("after_picture", 0, 60, "s", "from the first break to what after.png shows; 0: the end",
               [](Scene& s, double v) { s.after_picture_s = v; }),
        number("time_step", 1e-4, 1.0 / 30, "s", "of Bullet", [](Scene& s, double v) { s.time_step_s = v; }),
        number("speed", 0, 100, "m/s", "of the ball, or downwards of the body where there is no ball",
               setSpeed),
        number("drop_height", 0, 100, "m", "of the body's lowest point over the floor",
               everyBody([](B& b, double v) { b.position.z() = v; })),
        number("tilt", -180, 180, "degrees", "turn of the body about the world's y axis",
               everyBody([](B& b, double v) { b.turn_deg.y() = v; })),
        number("ball_diameter", 0.01, 1, "m", "of the ball, where there is one",
               [](Scene& s, double v) {
                   for (Ball& ball : s.balls) ball.diameter_m = v;
               }),
        count("triangles", 2000, 1e6, "of a mesh that is made, not read from a file", setTriangles),
        number("strength", 1, 1e15, "Pa", "tensile strength",
               everyBody([](B& b, double v) { b.material.tensile_strength_pa = v; })),
        number("strength_scatter", 0, 1, "", "standard deviation of the strength over its mean",
               everyBody([](B& b, double v) { b.material.strength_scatter = v; })),
        number("youngs_modulus", 1e3, 1e13, "Pa", "stiffness",
               everyBody([](B& b, double v) { b.material.youngs_modulus_pa = v; })),
        number("poisson_ratio", 0, 0.499, "", "transverse contraction",
               everyBody([](B& b, double v) { b.material.poisson_ratio = v; })),
        number("density", 1, 1e5, "kg/m^3", "of the breakable body",
               everyBody([](B& b, double v) { b.material.density_kg_m3 = v; })),
        number("fracture_energy", 1e-3, 1e6, "J/m^2", "what a unit of crack area costs",
               everyBody([](B& b, double v) { b.material.fracture_energy_j_m2 = v; })),
        number("spacing", 0, 1, "m", "distance between particles; 0: chosen from the wall thickness",
               everyBody([](B& b, double v) { b.settings.sampling.spacing_m = v; })),
        number("support_radius", 0, 10, "spacings", "of the trial functions; 0: the form's own",
               everyBody([](B& b, double v) { b.settings.stress.support_radius = v; })),
        choice<sherd::TestFunction>(
            "test_function",
            {{"galerkin", sherd::TestFunction::galerkin},
             {"heaviside", sherd::TestFunction::heaviside},
             {"heaviside_paper", sherd::TestFunction::heaviside_paper}},
            "of the weak form; the last two are the paper's MLPG5 and go with mls",
            [](sherd::Settings& s, sherd::TestFunction v) { s.stress.test_function = v; }),
        choice<sherd::TrialFunction>(
            "trial_function",
            {{"spline", sherd::TrialFunction::spline},
             {"gmls", sherd::TrialFunction::gmls},
             {"mls", sherd::TrialFunction::mls}},
            "spline is the default; gmls has gradients as unknowns",
            [](sherd::Settings& s, sherd::TrialFunction v) { s.stress.trial_function = v; }),
        choice<sherd::Basis>("basis",
                             {{"linear", sherd::Basis::linear},
                              {"quadratic", sherd::Basis::quadratic},
                              {"cubic", sherd::Basis::cubic}},
                             "polynomials that the trial functions reproduce; cubic for spline only",
                             [](sherd::Settings& s, sherd::Basis v) { s.stress.basis = v; }),
        choice<sherd::CollisionShape>(
            "collision_shape",
            {{"boxes", sherd::CollisionShape::boxes},
             {"hull", sherd::CollisionShape::hull},
             {"convex_parts", sherd::CollisionShape::convex_parts}},
            "of the body and its fragments; a hull closes hollows",
            [](sherd::Settings& s, sherd::CollisionShape v) { s.fracture.collision_shape = v; }),
        count("fragment_count", 0, 1000, "pieces of the damaged part; 0: what the strain energy pays for",
              everyBody([](B& b, double v) { b.settings.fracture.fragment_count = static_cast<int>(v); })),
        count("largest_fragment_count", 1, 1000, "pieces of one break, at most",
              everyBody(
                  [](B& b, double v) { b.settings.fracture.largest_fragment_count = static_cast<int>(v); })),
    };
}

}  // namespace

Status applyKey(Scene& scene, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        return Error{"'" + assignment + "' is not KEY=VALUE; a scene's name goes before --set."};
    }
    const std::string name = assignment.substr(0, equals), value = assignment.substr(equals + 1);
    std::string names;
    for (const Key& key : sceneKeys()) {
        if (key.name == name) {
            if (key.apply(scene, value)) return sherd::success();
            return Error{"'" + value + "' is not possible for " + name + "; it takes " + key.values + "."};
        }
        names += (names.empty() ? "" : ", ") + key.name;
    }
    return Error{"There is no key '" + name + "'; choose one of: " + names + "."};
}

std::string describeKeys() {
    std::string lines =
        "Keys for --set (all others by their path in the scene file: "
        "bodies[0].settings.fracture.guide.penalty=0.5):\n";
    for (const Key& key : sceneKeys()) {
        std::string head = "  " + key.name + "=" + key.values;
        head.resize(std::max<std::size_t>(head.size() + 2, 44), ' ');
        lines += head + key.meaning + "\n";
    }
    return lines;
}

}  // namespace demo
