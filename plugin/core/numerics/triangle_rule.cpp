#include "core/numerics/triangle_rule.h"

#include <algorithm>
#include <array>

#include "core/numerics/gauss_legendre.h"

namespace sherd {
namespace {

/// Points that one point makes by permuting its barycentric coordinates a, b, 1 - a - b; of the weight, in
/// triangles, each has the whole.
struct Orbit {
    double weight, a, b;
};

constexpr Orbit degree_4[] = {{0.223381589678011, 0.445948490915965, 0.445948490915965},
                              {0.109951743655322, 0.091576213509771, 0.091576213509771}};
constexpr Orbit degree_8[] = {{0.144315607677787, 1.0 / 3, 1.0 / 3},
                              {0.095091634267285, 0.459292588292723, 0.459292588292723},
                              {0.103217370534718, 0.170569307751760, 0.170569307751760},
                              {0.032458497623198, 0.050547228317031, 0.050547228317031},
                              {0.027230314174435, 0.008394777409958, 0.263112829634638}};
constexpr Orbit degree_12[] = {{0.025731066440455, 0.488217389773805, 0.488217389773805},
                               {0.043692544538038, 0.439724392294460, 0.439724392294460},
                               {0.062858224217885, 0.271210385012116, 0.271210385012116},
                               {0.034796112930709, 0.127576145541586, 0.127576145541586},
                               {0.006166261051559, 0.021317350453210, 0.021317350453210},
                               {0.040371557766381, 0.115343494534698, 0.275713269685514},
                               {0.022356773202303, 0.022838332222257, 0.281325580989940},
                               {0.017316231108659, 0.025734050548330, 0.116251915907597}};

template <std::size_t count>
TriangleRule permuted(const Orbit (&orbits)[count]) {
    TriangleRule rule;
    for (const Orbit& orbit : orbits) {
        std::array<double, 3> x = {orbit.a, orbit.b, 1 - orbit.a - orbit.b};
        constexpr double same = 1e-14;
        if (x[0] - x[2] < same && x[2] - x[0] < same) x[0] = x[1] = x[2] = 1.0 / 3;
        std::sort(x.begin(), x.end());
        do {
            rule.u.push_back(x[0]);
            rule.v.push_back(x[1]);
            rule.weights.push_back(orbit.weight / 2);
        } while (std::next_permutation(x.begin(), x.end()));
    }
    return rule;
}

/// x = u (1, 0) + u v (-1, 1): the area element is u du dv.
TriangleRule collapsed(int degree) {
    const GaussRule gauss = gaussLegendre(degree / 2 + 1);
    TriangleRule rule;
    for (std::size_t i = 0; i < gauss.points.size(); ++i)
        for (std::size_t j = 0; j < gauss.points.size(); ++j) {
            const double u = gauss.points[i] + 0.5, v = gauss.points[j] + 0.5;
            rule.u.push_back(u * (1 - v));
            rule.v.push_back(u * v);
            rule.weights.push_back(u * gauss.weights[i] * gauss.weights[j]);
        }
    return rule;
}

}  // namespace

TriangleRule triangleRule(int degree) {
    if (degree == 4) return permuted(degree_4);
    if (degree == 8) return permuted(degree_8);
    if (degree == 12) return permuted(degree_12);
    return collapsed(degree);
}

}  // namespace sherd
