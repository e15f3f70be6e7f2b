#include <sherd/material.h>

#include <cmath>

namespace sherd {

// Fracture energies are K_c^2 (1 - nu^2) / E of the toughness given. The scatter of a Weibull distribution of
// modulus m is about 1.2 / m.

Material Material::ceramic() {
    // Ashby & Jones, Engineering Materials 2, table 15.7: pottery and porcelain, 2300-2500 kg/m^3, E 70 GPa,
    // modulus of rupture 45 MPa, compressive strength 350 MPa, K_c 1.0 MPa m^1/2, m about 10. Stoneware holds
    // some pores and quartz: a little softer and weaker, with K_c near 1.35 MPa m^1/2.
    return {"ceramic", 60e9, 0.2, 2300, 40e6, 0.12, 30, 350e6};
}

Material Material::plaster() {
    // Vekinis, Ashby & Beaumont, J. Mater. Sci. 28 (1993) 3221: plaster of Paris at about half porosity, E
    // 4-5 GPa, tensile strength 2-3 MPa, K_c 0.15 MPa m^1/2.
    return {"plaster", 4.5e9, 0.22, 1150, 2.5e6, 0.12, 5};
}

Material Material::glass() {
    // Ashby & Jones, table 15.7: soda glass, 2480 kg/m^3, E 74 GPa, modulus of rupture 50 MPa, compressive
    // strength 1000 MPa, K_c 0.7 MPa m^1/2; E and nu as EN 572-1 states them for float glass (70 GPa, 0.22
    // rounded from 0.2-0.23).
    return {"glass", 70e9, 0.22, 2500, 50e6, 0.15, 8, 1000e6};
}

Material Material::concrete() {
    // EN 1992-1-1, table 3.1, C30/37: E 33 GPa, mean tensile strength 2.9 MPa, nu 0.2 (3.1.3); fib Model Code
    // 2010, Eq. 5.1-9: fracture energy 73 f_cm^0.18 = 140 J/m^2 at f_cm = 38 MPa, the mean compressive
    // strength.
    return {"concrete", 33e9, 0.2, 2400, 2.9e6, 0.12, 140, 38e6};
}

Material Material::brick() {
    // Van der Pluijm (1992) on solid clay units under uniaxial tension: strength 1.5-3.5 MPa, fracture energy
    // 60-130 J/m^2, E 6-17 GPa. Density and compressive strength as EN 771-1 has clay units of class 30
    // declared.
    return {"brick", 12e9, 0.16, 1800, 2.5e6, 0.15, 90, 30e6};
}

Material Material::stone() {
    // Ashby & Jones, table 15.7: limestone, 2700 kg/m^3, E 63 GPa, modulus of rupture 20 MPa, K_c 0.9 MPa
    // m^1/2, compressive strength 30-80 MPa.
    return {"stone", 63e9, 0.25, 2700, 20e6, 0.12, 12, 55e6};
}

Material Material::ice() {
    // Ashby & Jones, table 15.7: ice, 920 kg/m^3, E 9.1 GPa, modulus of rupture 1.7 MPa, compressive strength
    // 6 MPa, K_c 0.12 MPa m^1/2.
    return {"ice", 9.1e9, 0.33, 920, 1.7e6, 0.15, 1.4, 6e6};
}

Material Material::wood() {
    // Forest Products Laboratory, Wood Handbook (2010), chapter 5: loblolly pine at 12 % moisture, specific
    // gravity 0.51, E along the grain 12.3 GPa, tensile strength across it 3.2 MPa, nu_LR 0.33; a crack along
    // the grain has a toughness near 0.45 MPa m^1/2, which with E across the grain of about 1.2 GPa makes 170
    // J/m^2. Wood is taken as isotropic here: what its grain decides is where cracks run.
    return {"wood", 12.3e9, 0.33, 510, 3.2e6, 0.2, 170, 49e6};
}

Material Material::withDensity(double kg_m3) const {
    Material scaled = *this;
    const double factor = kg_m3 / density_kg_m3;
    scaled.density_kg_m3 = kg_m3;
    if (!(kg_m3 > 0 && std::isfinite(kg_m3))) return scaled;  // what `validate` then says is of the density
    for (double Material::*field : {&Material::youngs_modulus_pa, &Material::tensile_strength_pa,
                                    &Material::fracture_energy_j_m2, &Material::compressive_strength_pa})
        scaled.*field *= factor;
    return scaled;
}

Result<Material> Material::named(const std::string& name) {
    std::string known;
    for (const Material& material :
         {ceramic(), plaster(), glass(), concrete(), brick(), stone(), ice(), wood()}) {
        if (material.name == name) return material;
        known += (known.empty() ? "" : ", ") + material.name;
    }
    return Error{"There is no material '" + name + "'; there are " + known + "."};
}

}  // namespace sherd
