/// What moves the bearing: ground motion, prescribed motion, or a single impact. SI units.
/// Sign: ground acceleration a_g > 0 acts along +axis; the load on the mass is -m a_g.
#pragma once
#include "io/files/choice.h"
#include "io/records/sampled_signal.h"
#include "scene/path_table.h"
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::scene {

enum class ExcitationKind { ricker, cyclic, figure_eight, path, push, window, record, free };
constexpr auto choices(ExcitationKind) {
  using enum ExcitationKind;
  return choices_of<ExcitationKind>({{ricker, "ricker"},
                                     {cyclic, "cyclic"},
                                     {figure_eight, "figure-eight"},
                                     {path, "path"},
                                     {push, "push"},
                                     {window, "window"},
                                     {record, "record"},
                                     {free, "free"}});
}

/// Everything a scene file may say under [excitation]; only the fields of `kind` matter.
struct Excitation {
  ExcitationKind kind = ExcitationKind::ricker;
  double scale = 1.0;
  // ricker (eq. 2-25), centred at `centre`
  double amplitude_g = 0.78, period = 1.0, centre = 2.0;
  double direction_deg = 0.0; ///< ricker, push, window, cyclic: direction in the plane
  double duration = 8.0;      ///< [s]; every dynamic kind
  // cyclic, figure-eight
  double amplitude = 0.39;        ///< [m]
  double cycles = 1.0;            ///< of each amplitude
  std::vector<double> amplitudes; ///< cyclic: one after the other [m]; empty: `amplitude` alone
  // path: a file's name as given, and what it holds after reading
  std::string path_file;
  PathTable path;
  // push
  double travel = 0.008; ///< beyond touch [m]
  bool unload = true;    ///< the key is `return`
  // window
  double speed = 0.1;                                                   ///< approach speed [m/s]
  bool with_weight = false, with_friction = false, with_ground = false; ///< ground: the Ricker pulse of these fields
  // record: file names as given, and what they hold after reading [m/s^2]
  std::string x_file, y_file, z_file;
  SampledSignal x, y, z;
  // free: initial displacement [m] and velocity [m/s] in the plane
  Eigen::Vector2d initial_displacement = Eigen::Vector2d::Zero(), initial_velocity = Eigen::Vector2d::Zero();

  bool is_dynamic() const;           ///< ricker, record, free, window
  bool stays_on_dish() const;        ///< cyclic, figure-eight, path: quasi-static and short of the rim
  double largest_amplitude() const;  ///< of a cyclic path or a figure-eight [m]
  double rounds() const;             ///< cycles in all; of a path, its length over that of a cycle as wide
  double whole_rounds() const;       ///< begun, at least one: as many times the samples and steps of one
  Eigen::Vector2d direction() const; ///< unit vector of direction_deg, exact along the axes
  /// Approach speed of a window [m/s], initial state of `free`: scale included, as it multiplies any excitation.
  double impact_speed() const { return scale * speed; }
  Eigen::Vector2d start_displacement() const { return scale * initial_displacement; }
  Eigen::Vector2d start_velocity() const { return scale * initial_velocity; }
};

/// Ricker pulse (2-25) divided by its amplitude: (1 - 2 p^2) exp(-p^2), p = pi (t - centre) / period.
double ricker_shape(double t, double centre, double period);

/// Ground acceleration [m/s^2] of an excitation, scale included. Cheap to call: the reduced model's hot path.
class GroundMotion {
public:
  GroundMotion(const Excitation &excitation, double gravity);
  Eigen::Vector3d acceleration(double t) const;
  /// Instants where the acceleration's slope jumps (the sampling of a record); empty when smooth.
  const std::vector<double> &breakpoints() const { return breakpoints_; }

private:
  Excitation excitation_;
  double amplitude_ = 0.0; ///< [m/s^2]
  Eigen::Vector2d direction_ = Eigen::Vector2d::UnitX();
  std::vector<double> breakpoints_;
};

/// Prescribed planar path [m] of the quasi-static kinds over load parameter s in 0..1, scale included:
/// cyclic u = A sin(2 pi n s) along direction_deg, several A one after the other in equal parts of s; figure-eight ux =
/// u0 sin(2 pi n s), uy = u0 sin(4 pi n s) (thesis 2.3.1); path: as its file has it, by the share of its length; push:
/// 0 to L_c (s = 0.2), on to L_c + travel (s = 0.6), back to L_c - travel * push_clearance (s = 1); without `return`: 0
/// to L_c (s = 0.3), on to L_c + travel (s = 1).
Eigen::Vector2d prescribed_displacement(const Excitation &excitation, double lateral_capacity, double parameter);

/// Where a push ends, short of L_c, as a share of its travel: the rim has let go there.
inline constexpr double push_clearance = 0.125;
/// Of the path's load parameter [s]; none: its kind, or its file, has no time, and friction is that of slow motion.
std::optional<double> prescribed_instant(const Excitation &excitation, double parameter);

/// Load parameters at which the path has a kink; empty when smooth.
std::vector<double> prescribed_breakpoints(const Excitation &excitation);

} // namespace rimpact::scene
