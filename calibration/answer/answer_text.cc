#include "calibration/answer/answer_text.h"
#include "calibration/answer/calibration_json.h"
#include "calibration/answer/said_once.h"
#include "calibration/laws/percent.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// One line of a comment, whatever a name holds.
std::string comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  return "# " + text + "\n";
}

std::string assigned(const std::string &name, double si) {
  const auto &p = parameter(name);
  return fmt::format("{} = {:.9g}\n", p.toml_key.substr(p.toml_key.find('.') + 1), si / p.si);
}

/// What was fitted or held beside the law's own numbers, by table of the scene file.
std::string others(const Answer &a, const std::string &table) {
  const laws::ImpactLaw &law = laws::impact_law(a.law.result.law);
  auto values = a.law.result.fixed;
  for (const auto &[name, estimate] : a.law.result.parameters) values[name] = estimate.value;
  std::string text;
  for (const auto &[name, value] : values)
    if (const auto &p = parameter(name); !law.reads(name) && p.toml_key.rfind(table + ".", 0) == 0)
      text += assigned(name, value * p.si);
  return text;
}

std::string row_text(const AnswerRow &r, bool with_pair) {
  const auto error = [](const std::optional<double> &e) { return e ? percent_up(*e) : std::string("-"); };
  std::string text = fmt::format("  {:7.3g} {:9.4g} {:>8} {:8.3g} {:>8} {:9.3g} {:9.3g}", r.speed, r.peak_force / 1e3,
                                 error(r.peak_force_error), r.restitution, error(r.rebound_error), 1e3 * r.penetration,
                                 1e3 * r.contact_time);
  if (with_pair)
    text += fmt::format(" {:>11} {:>7}", r.k_i ? fmt::format("{:.3g}", *r.k_i / 1e3) : "-",
                        r.e ? fmt::format("{:.3f}", *r.e) : "-");
  return text + "\n";
}

/// What follows from the law at five speeds. Where a constant pair is given it is the one pair; else each speed has
/// its.
std::string table_text(const Answer &a) {
  std::string text = fmt::format("one impact of {:.6g} kg by this law (errors of runs {})", a.scene.load.mass,
                                 word(a.table.empty() ? ErrorFrom::fitted : a.table.front().error_from));
  if (!a.pair)
    text += fmt::format(", and the pair k_i, e of law {} that returns the same at that one speed and mass", a.pair_law);
  text += "\n      m/s   peak kN      off  rebound      off  depth mm   time ms";
  text += a.pair ? "\n" : "  k_i kN/m         e\n";
  for (const auto &row : a.table) text += row_text(row, !a.pair);
  return text;
}

/// Both steels at the speeds of the twins.
std::string band_text(const SteelBand &band) {
  std::string text =
      "steel without and with its strain rate\n      m/s   peak kN      fast  depth mm      fast  rebound "
      "     fast\n";
  for (const SteelTwin &twin : band.twins) {
    const Impact &slow = twin.static_steel, &fast = twin.fast;
    text += fmt::format("  {:7.3g} {:9.4g} {:9.4g} {:9.3g} {:9.3g} {:8.3g} {:9.3g}\n", twin.speed,
                        slow.peak_force / 1e3, fast.peak_force / 1e3, 1e3 * slow.peak_penetration,
                        1e3 * fast.peak_penetration, slow.restitution(), fast.restitution());
  }
  for (const std::string &said : sentences(band)) text += said + "\n";
  return text;
}

} // namespace

