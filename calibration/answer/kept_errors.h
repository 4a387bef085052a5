/// What kept runs say of errors that a run does not know of itself: of its rung, of its step, of steel that knows its
/// rate, of the strain's mesh.
#pragma once
#include "calibration/studies/stored_study.h"

namespace rimpact::calibration {

/// Of one impact, absolute and relative [-].
struct KeptError {
  std::string load;           ///< the scene studied
  double speed;               ///< approach [m/s]
  std::optional<double> deep; ///< penetration [m]
  double peak_force, rebound;
  std::optional<double> depth;
  std::string from;
  bool same_rim;
};

/// A rung against `full` on the same mesh, by every study that ran both, and by kept windows of shfps-225
/// (tests/verification/windows_of_rungs.txt). Of a slider between two dishes by studies of its own rim, and by kept
/// windows of dcfp-155 (windows_of_rungs_dcfp.txt there).
std::vector<KeptError> rung_errors(const std::vector<StoredStudy> &studies, const std::string &rung,
                                   const scene::Bearing &bearing);

/// Longest step inside an impact where the scene names none (fe_contact/planning/plan.h) [s].
inline constexpr double planned_step = 1e-3;
/// The scene's step against the shortest of a study of the same rim, rung and mesh.
std::vector<KeptError> step_errors(const std::vector<StoredStudy> &studies, const scene::Scene &scene,
                                   const std::string &rim);

/// 1 ms against 0.5 ms on mesh 1 of rung rim: windows of shfps-225 at 0.1 and 0.5 m/s, the first the worse for the
/// force, the second for the rebound (tests/verification/rim_window_refinement.txt).
inline constexpr double step_halved_force = 0.0033, step_halved_rebound = 0.0041;

/// By an explicit program of another make: the default rim at 0.2 and 1.0 m/s, of steel that does not know its rate and
/// of mild steel (Cowper and Symonds, D 40 1/s, q 5): the peak force rises by 15 and 27 %, the rebound by 15 and 16 %.
inline constexpr double rate_of_mild_steel_force = 0.27, rate_of_mild_steel_rebound = 0.16;

/// Largest change of the averaged strain of the rim's wall, its root and the dish from a mesh to the next finer one, at
/// 0.2 and 0.5 m/s on the default rim: tests/verification/steel_places.txt.
inline constexpr double averaged_strain_mesh_0 = 0.76, averaged_strain_mesh_1 = 0.06;

/// From 0.2 to 0.5 m/s (2.6 and 9.3 mm deep) the averaged strain of mesh 1 in that file grows as the depth to the power
/// 1.2 (wall), 1.4 (root) and 2.2 (dish): what moves the depth by a share moves the strain by at most so many.
inline constexpr double strain_over_depth = 2.2;

} // namespace rimpact::calibration
