#pragma once

#include <sherd/field.h>
#include <sherd/material.h>
#include <sherd/settings.h>

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace sherd {

// The fields of Material and of all Settings, one line each. Range checks, JSON, command lines and reports
// are made from these lines, and an app can make a panel of sliders from them:
//
//     visitFields(settings.stress, [&](const Field& field, auto& value) { ... });
//
// A new field is a line in its struct and a line here.

/// Radius of the supports of particle-wise trial functions. Near one spacing particles hardly see each other
/// (errors of 700 %); beyond four the factor fills without a gain in accuracy.
inline constexpr Range support_radius_range =
    Range::between(1.2, 4, "particle spacings").orSpecial(0, "the form's own default");

/// `void` if Self is Struct or const Struct: what lets one visitFields serve both.
template <class Self, class Struct>
using IfFieldsOf = std::enable_if_t<std::is_same_v<std::remove_const_t<Self>, Struct>>;

// Each calls visit(const Field&, value&) for the fields in their order, where value is a double, an int, an
// std::uint64_t, a bool, an std::string, a Vec3, an enum with enum_names, or another struct with fields.
// Functions (StrengthSettings::field, GuideField::custom) are not among them.

template <class Self, class Visitor>
IfFieldsOf<Self, Material> visitFields(Self& m, Visitor&& visit) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto needed = InFile::needed, to_break = InFile::needed_to_break;
    visit(Field{"name", "its name, for messages and reports"}, m.name);
    visit(Field{"youngs_modulus_pa", "stiffness", Range::positive("Pa"), needed}, m.youngs_modulus_pa);
    visit(Field{"poisson_ratio", "transverse contraction",
                Range::between(0, 0.499).with("0.5 is incompressible"), needed},
          m.poisson_ratio);
    visit(Field{"density_kg_m3", "mass of a unit of volume", Range::positive("kg/m^3"), needed},
          m.density_kg_m3);
    visit(Field{"tensile_strength_pa", "largest tension that it bears", Range::positive("Pa"), to_break},
          m.tensile_strength_pa);
    visit(Field{"strength_scatter", "how much the strength differs from place to place",
                Range::between(0, 1).with("standard deviation over mean")},
          m.strength_scatter);
    visit(
        Field{"fracture_energy_j_m2", "what a unit of crack area costs", Range::positive("J/m^2"), to_break},
        m.fracture_energy_j_m2);
    visit(Field{"compressive_strength_pa", "largest compression that it bears",
                Range::positive("Pa").orSpecial(infinity, "never crushed")},
          m.compressive_strength_pa);
    visit(Field{"weibull_modulus", "how strongly the strength falls with the volume",
                Range::between(1, 1000).orSpecial(0, "none")},
          m.weibull_modulus);
    visit(Field{"weibull_volume_m3", "volume of the specimens that the strength was measured on",
                Range::positive("m^3")},
          m.weibull_volume_m3);
    visit(Field{"failure_criterion",
                "how stresses in several directions are compared with the strengths",
                {},
                InFile::optional,
                failureCriterionNames()},
          m.failure_criterion);
}

template <class Self, class Visitor>
IfFieldsOf<Self, SamplingSettings> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"spacing_m", "distance between particles",
                Range::positive("m").orSpecial(0, "chosen from the wall thickness")},
          s.spacing_m);
    visit(Field{"layers_across_wall", "particles across a wall, about", Range::between(0.5, 20)},
          s.layers_across_wall);
    visit(Field{"smallest_count", "fewest particles of a compact body", Range::atLeast(1)}, s.smallest_count);
    visit(Field{"largest_count", "most particles, roughly", Range::atLeast(1)}, s.largest_count);
    visit(Field{"largest_factor_millions", "numbers that the factor of the stiffness matrix may store",
                Range::positive("millions")},
          s.largest_factor_millions);
    visit(Field{"largest_factor_if_thin_millions", "the same where walls are thinner than a particle spacing",
                Range::positive("millions")},
          s.largest_factor_if_thin_millions);
    visit(Field{"fragment_coarsening", "spacing of fragments over that of the whole", Range::between(1, 4)},
          s.fragment_coarsening);
    visit(Field{"cells_per_spacing", "integration cells per particle spacing and direction",
                Range::between(1, 4)},
          s.cells_per_spacing);
    visit(Field{"moment_order", "order of the moments of cut cells", Range::between(0, 6).inSteps(2),
                InFile::never},
          s.moment_order);
    visit(Field{"smallest_fill", "share of a cell that must be solid for a particle of its own",
                Range::between(0, 0.9)},
          s.smallest_fill);
}

