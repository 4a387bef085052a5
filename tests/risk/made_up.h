/// A study small enough for a test: two records, two levels, two systems of a rigid mass on the bearing.
#pragma once
#include "../scene/temporary_folder.h"
#include "studies/risk/results.h"
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace made_up {

/// Four seconds of a wave of `period` and `peak_g`, and rest.
inline std::string at2(double peak_g, double period) {
  std::string text = "PEER\nMADE UP\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 601, DT= .0100 SEC\n";
  for (int i = 0; i < 601; ++i) {
    const double t = 0.01 * i, a = t < 4 ? peak_g * std::sin(2 * std::acos(-1.0) * t / period) : 0.0;
    text += fmt::format("{:.6e}", a) + (i % 5 == 4 ? "\n" : " ");
  }
  return text + "\n";
}

inline void write_records(const TemporaryFolder &folder) {
  folder.write("RSN1_HILL000.AT2", at2(0.2, 1.0));
  folder.write("RSN1_HILL090.AT2", at2(0.3, 1.4));
  folder.write("RSN1_HILL-UP.AT2", at2(0.1, 0.2));
  folder.write("RSN2_VALLEY000.AT2", at2(0.25, 1.7));
}

inline const char *const head = R"(scene = "ricker-0.78g-1.0s"
[set]
excitation.duration_s = 7.0
[intensity]
period_s = 3.0
levels_g = [0.1, 0.3]
[motions]
folders = ["."]
[hazard]
points = [[0.02, 43], [0.1129, 475], [0.26227, 2475], [0.4362, 10000]]
[[limit]]
quantity = "peak_displacement_m"
values = [0.1, 0.2, 0.39]
[bootstrap]
replicates = 60
)";

inline const char *const systems = R"([grid]
bearing.surface.a_m = [2.25, 0.5625]
[latin_hypercube]
samples = 3
reduced.mu_fast = { low = 0.03, high = 0.07 }
[linked]
reduced.mu_slow = { product = [1.0, "reduced.mu_fast"] }
[[difference]]
key = "bearing.surface.a_m"
reference = 2.25
)";

} // namespace made_up
