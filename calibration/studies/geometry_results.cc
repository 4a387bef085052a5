#include "calibration/studies/geometry_results.h"

#include "calibration/fit/parameter.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {
using nlohmann::json;

struct Output {
  const char *name, *unit;
  double GeometryRow::*value;
  double si; ///< divides the row's value into the unit
};
constexpr Output outputs[] = {{"k_i", "kN/m", &GeometryRow::k_i, 1},
                              {"e", "-", &GeometryRow::e, 1},
                              {"peak_force", "kN", &GeometryRow::peak_force, 1e3},
                              {"plastic_strain", "-", &GeometryRow::plastic_strain, 1}};

std::vector<double> inputs_of(const scene::Scene &scene) {
  std::vector<double> inputs;
  for (const auto &axis : geometry_axes()) inputs.push_back(axis.get(scene) / axis.si);
  return inputs;
}

/// Speed at which the bearing's own rim meets the strain limit, where the surrogate says so.
std::string survival(const Surrogate &strain, const scene::Scene &window, double limit) {
  auto x = inputs_of(window);
  const std::size_t v = x.size() - 1;
  x[v] = strain.high[v];
  const double most = strain.at(x), top = x[v], exponent = strain.exponents[v];
  const auto text =
      fmt::format("The rim of {} at {:.2g} m/s: largest plastic strain {:.2g} (the surrogate errs by {:.0f} %, rms)",
                  window.bearing.name, top, most, 100 * strain.left_out_rms);
  if (most <= limit) return fmt::format("{}, below the limit {:g}: it survives what has been computed.", text, limit);
  if (!(exponent > 0)) return fmt::format("{}, beyond the limit {:g}.", text, limit);
  const double reached = top * std::pow(limit / most, 1 / exponent);
  if (reached < strain.low[v])
    return fmt::format("{}, beyond the limit {:g} at every speed computed (from {:.2g} m/s).", text, limit,
                       strain.low[v]);
  return fmt::format("{}; it meets the limit {:g} at {:.2g} m/s and survives below.", text, limit, reached);
}

json surrogate_json(const std::optional<Surrogate> &s, const Output &output) {
  if (!s) return nullptr;
  json inputs = json::object();
  for (std::size_t j = 0; j < s->centre.size(); ++j)
    inputs[geometry_axes()[j].name] = {{"unit", geometry_axes()[j].unit},
                                       {"centre", s->centre[j]},
                                       {"exponent", s->exponents[j]},
                                       {"from", s->low[j]},
                                       {"to", s->high[j]}};
  return {{"formula", "value = coefficient prod (input / centre)^exponent"},
          {"unit", output.unit},
          {"coefficient", s->coefficient},
          {"inputs", inputs},
          {"rows", s->n_rows},
          {"left_out_error_rms", s->left_out_rms},
          {"left_out_error_largest", s->left_out_largest}};
}

} // namespace

GeometryStudy geometry_study(std::vector<GeometryRow> rows, const scene::Scene &window,
                             const GeometryOptions &options) {
  GeometryStudy study{.rows = std::move(rows), .surrogates = {}, .sentence = {}};
  std::vector<std::vector<double>> x;
  x.reserve(study.rows.size());
  for (const auto &row : study.rows) x.push_back(row.inputs);
  for (const auto &output : outputs) {
    std::vector<double> y;
    y.reserve(study.rows.size());
    for (const auto &row : study.rows) y.push_back(row.*output.value / output.si);
    study.surrogates[output.name] = power_surrogate(x, y);
  }
  if (const auto &strain = study.surrogates["plastic_strain"])
    study.sentence = survival(*strain, window, options.strain_limit);
  else
    study.sentence = fmt::format("{} runs are too few for a surrogate of {} inputs: {} are needed.", study.rows.size(),
                                 geometry_axes().size(), geometry_axes().size() + 3);
  return study;
}

json to_json(const GeometryStudy &study) {
  json rows = json::array(), surrogates = json::object();
  for (const auto &row : study.rows) {
    json entry = {{"name", row.name}};
    for (std::size_t j = 0; j < row.inputs.size(); ++j) entry[geometry_axes()[j].name] = row.inputs[j];
    for (const auto &output : outputs) entry[output.name] = row.*output.value / output.si;
    entry["mass_kg"] = row.mass, entry["vertical_kN"] = row.weight / 1e3;
    rows.push_back(entry);
  }
  for (const auto &output : outputs) surrogates[output.name] = surrogate_json(study.surrogates.at(output.name), output);
  return {{"rows", rows}, {"surrogates", surrogates}, {"sentence", study.sentence}};
}

std::string to_csv(const GeometryStudy &study) {
  const auto column = [](const std::string &name, std::string unit) {
    if (unit == no_unit) return name;
    std::replace(unit.begin(), unit.end(), '/', 'p');
    return name + "_" + unit;
  };
  std::string text = "name";
  for (const auto &axis : geometry_axes()) text += fmt::format(",{}", column(axis.name, axis.unit));
  for (const auto &output : outputs) text += fmt::format(",{}", column(output.name, output.unit));
  text += ",mass_kg,vertical_kN"; // under which the row was flown
  for (const auto &row : study.rows) {
    text += "\n" + row.name;
    for (const double value : row.inputs) text += fmt::format(",{:.8g}", value);
    for (const auto &output : outputs) text += fmt::format(",{:.8g}", row.*output.value / output.si);
    text += fmt::format(",{:.8g},{:.8g}", row.mass, row.weight / 1e3);
  }
  return text + "\n";
}

std::string describe(const GeometryStudy &study) {
  std::string text = "name";
  for (const auto &axis : geometry_axes()) text += fmt::format(" {:>15}", axis.name);
  for (const auto &output : outputs) text += fmt::format(" {:>14}", output.name);
  for (const auto &row : study.rows) {
    text += "\n" + row.name;
    for (const double value : row.inputs) text += fmt::format(" {:15.4g}", value);
    for (const auto &output : outputs) text += fmt::format(" {:14.4g}", row.*output.value / output.si);
  }
  text += "\n";
  for (const auto &output : outputs) {
    const auto &s = study.surrogates.at(output.name);
    if (!s) continue;
    text += fmt::format("{} = {:.4g} {}", output.name, s->coefficient, output.unit);
    for (std::size_t j = 0; j < s->centre.size(); ++j)
      text += fmt::format(" ({} / {:.4g})^{:.2f}", geometry_axes()[j].name, s->centre[j], s->exponents[j]);
    text += fmt::format("; on rows left out it errs by {:.0f} % (rms), {:.0f} % at most\n", 100 * s->left_out_rms,
                        100 * s->left_out_largest);
  }
  return text + study.sentence + "\n";
}

} // namespace rimpact::calibration
