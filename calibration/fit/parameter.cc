#include "calibration/fit/parameter.h"
#include "files/error.h"
#include "files/text.h"

namespace rimpact::calibration {

using scene::Scene;

const std::vector<Parameter> &parameter_catalogue() {
  static const std::vector<Parameter> catalogue = {
      {"k_i", "kN/m", "reduced.k_i_kN_per_m", 1e3, 5e3, 5e7, true, false, //
       [](const Scene &s) { return s.reduced.k_i; }, [](Scene &s, double v) { s.reduced.k_i = v; }},
      {"e", "-", "reduced.restitution", 1, 0.01, 1.0, false, false, //
       [](const Scene &s) { return s.reduced.restitution; }, [](Scene &s, double v) { s.reduced.restitution = v; }},
      {"exponent", "-", "reduced.impact_exponent", 1, 0.2, 4.0, true, false,
       [](const Scene &s) { return s.reduced.impact_exponent; },
       [](Scene &s, double v) { s.reduced.impact_exponent = v; }},
      {"yield_force", "kN", "reduced.yield_force_kN", 1e3, 10, 1e5, true, false,
       [](const Scene &s) { return s.reduced.yield_force; }, [](Scene &s, double v) { s.reduced.yield_force = v; }},
      {"hardening", "-", "reduced.hardening", 1, 1e-3, 1.0, true, false,
       [](const Scene &s) { return s.reduced.hardening; }, [](Scene &s, double v) { s.reduced.hardening = v; }},
      {"unloading_gain", "-", "reduced.unloading_gain", 1, 0.0, 20.0, false, false,
       [](const Scene &s) { return s.reduced.unloading_gain; },
       [](Scene &s, double v) { s.reduced.unloading_gain = v; }},
      {"hardening_exponent", "-", "reduced.hardening_exponent", 1, 0.1, 1.0, false, false,
       [](const Scene &s) { return s.reduced.hardening_exponent; },
       [](Scene &s, double v) { s.reduced.hardening_exponent = v; }},
      {"unloading_exponent", "-", "reduced.unloading_exponent", 1, 0.25, 4.0, true, false,
       [](const Scene &s) { return s.reduced.unloading_exponent; },
       [](Scene &s, double v) { s.reduced.unloading_exponent = v; }},
      {"dent_spread", "-", "reduced.dent_spread", 1, 0.5, 100.0, true, false,
       [](const Scene &s) { return s.reduced.dent_spread; }, [](Scene &s, double v) { s.reduced.dent_spread = v; }},
      {"capacity_offset", "mm", "reduced.capacity_offset_mm", 1e-3, -5.0, 5.0, false, false,
       [](const Scene &s) { return s.reduced.capacity_offset; },
       [](Scene &s, double v) { s.reduced.capacity_offset = v; }},
      {"mu_fast", "-", "reduced.mu_fast", 1, 0.001, 0.5, false, true, [](const Scene &s) { return s.reduced.mu_fast; },
       [](Scene &s, double v) { // a constant coefficient stays constant
         if (s.reduced.mu_slow == s.reduced.mu_fast) s.reduced.mu_slow = v;
         s.reduced.mu_fast = v;
       }},
      {"mu_slow", "-", "reduced.mu_slow", 1, 0.001, 0.5, false, true, [](const Scene &s) { return s.reduced.mu_slow; },
       [](Scene &s, double v) { s.reduced.mu_slow = v; }},
      {"rate", "s/m", "reduced.rate_s_per_m", 1, 1.0, 300.0, true, true, [](const Scene &s) { return s.reduced.rate; },
       [](Scene &s, double v) { s.reduced.rate = v; }},
      {"elastic_slip", "mm", "reduced.elastic_slip_mm", 1e-3, 0.01, 5.0, true, true,
       [](const Scene &s) { return s.reduced.elastic_slip; }, [](Scene &s, double v) { s.reduced.elastic_slip = v; }},
      {"mass", "kg", "load.mass_kg", 1, 1e2, 1e8, true, true, //
       [](const Scene &s) { return s.load.mass; }, [](Scene &s, double v) { s.load.mass = v; }},
  };
  return catalogue;
}

const Parameter &parameter(const std::string &name) {
  std::vector<std::string> known;
  for (const auto &p : parameter_catalogue()) {
    if (p.name == name) return p;
    known.push_back(p.name);
  }
  throw InputError("parameter to fit: " + not_among(name, known));
}

std::string unit_behind(const std::string &unit) {
  return unit.empty() || unit == no_unit ? "" : " " + unit;
}

} // namespace rimpact::calibration
