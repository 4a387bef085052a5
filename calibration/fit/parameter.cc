#include "calibration/fit/parameter.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace rimpact::calibration {

using scene::Scene;

namespace {

/// A number of an impact law.
Parameter of_law(const laws::LawParameter &p) {
  const auto member = p.member;
  return {.name = p.name,
          .unit = p.unit,
          .toml_key = std::string("reduced.") + p.key,
          .si = p.si,
          .lower = p.lower,
          .upper = p.upper,
          .logarithmic = p.logarithmic,
          .seen_in_flight = false,
          .get = [member](const Scene &s) { return s.reduced.*member; },
          .set = [member](Scene &s, double v) { s.reduced.*member = v; }};
}

std::vector<Parameter> of_the_bearing() {
  return {
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
}

} // namespace

const std::vector<Parameter> &parameter_catalogue() {
  static const auto catalogue = [] {
    std::vector<Parameter> all;
    for (const auto &p : laws::law_parameters()) all.push_back(of_law(p));
    for (auto &p : of_the_bearing()) all.push_back(std::move(p));
    return all;
  }();
  return catalogue;
}

const Parameter &parameter(const std::string &name) {
  std::vector<std::string> known;
  for (const auto &p : parameter_catalogue()) {
    if (p.name == name) return p;
    known.push_back(p.name);
  }
  throw InputError("parameter to fit: " + unknown_word(name, known));
}

std::string unit_behind(const std::string &unit) {
  return unit.empty() || unit == no_unit ? "" : " " + unit;
}

} // namespace rimpact::calibration
