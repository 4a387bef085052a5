// clang-format off
/// A sweep file: which keys of a scene take which values, one run each. TOML:
///
///   [[case]]                      # any number: keys that change together, e.g. a record's components
///   name = "sylmar"               # column `case`
///   excitation.x = "SYL360.AT2"   # files are sought beside the sweep file
///   excitation.y = "SYL090.AT2"
///   [[device]]                    # a second list of the same form, column `device`: every case with every device
///   name = "stiff rim"
///   reduced.k_i_kN_per_m = 1e6
///   [records]                     # one case for each ground motion of a folder of records
///   folder = "records"
///   components = "xy"             # "x": every horizontal component alone; "xy", "xyz": stations that have them
///   sa_period_s = 3.0             # also variable.record_sa_g
///   [grid]                        # every combination
///   variable.pga_g = [0.2, 0.4, 0.6]
///   excitation.scale = [0.5, 0.75, 1.0]
///   bearing.surface.a_m = { from = 0.5625, to = 2.25, count = 4 }  # evenly spaced, both ends included
///   [latin_hypercube]             # `samples` points in all its keys at once, the same for every combination
///   samples = 15
///   seed = 1
///   reduced.mu_fast = { low = 0.03, high = 0.07 }                  # log = true: uniform in the logarithm
///   load.vertical_kN = { mean = 853, deviation = 80, low = 600, high = 1100 }  # normal, cut at both ends
///   correlation = [["reduced.mu_fast", "load.vertical_kN", 0.5]]   # of the normal scores; pairs not named: 0
///   [linked]                      # products of numbers and of keys above, over one key
///   reduced.mu_slow = { product = [0.5, "reduced.mu_fast"] }
///   excitation.scale = { product = ["variable.pga_g"], over = "variable.record_pga_g" }
///   [fractiles]                   # also FOLDER/fractiles.csv and .h5, see fractiles.h
///   along = "variable.pga_g"                                       # a key with numbers, of any part
///   by = ["bearing.surface.a_m"]                                   # one curve for each combination of these
///   [plausible]                   # largest values that are believed, see implausible_runs.h
///   ductility = 15
///
/// Each motion of [records] sets excitation.kind, x, y and z, the column `record`, and variable.record_pga_g
/// and variable.record_pgv_m_per_s (and variable.record_sa_g, the spectral acceleration with 5 % damping): the largest of its horizontal components, unscaled.
/// On the command line KEY=a:b:n stands for one line of [grid]: n values from a to b.
/// Runs are cases x devices x records x grid x samples, in this order, the last changing fastest. Keys are those of a scene,
/// dotted; a key that begins with "variable." is only a column and a factor for [linked].
// clang-format on
#pragma once
#include "io/files/table.h"
#include "studies/fleets/implausible_runs.h"
#include <array>
#include <string>
#include <vector>

namespace rimpact::fleets {

/// Keys whose values name files or, of a calibration, a folder, sought beside the sweep.
inline constexpr std::array file_keys{"excitation.file",     "bearing.file",        "bearing.surface.file",
                                      "model.own_mesh.file", "reduced.calibration", "isolator.inner.rims.calibration",
                                      "reduced.impact_curve"};

/// A value as the scene file would write it, and as the table shows it.
struct Value {
  std::string toml;
  Cell cell;
};

struct Sweep {
  std::string origin;                    ///< the file's name, or the arguments
  std::vector<std::string> keys;         ///< of the scene, "variable.*", "case", "device" or "record", sorted
  std::vector<std::vector<Value>> runs;  ///< one value a key
  std::string fractiles_along;           ///< one of `keys`, or empty
  std::vector<std::string> fractiles_by; ///< of `keys`
  std::vector<std::string> left_out;     ///< sentences: records of a folder that are not used
  PlausibleBounds plausible = {};
  /// KEY=VALUE for load_scene, file names made absolute; variables and the case's name left out.
  std::vector<std::string> assignments(std::size_t run) const;
};

/// At most this many runs in one sweep.
inline constexpr std::size_t largest_fleet = 200'000;

/// Throws InputError "file:line:column: ..." for what is not in the form above and for an unknown key. So it does for a
/// value of the wrong type or out of its own range, a key given twice, and more than `largest_fleet` runs.
Sweep parse_sweep(const std::string &text, const std::string &origin);
Sweep read_sweep(const std::string &path);

} // namespace rimpact::fleets
