/// The geometry study: one isolated impact on rims of many dimensions, each read as k_i, e, peak force and
/// plastic strain; a surrogate through them, and whether the bearing's own rim survives.
#pragma once
#include "calibration/fit/fit.h"
#include "calibration/studies/surrogate.h"
#include <nlohmann/json.hpp>

namespace rimpact::calibration {

/// One thing that is varied: a catalogue line each in geometry_study.cc.
struct GeometryAxis {
  std::string name, unit;
  double si;        ///< reported value times this is SI
  double low, high; ///< default range: shares of the bearing's own value, or values where `absolute`
  bool absolute;
  double (*get)(const scene::Scene &);
  void (*set)(scene::Scene &, double value); ///< SI
};
/// In the order they are set (the contact band last of the dimensions: it follows from height and diameter).
const std::vector<GeometryAxis> &geometry_axes();

struct GeometryOptions {
  int samples = 24;                     ///< 3..10000; the first three are the bearing itself at low, middle, high speed
  std::map<std::string, Bounds> ranges; ///< instead of the defaults, reported units
  double strain_limit = 0.20;           ///< equivalent plastic strain beyond which a rim counts as lost, > 0
  /// Throws InputError naming option, value and bound.
  void validate() const;
};

/// `impact-window` scenes of the bearing; dimensions that cannot be built are passed over. Deterministic.
/// Throws InputError when hardly any can.
std::vector<scene::Scene> geometry_scenes(const scene::Scene &window, const GeometryOptions &options);

struct GeometryRow {
  std::string name;
  std::vector<double> inputs;        ///< reported units, in the axes' order
  double k_i, e;                     ///< fitted to this impact alone (signed) [kN/m], [-]
  double peak_force, plastic_strain; ///< of the run [N], [-]
  double mass = 0, weight = 0;       ///< supported mass and dead load of the run [kg], [N]
};
/// Throws DataError when the run holds no impact.
GeometryRow geometry_row(const std::string &name, const StoredRun &run, double plastic_strain);

struct GeometryStudy {
  std::vector<GeometryRow> rows;
  std::map<std::string, std::optional<Surrogate>> surrogates; ///< k_i, e, peak_force, plastic_strain
  std::string sentence;                                       ///< does the bearing's own rim survive?
};

} // namespace rimpact::calibration