std::string to_toml_fragment(const Answer &a) {
  const auto &r = a.scene.reduced;
  const laws::ImpactLaw &law = *r.impact_law;
  std::string text = comment(a.validity);
  if (!a.law.remark.empty()) text += comment(a.law.remark);
  text += comment(a.pair ? a.pair->sentence : a.no_pair);
  if (!a.mesh_error.sentence.empty()) text += comment(a.mesh_error.sentence);
  if (a.steel_band)
    for (const std::string &said : sentences(*a.steel_band)) text += comment(said);
  for (const auto &doubt : said_once(a.doubts)) text += comment("Doubt: " + doubt);
  text += fmt::format("[reduced]\nmodel = \"{}\"\nimpact_law = \"{}\"\n", word(r.model), r.impact_law->name);
  for (const auto *names : {&law.parameters, &law.exponents})
    for (const auto &name : *names) text += assigned(name, parameter(name).get(a.scene));
  if (law.reads("exponent")) text += fmt::format("reference_speed_m_per_s = {:.9g}\n", r.reference_speed);
  text += others(a, "reduced");
  if (a.stack)
    text +=
        fmt::format("finite_pad = true\nsocket_friction = true\nfriction = \"{}\"\n", word(scene::Friction::park_wen));
  if (a.stack && a.stack->on_pads_spring) text += fmt::format("normal_force = \"{}\"\n", word(scene::NormalForce::pad));
  if (a.stack && a.stack->slip_from == scene::SlipFrom::bearing)
    text += fmt::format("elastic_slip_mm = {:.9g}\n", 1e3 * a.stack->elastic_slip);
  text += fmt::format("fitted_from_m_per_s = {:.9g}\nfitted_to_m_per_s = {:.9g}\n", a.law.fitted_from, a.law.fitted_to);
  text +=
      fmt::format("{} = {:.9g}\n", a.law.of_the_mass ? "fitted_mass_kg" : "fitted_speeds_mass_kg", a.scene.load.mass);
  text += fmt::format("fitted_rim = \"{}\"\n", a.rim_identity);
  if (a.foot && a.foot->connection.kind != scene::ConnectionKind::monolithic)
    text += fmt::format("foot_joint = \"{}\"\n", strength_in_words(a.foot->connection));
  if (a.foot && a.foot->goes_at_force) text += fmt::format("foot_force_kN = {:.9g}\n", *a.foot->goes_at_force / 1e3);
  const std::string load = others(a, "load");
  return load.empty() ? text : text + "[load]\n" + load;
}

std::string describe(const Answer &a) {
  std::string text = a.law.sentence + "\n";
  if (!a.law.remark.empty()) text += a.law.remark + "\n";
  for (const auto &[name, e] : a.law.result.parameters)
    text += fmt::format("  {:<18} {:>12.5g} {:<6} 95 %: {:.5g} .. {:.5g}{}\n", name, e.value, parameter(name).unit,
                        e.interval_low, e.interval_high, e.identifiable ? "" : "  NOT IDENTIFIABLE: " + e.reason);
  if (!a.law.held.empty()) text += a.law.held + "\n";
  if (const auto &gain = a.law.result.gain)
    text += fmt::format("The force channel reads {:.3f} +- {:.3f} of the force that moves the mass (stated 1 +- {:g}); "
                        "the law is fitted to the force.\n",
                        gain->factor, gain->standard_error, gain->stated);
  text += table_text(a);
  text += (a.pair ? a.pair->sentence : a.no_pair) + "\n";
  if (a.strain)
    for (const std::string &said : {a.strain->exceeded() ? "" : a.strain->sentence, // else it is among the doubts
                                    a.strain->crack_sentence, a.strain->slider_sentence})
      if (!said.empty()) text += said + "\n";
  if (a.strain)
    for (const PlaceStrain &at : a.strain->places) text += "  " + at.sentence + "\n";
  if (a.foot) text += "  " + a.foot->sentence + "\n";
  if (!a.mesh_error.sentence.empty()) text += a.mesh_error.sentence + "\n";
  if (a.steel_band) text += band_text(*a.steel_band);
  for (const std::string &said : sentences(a.errors)) text += said + "\n";
  for (const std::string &said : finding_sentences(a.errors)) text += said + "\n";
  for (const auto &doubt : said_once(a.doubts)) text += "doubt: " + doubt + "\n";
  return text;
}

} // namespace rimpact::calibration
