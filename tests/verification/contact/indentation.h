/// A rigid sphere or cylinder on an elastic half-space, under a normal and then a tangential load: shared by
/// Hertz (VERIFICATION 4) and Cattaneo-Mindlin (5).
#pragma once
#include "setups.h"
#include <functional>

namespace rimpact::verification {

struct Indentation {
  bool sphere;                   ///< else a cylinder along y, plane strain
  double E, nu;                  ///< of the half-space [Pa]
  double radius;                 ///< [m]
  double load;                   ///< [N]; per metre for a cylinder
  double half_size;              ///< theoretical a or b [m]: sets the mesh
  int cells;                     ///< a direction
  double mu = 0, tangential = 0; ///< friction, and tangential over normal load, put on after the normal load
  double penalty_factor = 1.0;
};

struct IndentationResult {
  double half_size, peak_pressure, depth, size;  ///< a or b from the pressures' second moment; h [m]
  double stick_ratio_area, stick_ratio_traction; ///< c/a
  std::size_t dofs;
  int iterations = 0, cuts = 0, tangential_iterations_most = 0;
  std::vector<double> residuals; ///< of the last frictional Newton solution
  double seconds;
};
/// Half-size, peak pressure and stick ratios from a contact's points, whose centre is x = y = 0.
void measure(const Indentation &problem, const std::vector<fe::SurfaceContact::Sample> &samples,
             const fe::SurfaceContactState &state, IndentationResult &result);
/// Four steps of the terms at a growing share of the load; adds to `result`. Throws std::runtime_error when it stops.
void load_in_steps(fe::ContactSystem &system, SystemState &state, const std::function<fe::StepTerms(double)> &terms,
                   const fe::StepOptions &options, IndentationResult &result);
/// Stick ratios, cuts and last residuals of a frictional result, as a table's rows.
void add_stick_rows(Table &table, const IndentationResult &result, double reference);
/// Throws std::runtime_error when a step fails.
IndentationResult indent(const Indentation &problem);

} // namespace rimpact::verification
