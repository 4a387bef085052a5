/// The other way to a lower force: a sacrificial liner on the wall of a rim that was pushed (liner.h), and what the
/// wall behind it has to bear.
#pragma once
#include "calibration/studies/liner.h"
#include "calibration/studies/vary_study.h"
#include "scene/bearing.h"
#include <nlohmann/json.hpp>

namespace rimpact::calibration {

/// Share of a liner's thickness that crushes at its stress. An assumption: honeycombs and foams reach 0.6 to 0.8.
inline constexpr double usual_crush_share = 0.6;

/// The bare rim, slowly pushed by the slider with a force: the liner hands that force on, spread wider.
struct WallBehind {
  double depth = 0;               ///< [m]
  std::optional<double> strain;   ///< averaged [-]; none: not known
  std::optional<double> foot_use; ///< [-]; none: one piece with the plate
};
/// None: the rim was not pushed to that force [N].
std::optional<WallBehind> wall_behind(const VaryPoint &rim, double force);

struct LinerAnswer {
  std::optional<Liner> liner;       ///< none: no liner does it, or the bare rim keeps the force itself
  double crush_stress = 0;          ///< [Pa]
  double band = 0;                  ///< of the slider's side before the wall as it meets the liner [m]
  double travel = 0;                ///< that is left to the liner [m]
  std::optional<WallBehind> behind; ///< none: the rim was not pushed to that force
  bool works = false;               ///< softer than the wall's steel, which with its foot bears the force
  std::string sentence;             ///< with the assumptions
};
/// For the question's target peak_kN, speed and mass, on the wall of `rim`, one that was pushed, of `bearing`.
/// Throws InputError for a share outside (0, 1].
LinerAnswer liner_answer(const VaryQuestion &question, const VaryPoint &rim, const scene::Bearing &bearing,
                         double crush_share);
nlohmann::json to_json(const LinerAnswer &answer, double crush_share);

} // namespace rimpact::calibration