template <class Self, class Visitor>
IfFieldsOf<Self, StressSettings> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"test_function", "test function of the weak form; heaviside and heaviside_paper go with mls"},
          s.test_function);
    visit(Field{"trial_function", "what a particle carries; gmls has gradients as unknowns"},
          s.trial_function);
    visit(Field{"basis", "polynomials that the trial functions reproduce; cubic for spline only"}, s.basis);
    visit(Field{"resampling_rounds",
                "how often the grid is made finer around loads and where the stress is high",
                Range::between(0, 4)},
          s.resampling_rounds);
    visit(Field{"resampling_margin", "how far a finer grid reaches beyond the loads",
                Range::between(1, 6, "cells")},
          s.resampling_margin);
    visit(Field{"resampling_cells", "how many cells across a load are fine enough",
                Range::between(1, 32, "cells")},
          s.resampling_cells);
    visit(Field{"resampling_error", "how wrong a high stress may be, over the largest tension",
                Range::between(0.01, 1)},
          s.resampling_error);
    visit(Field{"resample_contacts", "whether blows in a world have finer grids around their contacts"},
          s.resample_contacts);
    visit(Field{"support_radius", "radius of the supports of mls and gmls", support_radius_range},
          s.support_radius);
}

template <class Self, class Visitor>
IfFieldsOf<Self, StrengthSettings> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"seed", "another seed, weak places elsewhere", Range::atLeast(0)}, s.seed);
    visit(Field{"field_minimum", "what the strength field is nowhere below",
                Range::positive().orSpecial(0, "not known")},
          s.field_minimum);
}

template <class Self, class Visitor>
IfFieldsOf<Self, ContactSettings> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"partner_youngs_modulus_pa", "stiffness of what strikes and is not breakable",
                Range::positive("Pa")},
          s.partner_youngs_modulus_pa);
    visit(Field{"partner_poisson_ratio", "its transverse contraction", Range::between(0, 0.5)},
          s.partner_poisson_ratio);
    visit(Field{"shortest_contact_s", "shortest duration of a contact", Range::positive("s")},
          s.shortest_contact_s);
    visit(Field{"smallest_patch", "smallest radius of the loaded patch",
                Range::atLeast(0.001).with("fraction of the wall thickness")},
          s.smallest_patch);
    visit(Field{"largest_patch", "largest radius of the loaded patch",
                Range::fractionOf("fraction of the body's radius")},
          s.largest_patch);
}

template <class Self, class Visitor>
IfFieldsOf<Self, GuideField> visitFields(Self& g, Visitor&& visit) {
    visit(Field{"kind", "which way fragments grow", {}, InFile::needed}, g.kind);
    visit(Field{"direction", "the direction of kind constant, in the body's own coordinates"}, g.direction);
    visit(Field{"cost_along", "cost of distance along the field relative to across", Range::between(0, 1)},
          g.cost_along);
}

