/// Temperature at a point of the steel that a slider passes over: the surface of a half space under a flux q(t),
///   T(t) = T_0 + sqrt(D / pi) / k  integral q(t - s) / sqrt(s) ds      (Carslaw and Jaeger 1959, 2.9; Constantinou,
/// Whittaker, Kalpakidis, Fenz and Warn 2007, MCEER-07-0012; OpenSees' FPBearingPTV). All of the heat enters the steel:
/// the slider's liner conducts next to none. The kernel is a sum of decaying exponentials,
///   1 / sqrt(t) = integral exp(-t e^x) e^(x/2) dx / sqrt(pi), by the trapezoidal rule in x,
/// so that the history is a state of `n_modes` numbers with an ordinary rate: under a constant flux T is within 0.5 %
/// of 2 q sqrt(D t / pi) / k from 10 ms to 100 s. SI units, temperatures in degrees Celsius.
#pragma once
#include <array>

namespace rimpact::friction {

/// What the heat flows into.
struct HeatSink {
  double conductivity = 18;         ///< k [W/(m K)], > 0; stainless steel
  double diffusivity = 4.44 * 1e-6; ///< D = k / (rho c) [m^2/s], > 0
  double at_start = 20;             ///< T_0 [degrees Celsius]
  bool operator==(const HeatSink &) const = default;
};

/// Rises of temperature by the exponentials [K]; theirs is the sum.
inline constexpr int n_heat_modes = 14;
using HeatModes = std::array<double, n_heat_modes>;

class SlidingHeat {
public:
  explicit SlidingHeat(const HeatSink &sink = {});
  /// Rates of the modes under a flux [W/m^2].
  void rates(const double *modes, double flux, double *rate) const;
  /// The modes after `time` [s] under a constant flux, exactly.
  HeatModes after(const HeatModes &modes, double flux, double time) const;
  double temperature(const double *modes) const; ///< [degrees Celsius]
  double at_start() const { return at_start_; }

private:
  double at_start_;
  HeatModes decay_, gain_; ///< [1/s], [K m^2/J]
};

/// Whether a slider at `distance` from a point covers it: its contact of radius r counts as the square of the same area
/// (Kumar et al. 2015), so that the point is under it within r sqrt(pi) / 2 [m].
bool passes_over(double distance, double contact_radius);

} // namespace rimpact::friction
