/// What moves the bearing: ground motion, prescribed motion, or a single impact. SI units.
/// Sign: ground acceleration a_g > 0 acts along +axis; the load on the mass is -m a_g.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace rimpact::scene {

enum class ExcitationKind { ricker, cyclic, figure_eight, push, window, record, free };

/// Uniformly sampled signal; linear between samples, zero outside.
struct SampledSignal {
  double dt = 0.0;
  std::vector<double> values;
  double at(double t) const;
  double duration() const { return values.empty() ? 0.0 : dt * (values.size() - 1); }
  bool operator==(const SampledSignal &) const = default;
};

/// Everything a scene file may say under [excitation]; only the fields of `kind` matter.
struct Excitation {
  ExcitationKind kind = ExcitationKind::ricker;
  double scale = 1.0;
  // ricker (eq. 2-25), centred at `centre`
  double amplitude_g = 0.78, period = 1.0, centre = 2.0;
  double direction_deg = 0.0; ///< ricker, push, window, cyclic: direction in the plane
  double duration = 8.0;      ///< [s]; every dynamic kind
  // cyclic, figure-eight
  double amplitude = 0.39; ///< [m]
  double cycles = 1.0;
  // push
  double travel = 0.008; ///< beyond touch [m]
  bool unload = true;    ///< the key is `return`
  // window
  double speed = 0.1;                        ///< approach speed [m/s]
  bool with_weight = false, with_friction = false, with_ground = false;
  // record: file names as given, and what they hold after reading [m/s^2]
  std::string x_file, y_file, z_file;
  SampledSignal x, y, z;
  // free: initial displacement [m] and velocity [m/s] in the plane
  Eigen::Vector2d initial_displacement = Eigen::Vector2d::Zero(), initial_velocity = Eigen::Vector2d::Zero();

  bool is_dynamic() const; ///< ricker, record, free, window
};

std::string to_string(ExcitationKind kind);

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

/// Prescribed planar path of the quasi-static kinds (cyclic, figure-eight, push) over load parameter 0..1.
Eigen::Vector2d prescribed_displacement(const Excitation &excitation, double lateral_capacity, double parameter);

} // namespace rimpact::scene