template <class Self, class Visitor>
IfFieldsOf<Self, FractureSettings> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"seed", "another seed, cracks elsewhere", Range::atLeast(0)}, s.seed);
    visit(Field{"contact", "how impulses become loads"}, s.contact);
    visit(Field{"damage_waves", "most solves of a blow, each without what is damaged by then",
                Range::between(1, 20)},
          s.damage_waves);
    visit(Field{"fragment_count", "pieces of the damaged part",
                Range::atLeast(1).orSpecial(0, "what the strain energy pays for")},
          s.fragment_count);
    visit(Field{"energy_into_cracks", "share of the energy that makes crack faces",
                Range::fractionOf("fraction of the strain energy")},
          s.energy_into_cracks);
    visit(Field{"largest_fragment_count", "most pieces of one break", Range::atLeast(2)},
          s.largest_fragment_count);
    visit(Field{"smallest_fragment_m3", "smaller pieces are debris",
                Range::positive("m^3").orSpecial(0, "1/200 of the first body")},
          s.smallest_fragment_m3);
    visit(Field{"debris", "what becomes of pieces below smallest_fragment_m3"}, s.debris);
    visit(Field{"crack_pattern", "what says where cracks run: the stress, or distances from seeds"},
          s.crack_pattern);
    visit(Field{"guide", "a direction along which fragments grow"}, s.guide);
    visit(Field{"crack_roughness", "roughness of crack faces",
                Range::between(0, 0.5).with("fraction of the particle spacing")},
          s.crack_roughness);
    visit(Field{"collision_shape",
                "what stands for a body and its fragments in collisions; a hull closes hollows"},
          s.collision_shape);
    visit(Field{"largest_collision_part_count", "most hulls of a body, with collision_shape automatic",
                Range::between(1, 100)},
          s.largest_collision_part_count);
    visit(Field{"rest_after_break_s", "how long new fragments cannot break", Range::atLeast(0, "s")},
          s.rest_after_break_s);
    visit(Field{"same_blow_s", "how long new fragments cannot be broken by what made them, nor by each other",
                Range::atLeast(0, "s")},
          s.same_blow_s);
    visit(Field{"largest_generation", "how often a body may break in turn",
                Range::atLeast(1).orSpecial(0, "no limit")},
          s.largest_generation);
    visit(Field{"use_reduced_model", "whether the reduced model of a prepared asset decides blows"},
          s.use_reduced_model);
    visit(Field{"use_coarse_model", "whether a coarse solve looks at blows on fragments first"},
          s.use_coarse_model);
    visit(
        Field{"check_with_full_solve",
              "whether blows that less than a full solve decides are solved fully as well, for their events"},
        s.check_with_full_solve);
}

template <class Self, class Visitor>
IfFieldsOf<Self, Settings> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"sampling", "how finely a solid is sampled"}, s.sampling);
    visit(Field{"stress", "how the stress problem is discretised"}, s.stress);
    visit(Field{"strength", "where a solid is strong and where weak"}, s.strength);
    visit(Field{"fracture", "how damaged material becomes fragments"}, s.fracture);
}

namespace detail {

struct AnyVisitor {
    template <class Value>
    void operator()(const Field&, Value&) const {}
};
template <class Struct, class = void>
inline constexpr bool is_visited = false;
template <class Struct>
inline constexpr bool
    is_visited<Struct, std::void_t<decltype(visitFields(std::declval<Struct&>(), AnyVisitor()))>> = true;

}  // namespace detail

/// Whether there is a visitFields for a type.
template <class Value>
inline constexpr bool has_fields = detail::is_visited<std::remove_reference_t<Value>>;

/// Calls visit(path, field, value) for the fields of a struct and of the structs in it, with paths as
/// "fracture.guide.kind".
template <class Struct, class Visitor>
void visitPaths(Struct& visited, Visitor&& visit, const std::string& before = "") {
    visitFields(visited, [&](const Field& field, auto& value) {
        if constexpr (has_fields<decltype(value)>)
            visitPaths(value, visit, before + field.name + ".");
        else
            visit(before + field.name, field, value);
    });
}

/// A line for each field that a file can give, for help texts: path, meaning and, in brackets, possible
/// values.
template <class Struct>
std::string listFields(const Struct& listed, const std::string& before = "") {
    constexpr std::size_t column = 53;
    std::string lines;
    visitPaths(listed, [&](const std::string& path, const Field& field, const auto& value) {
        if (field.in_file == InFile::never) return;
        std::string head = "  " + before + path + "  ";
        if (head.size() < column) head.resize(column, ' ');
        lines += head + field.meaning + " [" + possibleValues(field, value) + "]\n";
    });
    return lines;
}

}  // namespace sherd
