#include "table.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>
#include <stdexcept>

namespace rimpact::hard_cases {
namespace {

double relative(double value, double reference) {
  return reference != 0 ? std::abs(value / reference - 1) : std::abs(value);
}

void compare(Outcome &o, const Summary &own, const Summary &other) {
  o.off_displacement = relative(own.peak_displacement, other.peak_displacement);
  o.off_force = relative(*own.peak_impact_force, *other.peak_impact_force);
  o.off_residual = std::abs(own.residual_displacement - other.residual_displacement);
  if (own.status != other.status) o.failures.push_back("CVODE ends with " + word(other.status));
  if (own.impacts.size() != other.impacts.size())
    o.failures.push_back(fmt::format("CVODE has {} impacts", other.impacts.size()));
}

/// Bounds of the issue: 1e-6 in displacement and energy. A peak force is a derivative of a graze: 1e-4.
void apply_bounds(Outcome &o) {
  const auto require = [&](const char *what, double value, double bound) {
    if (!(value <= bound)) o.failures.push_back(fmt::format("{} {:.2e} > {:.0e}", what, value, bound));
  };
  require("displacement", o.off_displacement, 1e-6);
  require("force", o.off_force, 1e-4);
  require("residual", o.off_residual, 1e-6);
  require("imbalance", o.imbalance, 1e-6);
  if (o.status != RunStatus::done) o.failures.push_back("status " + word(o.status));
}

bool well_formed(const Response &response) {
  try {
    response.check();
  } catch (const std::logic_error &) {
    return false;
  }
  return true;
}

} // namespace

Outcome judge(const Case &hard) {
  const auto run = reduced::simulate(hard.scene);
  scene::Scene tight = hard.scene;
  tight.reduced.tolerance = 1e-11;
  const auto &own = run.summary;
  Outcome o{.name = hard.name, .status = own.status, .reason = own.reason, .fact = {}, .failures = {}};
  o.must_be_right = hard.must_be_right;
  o.n_impacts = own.impacts.size();
  o.peak_displacement = own.peak_displacement;
  o.peak_force = *own.peak_impact_force;
  o.residual = own.residual_displacement;
  o.imbalance = std::abs(own.energy->imbalance_relative());
  compare(o, own, reduced::simulate_with_cvode(tight).summary);
  if (hard.deviation) {
    const double value = hard.deviation(run);
    o.fact = fmt::format("{} {:.1e}", hard.fact, value);
    if (!(std::abs(value) <= hard.bound)) o.failures.push_back(o.fact);
  }
  if (o.must_be_right)
    apply_bounds(o);
  else
    o.failures.clear(); // shown beside, not asked for
  if (!well_formed(run.response)) o.failures.push_back("a stored value is not finite");
  if (o.status != RunStatus::done && o.reason.empty()) o.failures.push_back("no reason given");
  return o;
}

std::string header() {
  return fmt::format("# {:<28} {:>8} {:>7} {:>12} {:>12} {:>12} | {:>8} {:>8} {:>8} {:>8}\n", "case", "status",
                     "impacts", "peak mm", "peak kN", "residual mm", "off peak", "off kN", "off res", "energy");
}

std::string row(const Outcome &o) {
  std::string text =
      fmt::format("{:<30} {:>8} {:>7} {:>12.5f} {:>12.3f} {:>12.5f} | {:8.1e} {:8.1e} {:8.1e} {:8.1e}",
                  o.name + (o.must_be_right ? " *" : ""), word(o.status), o.n_impacts, 1e3 * o.peak_displacement,
                  1e-3 * o.peak_force, 1e3 * o.residual, o.off_displacement, o.off_force, o.off_residual, o.imbalance);
  for (const auto &extra : {o.fact, o.reason})
    if (!extra.empty()) text += "  " + extra;
  return text + "\n";
}

std::vector<std::string> differences(const std::string &now, const std::string &stored) {
  const auto left = [](const std::string &text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      if (!line.empty() && line[0] != '#') lines.push_back(line.substr(0, line.find('|')));
    return lines;
  };
  const auto same = [](const std::string &a, const std::string &b) {
    std::istringstream x(a), y(b);
    std::string p, q;
    while (x >> p) {
      if (!(y >> q)) return false;
      char *end_p, *end_q;
      const double u = std::strtod(p.c_str(), &end_p), v = std::strtod(q.c_str(), &end_q);
      const bool numbers = !*end_p && !*end_q;
      if (numbers ? std::abs(u - v) > 1e-5 * std::max(1.0, std::abs(v)) : p != q) return false;
    }
    return !(y >> q);
  };
  const auto a = left(now), b = left(stored);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    if (i >= a.size() || i >= b.size() || !same(a[i], b[i]))
      result.push_back(fmt::format("now:      {}\n       baseline: {}", i < a.size() ? a[i] : "nothing",
                                   i < b.size() ? b[i] : "nothing"));
  return result;
}

} // namespace rimpact::hard_cases
