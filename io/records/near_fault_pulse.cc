/// The built-in two-component near-fault motion: velocity pulses of Mavroeidis and Papageorgiou (2003),
///   v(t) = A/2 [1 + cos(w tau / gamma)] cos(w tau + nu),  w = 2 pi f_p,  |tau| = |t - t0| <= gamma / (2
///   f_p),
/// differentiated. Amplitudes are our choice: by the reduced model (Coulomb, defaults) shfps-225 meets its
/// rim twice, on opposite sides and obliquely (near 15 and -171 deg), at about 0.5 m/s each: well past
/// grazing, and within the speeds for which k_i and e are tabulated.
#include "io/records/near_fault_pulse.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include <array>
#include <cmath>
#include <numbers>

namespace rimpact {
namespace {

constexpr double pi = std::numbers::pi;

struct VelocityPulse {
  const char *name;
  double amplitude; ///< A [m/s]
  double frequency; ///< f_p [Hz]
  double cycles;    ///< gamma [-], > 1
  double phase;     ///< nu [rad]
  double centre;    ///< t0 [s]

  double acceleration(double t) const {
    const double tau = t - centre, w = 2 * pi * frequency;
    if (std::abs(tau) >= cycles / (2 * frequency)) return 0;
    const double envelope = 1 + std::cos(w * tau / cycles), d_envelope = -w / cycles * std::sin(w * tau / cycles);
    return amplitude / 2 * (d_envelope * std::cos(w * tau + phase) - envelope * w * std::sin(w * tau + phase));
  }
};
// The catalogue: one line a record.
constexpr std::array pulses{
    VelocityPulse{"builtin:near-fault-x", 0.90, 0.5, 1.6, pi / 2, 3.0}, // fault normal
    VelocityPulse{"builtin:near-fault-y", 0.36, 0.6, 1.5, pi / 2, 3.2}, // fault parallel
};
constexpr double step = 0.01;
constexpr std::size_t n_samples = 601; // 6 s: both pulses are over at 4.6 s

} // namespace

bool is_builtin_record(const std::string &name) {
  return name.starts_with("builtin:");
}

SampledSignal builtin_record(const std::string &name) {
  std::vector<std::string> names;
  for (const auto &pulse : pulses) {
    names.emplace_back(pulse.name);
    if (name != pulse.name) continue;
    SampledSignal record{step, std::vector<double>(n_samples)};
    for (std::size_t i = 0; i < n_samples; ++i) record.values[i] = pulse.acceleration(static_cast<double>(i) * step);
    return record;
  }
  throw InputError("record " + unknown_word(name, names));
}

} // namespace rimpact
