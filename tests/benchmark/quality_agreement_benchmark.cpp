// Whether preview, game and film break the same bodies: random blows (1 to 4 contacts of one partner, half of
// them with supports) on a wall, a mug, a plate and a block, each solved as in a world at the three
// qualities. Usage: quality_agreement_benchmark [BLOWS A BODY] [BODY]
//
// Three lines a body and scatter of the strength (none, that of the material, Weibull's with m = 8): preview,
// game, and film with the strengths of another seed (so that agreement is not for want of scatter), each
// against film. Columns, in percent:
// - decisions by the stress that are the same: whether the largest overstress of a blow is above each of the
//   quartiles of film's. Blows within 5 % of that are left out;
// - difference of the largest overstress of a blow, median and the highest tenth.
// And a line of the blows that break the body at all three qualities or at none, of those that are not within
// 5 % of the strength at film, and how many of these break it at film.

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "fracture/blow_damage.h"
#include "fracture/pipeline.h"
#include "fracture/random_blows.h"
#include "generators/generators.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

constexpr double guard = 0.05;

/// Overstress of each blow at its worst place, and whether it breaks the body.
struct Answers {
    std::vector<double> overstress, other_strengths;
    std::vector<char> broke;
};

double largestOverstress(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength) {
    StageTimes times;
    const std::vector<double> all = blowDamage(struck, blow, strength, times).damage.overstress;
    return all.empty() ? 0 : *std::max_element(all.begin(), all.end());
}

Answers ask(const TriangleMesh& surface, const Material& material, Quality quality,
            const std::vector<Blow>& blows, bool of_another_too = false) {
    const auto solid = valueOrExit(BreakableSolid::make(surface, material, Settings::forQuality(quality)));
    const FractureSettings& fracture = solid->settings().fracture;
    const Discretisation& sampling = *valueOrExit(solid->discretisation());
    const StrikeContext struck{*solid, sampling, fracture, 1};
    StrengthSettings of_another = solid->settings().strength;
    of_another.seed = 1000;
    const BodyStrength other(material, solid->strength().scatterLength(), of_another);
    Answers answers;
    for (const Blow& blow : blows) {
        answers.overstress.push_back(largestOverstress(struck, blow, solid->strength()));
        if (of_another_too) answers.other_strengths.push_back(largestOverstress(struck, blow, other));
        answers.broke.push_back(strike(*solid, blow, fracture, 1).outcome == Outcome::broke);
    }
    return answers;
}

/// Percent of the decisions by the stress that agree.
double agreement(const std::vector<double>& own, const std::vector<double>& film) {
    int agree = 0, all = 0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const double at = quantile(film, share);
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (std::abs(film[i] / at - 1) < guard) continue;
            ++all;
            agree += (own[i] > at) == (film[i] > at);
        }
    }
    return 100.0 * agree / all;
}

void print(const std::string& name, const std::vector<double>& own, const std::vector<double>& film) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < own.size(); ++i)
        if (film[i] > 0) differences.push_back(100 * std::abs(own[i] / film[i] - 1));
    std::printf("%s %.1f %.2f %.1f\n", name.c_str(), agreement(own, film), quantile(differences, 0.5),
                quantile(differences, 0.9));
}

void measure(const std::string& name, const TriangleMesh& surface, const Material& material, int count) {
    fracture_tests::RandomBlows random(surface, 5);
    std::vector<Blow> blows;
    for (int i = 0; i < count; ++i) blows.push_back(random.next());
    const Answers film = ask(surface, material, Quality::film, blows, true);
    const Answers preview = ask(surface, material, Quality::preview, blows);
    const Answers game = ask(surface, material, Quality::game, blows);
    print(name + " preview", preview.overstress, film.overstress);
    print(name + " game", game.overstress, film.overstress);
    print(name + " other", film.other_strengths, film.overstress);
    int same = 0, all = 0, broke = 0;
    for (int i = 0; i < count; ++i) {
        if (std::abs(film.overstress[i] - 1) < guard) continue;
        ++all;
        same += preview.broke[i] == film.broke[i] && game.broke[i] == film.broke[i];
        broke += film.broke[i];
    }
    std::printf("%s breaks alike %.1f (of %d, %d at film)\n", name.c_str(), 100.0 * same / all, all, broke);
    std::fflush(stdout);
}

void measureAll(const std::string& body, const TriangleMesh& surface, Material material, int count) {
    Material even = material;
    even.strength_scatter = 0;
    measure(body + " none", surface, even, count);
    measure(body + " normal", surface, material, count);
    material.weibull_modulus = 8;
    measure(body + " Weibull", surface, material, count);
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 200;
    const std::string only = argc > 2 ? argv[2] : "";
    const auto asked = [&](const char* body) { return only.empty() || only == body; };
    if (asked("wall"))
        measureAll("wall", shapes::slab(Vec3(1, 0.09, 1), 6, 1, 6), Material::plaster(), count);
    if (asked("mug"))
        measureAll("mug", valueOrExit(generators::generate("coffee_cup", 20000)), Material::ceramic(), count);
    if (asked("plate"))
        measureAll("plate", valueOrExit(generators::generate("coffee_plate", 20000)), Material::ceramic(),
                   count);
    if (asked("block"))
        measureAll("block", shapes::slab(Vec3(0.2, 0.15, 0.1), 3, 3, 3), Material::brick(), count);
}
