#include <sherd/material.h>

namespace sherd {

// Fracture energies are K_c^2 (1 - nu^2) / E of the toughness given. The scatter of a Weibull distribution of
// modulus m is about 1.2 / m.

Material Material::ceramic() {
    // Ashby & Jones, Engineering Materials 2, table 15.7: pottery and porcelain, 2300-2500 kg/m^3, E 70 GPa,
    // modulus of rupture 45 MPa, K_c 1.0 MPa m^1/2, m about 10. Stoneware holds some pores and quartz: a
    // little softer and weaker, with K_c near 1.35 MPa m^1/2.
    return {"ceramic", 60e9, 0.2, 2300, 40e6, 0.12, 30};
}

Material Material::plaster() {
    // Vekinis, Ashby & Beaumont, J. Mater. Sci. 28 (1993) 3221: plaster of Paris at about half porosity, E
    // 4-5 GPa, tensile strength 2-3 MPa, K_c 0.15 MPa m^1/2.
    return {"plaster", 4.5e9, 0.22, 1150, 2.5e6, 0.12, 5};
}

Material Material::glass() {
    // Ashby & Jones, table 15.7: soda glass, 2480 kg/m^3, E 74 GPa, modulus of rupture 50 MPa, K_c 0.7 MPa
    // m^1/2; E and nu as EN 572-1 states them for float glass (70 GPa, 0.22 rounded from 0.2-0.23).
    return {"glass", 70e9, 0.22, 2500, 50e6, 0.15, 8};
}

}  // namespace sherd
