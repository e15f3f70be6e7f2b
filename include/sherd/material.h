#pragma once

#include <sherd/result.h>

#include <limits>
#include <string>

namespace sherd {

/// A brittle, isotropic, linearly elastic material. SI units. A user's own material is one of these.
struct Material {
    std::string name = "material";
    double youngs_modulus_pa = 5e9;
    double poisson_ratio = 0.2;  ///< 0 <= nu <= 0.499; above 0.47 results come with a warning
    double density_kg_m3 = 2000;
    double tensile_strength_pa = 3e6;  ///< under tension in one direction
    double strength_scatter =
        0.1;  ///< standard deviation of the strength over its mean, particle by particle
    double fracture_energy_j_m2 =
        10;  ///< energy to open a unit of crack area; sets how many fragments a blow can pay for
    /// Strength under compression in one direction; infinite: never crushed. Scatters as the tensile strength
    /// does.
    double compressive_strength_pa = std::numeric_limits<double>::infinity();
    /// Weibull's modulus m; 0: strength scatters normally, as above, and does not depend on size. Otherwise
    /// the mean strength of a volume V is `tensile_strength_pa` (`weibull_volume_m3` / V)^(1/m), so that
    /// large pieces are weaker.
    double weibull_modulus = 0;
    double weibull_volume_m3 = 1e-6;  ///< of the specimens that the tensile strength is the mean of
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
    static Material brick();  ///< burnt clay
    static Material stone();  ///< limestone
    static Material ice();
    static Material
    wood();  ///< pine, its strength that across the grain; the grain is FractureSettings::guide

    /// One of the above by its name; the error lists them.
    static Result<Material> named(const std::string& name);

    /// Reads a file of this struct's fields, `{"name": "tile", "youngs_modulus_pa": 5e10, ...}`. Fields that
    /// are not given are those of the material that `"like"` names; without it all but the scatter, the
    /// compressive strength, Weibull's and the criterion are needed.
    static Result<Material> fromJson(const std::string& path);

    /// Says which constant is out of range, and which values are possible.
    Status validate() const;
};

}  // namespace sherd
