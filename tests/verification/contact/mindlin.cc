// VERIFICATION 5: Cattaneo-Mindlin, Q = mu P/2: stick ratio 0.707 (cylinder), 0.794 (sphere). The solid is nearly
// incompressible (nu = 0.49), so that normal and tangential tractions hardly couple, as the theory assumes.
#include "indentation.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::verification {

void add_stick_rows(Table &table, const IndentationResult &r, double reference) {
  table.add({"stick ratio, by traction", r.size, r.stick_ratio_traction, reference, r.dofs, r.iterations, r.seconds});
  table.add({"stick ratio, by area", r.size, r.stick_ratio_area, reference, r.dofs, r.iterations, r.seconds});
  table.gate("cuts", r.cuts, 0);
  std::string residuals;
  for (const double value : r.residuals) residuals += fmt::format(" {:.1e}", value);
  table.note("last frictional solution, relative residuals:" + residuals);
}

Table mindlin_cylinder() {
  Table table;
  constexpr double E = 200e9, nu = 0.49, R = 0.1, load = 1e6;
  const double b = std::sqrt(4 * load * R * (1 - nu * nu) / (M_PI * E));
  for (const int cells : {10, 15, 22})
    add_stick_rows(table, indent({false, E, nu, R, load, b, cells, 0.3, 0.5}), std::sqrt(0.5));
  table.gate("stick ratio, by traction", table.last_error("stick ratio, by traction"), 0.03);
  table.gate("stick ratio, by area", table.last_error("stick ratio, by area"), 0.05);
  return table;
}

Table mindlin_sphere() {
  Table table;
  constexpr double E = 1.40625e7, nu = 0.49;
  const double load = 4.0 / 3 * E / (1 - nu * nu) * 1e-3;
  for (const int cells : {5, 6, 8})
    add_stick_rows(table, indent({true, E, nu, 1.0, load, 0.1, cells, 0.3, 0.5}), std::cbrt(0.5));
  table.gate("stick ratio, by traction", table.last_error("stick ratio, by traction"), 0.05);
  table.gate("stick ratio, by area", table.last_error("stick ratio, by area"), 0.08);
  return table;
}

} // namespace rimpact::verification
