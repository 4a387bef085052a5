/// A steel's flow stress over its plastic strain as suppliers give it: rows of a table or of a tensile test, and the
/// constants of a law. SI units; files give MPa.
#pragma once
#include "scene/material.h"
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::scene {

struct FlowCurve {
  std::vector<std::array<double, 2>>
      rows; ///< plastic strain [-], from 0, growing by 1e-6 at least; true stress [Pa], never falling
  std::optional<double> necks_at =
      std::nullopt;      ///< engineering strain that rows were cut at [-]; none: nothing was cut
  std::size_t n_cut = 0; ///< rows beyond it
};

/// The rows of a steel whose law is `table`. Those of a tensile test (engineering strain e and stress s) become
///   true stress s (1 + e), plastic strain ln(1 + e) - s (1 + e) / E.
/// They end where the test piece necks, at the largest s (Considere: d sigma / d eps = sigma), and begin at the proof
/// stress of 0.2 % plastic strain, or at the first row where that lies beyond. Throws InputError naming row and values.
FlowCurve flow_curve(const Material &material);

/// The yield stress that the curve itself has [Pa]: of `table` and `swift`; none: it is a number of its own.
std::optional<double> yield_of_curve(const Material &material);

/// Throws InputError for a constant that the law needs and nobody gave, or rows that are no curve. `name`: steel.
void check_hardening(const std::string &name, const Material &material);

/// Rows of a CSV file whose header is "plastic_strain,true_stress_MPa" or, of a tensile test, "strain,stress_MPa";
/// comments begin with #. Throws DataError naming file, line and value.
std::vector<std::array<double, 2>> read_curve(const std::string &path, CurveKind kind);

} // namespace rimpact::scene
