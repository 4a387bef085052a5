/// Reads the parts of a sweep file; sweep.cc puts them together.
#pragma once
#include "io/files/toml_reader.h"
#include "studies/fleets/sampling.h"
#include "studies/fleets/sweep.h"
#include <optional>

namespace rimpact::fleets {

/// Values along one key.
struct Axis {
  std::string key;
  std::vector<Value> values;
};
struct SampledKey {
  std::string key;
  Distribution distribution;
};
struct LinkedKey {
  std::string key, place;           ///< place: file:line:column
  double factor = 1;                ///< product of its numbers
  std::vector<std::string> factors; ///< keys it is multiplied with
  std::string divisor;              ///< key it is divided by, or empty
};
/// Ground motions of a folder: column `record`, excitation.*, variable.record_pga_g, _pgv_m_per_s and, when asked
/// for, _sa_g.
struct RecordCases {
  std::vector<std::vector<Axis>> cases; ///< each with one value a key
  std::vector<std::string> left_out;    ///< sentences
};

struct SweepParts {
  std::vector<std::vector<Axis>> cases;   ///< each with one value a key, the same keys in all
  std::vector<std::vector<Axis>> devices; ///< the same
  RecordCases records;
  std::vector<Axis> grid;
  std::vector<SampledKey> sampled;
  int samples = 0;
  std::uint64_t seed = 1;
  std::vector<std::vector<double>> correlation; ///< of the normal scores of `sampled`, in its order; empty: none
  std::vector<LinkedKey> linked;
  std::string fractiles_along; ///< empty: no fractiles
  std::vector<std::string> fractiles_by;
  PlausibleBounds plausible;
};

/// `count` values evenly from `from` to `to`, both included; each is checked to be one the key can take.
/// `place` opens the message.
std::vector<Value> even_values(const std::string &key, double from, double to, int count, const std::string &place);
/// What a run takes of a station: every horizontal component alone, both, or the vertical one too.
enum class Components { x, xy, xyz };
constexpr auto choices(Components) {
  return choices_of<Components>({{Components::x, "x"}, {Components::xy, "xy"}, {Components::xyz, "xyz"}});
}
/// Throws as parse_sweep, but for what only the whole sweep shows. Tables and keys of the root named in `also` are the
/// caller's.
SweepParts read_parts(const TomlFile &file, const std::string &origin, const std::vector<std::string> &also = {});
/// Every combination of the parts.
Sweep combine(const SweepParts &parts, const std::string &origin);

} // namespace rimpact::fleets
