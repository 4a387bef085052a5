#include "reduced_models/isolation_design.h"
#include "io/files/error.h"
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::reduced {

namespace {

using std::numbers::pi;

void require(bool holds, const char *name, double value, const char *bound) {
  if (!holds) throw InputError(fmt::format("{} = {:g} must be {}", name, value, bound));
}

void require_bounds(const IsolationDesignInput &in) {
  require(in.radius > 0 && in.radius < 1000, "radius_m", in.radius, "above 0 and below 1000");
  require(in.friction >= 0 && in.friction < 1, "mu", in.friction, "at least 0 and below 1");
  require(in.mass_ratio > 0 && in.mass_ratio <= 1, "gamma", in.mass_ratio, "above 0 and at most 1");
  require(in.reduction >= 1 && in.reduction < 100, "R_I", in.reduction, "at least 1 and below 100");
  require(in.gravity > 0 && in.gravity < 100, "gravity", in.gravity, "above 0 and below 100");
  if (in.displacement)
    require(*in.displacement > 0 && *in.displacement < in.radius, "displacement_m", *in.displacement,
            "above 0 and below the radius");
  if (in.spectral_acceleration)
    require(*in.spectral_acceleration > 0 && *in.spectral_acceleration < 10, "sm1_g", *in.spectral_acceleration,
            "above 0 and below 10");
  if (in.superstructure_period)
    require(*in.superstructure_period > 0 && *in.superstructure_period < 60, "Ts_s", *in.superstructure_period,
            "above 0 and below 60");
  if (in.displacement.has_value() == in.spectral_acceleration.has_value())
    throw InputError(
        "give either the displacement (--displacement-m) or the spectrum's S_M1 (--sm1-g), from which it is found");
}

double shear(const IsolationDesignInput &in, double D) {
  return D / in.radius + in.friction;
}
double period(const IsolationDesignInput &in, double D) {
  return 2 * pi * std::sqrt(D / (in.gravity * shear(in, D)));
}
double damping(const IsolationDesignInput &in, double D) {
  return 2 * in.friction / (pi * shear(in, D));
}

/// D = g S_M1 T_eff(D) / (4 pi^2 B_M(beta(D))): the root, bracketed between nothing and the radius.
double displacement_of(const IsolationDesignInput &in) {
  const double scale = in.gravity * *in.spectral_acceleration / (4 * pi * pi);
  const auto rest = [&](double D) { return D - scale * period(in, D) / damping_coefficient_of(damping(in, D)); };
  const double least = 1e-6 * in.radius, most = 0.999 * in.radius;
  if (rest(most) < 0)
    throw InputError(
        fmt::format("S_M1 = {:g} g asks for more than the radius, {:g} m", *in.spectral_acceleration, in.radius));
  if (rest(least) > 0)
    throw InputError(
        fmt::format("S_M1 = {:g} g does not overcome the friction mu = {:g}", *in.spectral_acceleration, in.friction));
  const auto root = boost::math::tools::bisect(rest, least, most, boost::math::tools::eps_tolerance<double>(48));
  return 0.5 * (root.first + root.second);
}

void remark(const IsolationDesignInput &in, IsolationDesign &d) {
  if (d.damping > 0.30)
    d.remarks.push_back(fmt::format("the damping of {:.2f} exceeds 0.30, up to which the equivalent lateral force "
                                    "procedure is allowed (17.4.1): use a response history",
                                    d.damping));
  if (d.effective_period > 5)
    d.remarks.push_back(fmt::format("the effective period of {:.2f} s exceeds 5 s (17.4.1): use a response history",
                                    d.effective_period));
  if (in.superstructure_period && d.effective_period <= 3 * *in.superstructure_period)
    d.remarks.push_back(fmt::format("the effective period of {:.2f} s is not above three times T_s = {:g} s (17.4.1)",
                                    d.effective_period, *in.superstructure_period));
  if (d.displacement / in.radius < 0.05)
    d.remarks.push_back(fmt::format("the restoring force grows by {:.3f} W between half the displacement and all of "
                                    "it; 0.025 W is asked (17.2.4.4)",
                                    0.5 * d.displacement / in.radius));
  if (in.reduction > 2)
    d.remarks.push_back(fmt::format("R_I = {:g} exceeds 2, the most above an isolated base (17.5.4.2)", in.reduction));
  if (d.design_shear < 1.5 * in.friction)
    d.remarks.push_back(
        fmt::format("V_s = {:.4f} W lies below 1.5 mu W = {:.4f} W, which sets the system in full motion: "
                    "design the structure for that (17.5.4.3)",
                    d.design_shear, 1.5 * in.friction));
}

} // namespace

double damping_coefficient_of(double damping) {
  constexpr std::array<std::array<double, 2>, 7> table{
      {{0.02, 0.8}, {0.05, 1.0}, {0.10, 1.2}, {0.20, 1.5}, {0.30, 1.7}, {0.40, 1.9}, {0.50, 2.0}}};
  if (damping <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 1; i < table.size(); ++i)
    if (damping <= table[i][0])
      return table[i - 1][1] +
             (damping - table[i - 1][0]) / (table[i][0] - table[i - 1][0]) * (table[i][1] - table[i - 1][1]);
  return table.back()[1];
}

IsolationDesign design_isolation(const IsolationDesignInput &in) {
  require_bounds(in);
  IsolationDesign d;
  d.displacement = in.displacement ? *in.displacement : displacement_of(in);
  d.total_displacement = 1.15 * d.displacement;
  d.effective_period = period(in, d.displacement);
  d.damping = damping(in, d.displacement);
  d.base_shear = shear(in, d.displacement);
  d.structure_shear = d.base_shear * std::pow(in.mass_ratio, 1 - 2.5 * d.damping);
  d.design_shear = d.structure_shear / in.reduction;
  if (in.superstructure_period)
    d.yield_displacement = d.design_shear * in.gravity / std::pow(2 * pi / *in.superstructure_period, 2);
  remark(in, d);
  return d;
}

} // namespace rimpact::reduced
