// VERIFICATION 4: Hertz, a rigid cylinder and a rigid sphere on an elastic half-space, by exact surfaces.
#include "indentation.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {

Table hertz_cylinder() {
  Table table;
  constexpr double E = 200e9, nu = 0.3, R = 0.1, load = 1e6; // N/m
  const double reduced = E / (1 - nu * nu), b = std::sqrt(4 * load * R / (M_PI * reduced)), p0 = 2 * load / (M_PI * b);
  for (const int cells : {10, 15, 22}) {
    const auto r = indent({false, E, nu, R, load, b, cells});
    table.add({"half-width b [mm]", r.size, 1e3 * r.half_size, 1e3 * b, r.dofs, r.iterations, r.seconds});
    table.add({"peak pressure [MPa]", r.size, 1e-6 * r.peak_pressure, 1e-6 * p0, r.dofs, r.iterations, r.seconds});
    table.gate("cuts", r.cuts, 0);
  }
  table.gate("half-width", table.last_error("half-width b [mm]"), 0.01);
  table.gate("peak pressure", table.last_error("peak pressure [MPa]"), 0.01);
  table.note("strip truncated at 40 b: the pressures depend on the load alone, the depth does not and is not listed");
  return table;
}

Table hertz_sphere() {
  Table table;
  // Radius 1, depth 0.01: a = 0.1, p0 = 9.55e5, load = 4/3 E* a^3/R.
  constexpr double E = 1.40625e7, nu = 0.25;
  const double reduced = E / (1 - nu * nu), load = 4.0 / 3 * reduced * 1e-3;
  for (const int cells : {6, 8, 11}) {
    const auto r = indent({true, E, nu, 1.0, load, 0.1, cells});
    table.add({"radius a [m]", r.size, r.half_size, 0.1, r.dofs, r.iterations, r.seconds});
    table.add({"peak pressure [Pa]", r.size, r.peak_pressure, 9.549e5, r.dofs, r.iterations, r.seconds});
    table.add({"depth [m]", r.size, r.depth, 0.01, r.dofs, r.iterations, r.seconds});
    table.gate("cuts", r.cuts, 0);
  }
  // The same block and a ten times flatter sphere: what is left of the error is the mesh's.
  const auto flat = indent({true, E, nu, 10.0, load / 10, 0.1, 8});
  table.add({"radius a, a/R = 0.01 [m]", flat.size, flat.half_size, 0.1, flat.dofs, flat.iterations, flat.seconds});
  table.add({"depth, a/R = 0.01 [m]", flat.size, flat.depth, 0.001, flat.dofs, flat.iterations, flat.seconds});
  table.gate("radius, a/R = 0.01", table.last_error("radius a, a/R = 0.01 [m]"), 0.02);
  table.gate("depth, a/R = 0.01", table.last_error("depth, a/R = 0.01 [m]"), 0.02);
  table.gate("radius", table.last_error("radius a [m]"), 0.02);
  table.gate("peak pressure", table.last_error("peak pressure [Pa]"), 0.02);
  table.gate("depth", table.last_error("depth [m]"), 0.02);
  table.note("block of 5 a, its outer faces driven by Boussinesq's far field; small-strain theory, a/R = 0.1");
  return table;
}

} // namespace rimpact::verification
