#pragma once

#include <sherd/result.h>

#include <limits>
#include <string>
#include <vector>

namespace sherd {

/// A brittle, isotropic, linearly elastic material. SI units. A user's own material is one of these.
/// `sherd/fields.h` lists the fields with their ranges.
struct Material {
    std::string name = "material";
    double youngs_modulus_pa = 5e9;
    /// From 0 to 0.499.
    double poisson_ratio = 0.2;
    double density_kg_m3 = 2000;
    /// Strength under tension in one direction.
    double tensile_strength_pa = 3e6;
    /// Coefficient of variation of the strength from place to place: standard deviation over mean. Its value
    /// at a place depends neither on the quality nor on breaks (BreakableAsset::tensileStrength). It changes
    /// over about the thickness of walls, or a quarter of the size of compact bodies.
    double strength_scatter = 0.1;
    /// Energy G_c that a unit of crack area costs (a crack has one area, though two faces); it decides how
    /// many fragments a blow can pay for.
    double fracture_energy_j_m2 = 10;
    /// Strength under compression in one direction, not below the tensile one; infinity: it is never crushed.
    /// Scatters as the tensile strength does.
    double compressive_strength_pa = std::numeric_limits<double>::infinity();
    /// Weibull's modulus m (W. Weibull, A statistical theory of the strength of materials, 1939). At 0 the
    /// strength scatters normally, as above, whatever the size of a body. Otherwise the weakest place of a
    /// volume V under even tension has the mean strength `tensile_strength_pa` (`weibull_volume_m3` /
    /// V)^(1/m), so that large bodies are weaker. Volumes smaller than that over which the strength changes
    /// are as strong as that one.
    double weibull_modulus = 0;
    /// Volume of the specimens whose mean strength is `tensile_strength_pa`: of the part that the test pulls
    /// evenly. For a bent bar of volume V that is V / (2 (m + 1)^2) in three-point bending.
    double weibull_volume_m3 = 1e-6;
    /// How stresses in several directions are compared with the two strengths:
    /// - "largest_principal_stress": the largest tension with the one, the largest compression with the other
    ///   (Rankine);
    /// - "mohr_coulomb": with both at once, sigma_1 / tensile - sigma_3 / compressive strength reaches 1, so
    ///   that shear with compression fails sooner (Labuz & Zang, Rock Mech. Rock Eng. 45 (2012) 975).
    std::string failure_criterion = "largest_principal_stress";

    static Material ceramic();  ///< stoneware
    static Material plaster();  ///< hardened gypsum
    static Material glass();    ///< soda-lime
    static Material concrete();
    static Material brick();  ///< fired clay
    static Material stone();  ///< limestone
    static Material ice();
    /// Pine, with the strength that it has across the grain. It has no grain of its own:
    /// set `settings.fracture.guide` to a constant direction.
    static Material wood();

    /// The same material for a body of another density, of a program whose masses are not those of real
    /// things: stiffness, strengths and fracture energy in proportion, so that it breaks at the same speeds.
    /// What strikes it is as stiff as ever, unless ContactSettings::partner_youngs_modulus_pa is changed by
    /// the same factor: it breaks at speeds that are up to a fifth lower then.
    Material withDensity(double kg_m3) const;

    /// One of the above by its name. The error lists the names.
    static Result<Material> named(const std::string& name);

    /// Reads a JSON file with the fields of this struct, `{"name": "tile", "youngs_modulus_pa": 5e10, ...}`.
    /// Fields that are left out are those of the material that `"like"` names (one of the above, or another
    /// file, relative to this one). Without `"like"` the file has to give Young's modulus, Poisson's ratio,
    /// the density, the tensile strength and the fracture energy; the rest keep their defaults. Infinity is
    /// written `"infinity"`. The error names the file and the field, and says what is possible there.
    static Result<Material> fromJsonFile(const std::string& path);

    /// Reads the same from text. The text may also be just the name of a material or of a file, in quotes;
    /// files are relative to `folder`. `key` is where the value stands in a larger file
    /// ("bodies[0].material"), for the error.
    static Result<Material> fromJson(const std::string& text, const std::string& key = "",
                                     const std::string& folder = "");

    /// All fields as a JSON object, which `fromJson` reads back bit for bit.
    std::string toJson() const;

    /// The error says which field is out of range, and which values are possible.
    Status validate() const;
};

/// What `Material::failure_criterion` may be, the default first.
std::vector<std::string> failureCriterionNames();

}  // namespace sherd
