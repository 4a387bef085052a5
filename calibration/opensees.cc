#include "calibration/opensees.h"
#include "reduced_models/impact_law.h"
#include "scene/error.h"
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

namespace {

using nlohmann::json;

const json &at(const json &object, const char *key) {
  if (!object.is_object() || !object.contains(key) || object[key].is_null())
    throw DataError(fmt::format("calibration.json holds no {}; run `rimpact calibrate` again", key));
  return object[key];
}

double number_at(const json &object, const char *key, double si = 1) {
  const json &entry = at(object, key);
  const json &value = entry.is_object() ? at(entry, "value") : entry;
  if (!value.is_number()) throw DataError(fmt::format("calibration.json: {} is not a number", key));
  return si * value.get<double>();
}

/// The material's command, its arguments after the tag, and how far it is the law.
struct Material {
  std::string name;
  std::vector<double> arguments;
  std::string option, note;
};

Material material_of(const RimSprings &r) {
  const double gap = -r.lateral_capacity; // negative: closes in compression
  if (r.law == "signed") return {"ViscoelasticGap", {r.k_i, r.damping, gap}, "", "the fitted law itself"};
  if (r.law == "no-tension")
    return {"ViscoelasticGap",
            {r.k_i, r.damping, gap},
            "",
            "the fitted law, but it pulls just before release: it returns e exactly, the fitted law a little "
            "more"};
  if (r.law == "hunt-crossley") {
    const double d = reduced::hunt_crossley_penetration;
    const double chi = reduced::hunt_crossley_dissipation(r.restitution, r.reference_speed);
    return {
        "Hertzdamp",
        {r.k_i * std::pow(d, 1 - r.exponent), chi * r.reference_speed, gap, r.exponent},
        "",
        fmt::format(
            "the fitted law at {:g} m/s; its damping is normalised by each impact's own speed, so that the "
            "restitution stays where the fitted law's falls with speed",
            r.reference_speed)};
  }
  if (r.law == "elastoplastic") {
    const auto [yield_force, hardening] = bilinear_of(r);
    return {
        "ElasticPPGap",
        {r.k_i, -yield_force, gap, hardening},
        "damage",
        fmt::format("bilinear, with the fitted law's largest force and penetration at {:g} m/s; it unloads "
                    "along k_i and rebounds faster; the dent stays",
                    r.reference_speed)};
  }
  throw DataError(fmt::format("OpenSees has no material for the impact law {}", r.law));
}

std::string stated(const RimSprings &r, int n, const Material &material, const char *assign) {
  if (n != 2 && n < 4) throw InputError(fmt::format("springs {} must be 2 (along x), or 4 or more (around the slider)", n));
  std::string text = "# Rim impact fitted by rimpact; SI units: N, m, s, kg.\n";
  const auto line = [&](const char *name, double value, const char *what) {
    text += fmt::format(fmt::runtime(assign), name, value) + fmt::format("  # {}\n", what);
  };
  text += fmt::format("# Impact law {}; material {}: {}.\n", r.law, material.name, material.note);
  for (const auto &remark : r.remarks) text += "# " + remark + "\n";
  line("k_i", r.k_i, "N/m");
  line("restitution", r.restitution, "-");
  line("c_i", r.damping, "N s/m, 2 xi sqrt(k_i m1), m2 infinite");
  line("m1", r.mass, "kg, the supported mass; m2, the rim, is fixed");
  line("lateral_capacity", r.lateral_capacity, "m, travel at which the rim begins");
  line("n_springs", n, n == 2 ? "along x: exact for motion along x, blind to y" : "around the slider");
  if (n == 2) return text;
  for (const double d : {1e-3, 5e-3}) {
    const auto error = polygon_error(n, r.lateral_capacity, d);
    text += fmt::format(
        "# A polygon is not a circle: between two springs the rim is touched {:.2f} mm late; {:g} mm beyond "
        "the rim a linear force is wrong by up to {:.0f} %.\n",
        1e3 * error.gap, 1e3 * d, 100 * error.force);
  }
  return text;
}

/// Each fitted value with its interval, and where the values hold.
std::vector<std::string> remarks_of(const json &calibration) {
  std::vector<std::string> remarks;
  const json parameters = calibration.value("parameters", json::object());
  for (const auto &[name, fitted] : parameters.items()) {
    const std::string unit = fitted.value("unit", "");
    std::string text = fmt::format("Fitted: {} = {:.4g}{}", name, number_at(fitted, "value"), unit == "-" ? "" : " " + unit);
    const json interval = fitted.value("interval_95", json());
    if (interval.is_array() && interval.size() == 2 && interval[0].is_number() && interval[1].is_number())
      text += fmt::format(", 95 % interval {:.4g} to {:.4g}", interval[0].get<double>(), interval[1].get<double>());
    remarks.push_back(text + (fitted.value("identifiable", true) ? "." : "; not identifiable from these runs."));
  }
  const json windows = calibration.value("windows", json());
  const std::string sentence = windows.is_object() ? windows.value("sentence", "") : "";
  remarks.push_back("Validity: " + (sentence.empty() ? "not known, no impact windows over speed were given." : sentence));
  return remarks;
}

} // namespace

RimSprings rim_springs(const json &calibration) {
  const json &derived = at(calibration, "derived"), &element = at(derived, "element");
  RimSprings r;
  if (!at(derived, "law").is_string()) throw DataError("calibration.json: law is not a word");
  r.law = derived["law"];
  r.k_i = number_at(element, "k_i", 1e3);
  r.mass = number_at(at(derived, "masses"), "m1_kg");
  r.lateral_capacity = number_at(element, "lateral_capacity_m");
  const bool elastoplastic = element.contains("yield_force");
  if (!elastoplastic) r.restitution = number_at(element, "e");
  if (element.contains("exponent")) {
    r.exponent = number_at(element, "exponent");
    r.reference_speed = number_at(element, "reference_speed_m_per_s");
  } else if (elastoplastic) {
    r.reference_speed = number_at(element, "reference_speed_m_per_s");
    r.yield_force = number_at(element, "yield_force", 1e3);
    r.hardening = number_at(element, "hardening");
    if (element.contains("hardening_exponent")) r.hardening_exponent = number_at(element, "hardening_exponent");
  } else
    r.damping = number_at(derived, "c_i", 1e3);
  r.remarks = remarks_of(calibration);
  return r;
}

std::string opensees_tcl(const RimSprings &r, int n) {
  const Material material = material_of(r);
  return stated(r, n, material, "set {} {:.10g};") +
         fmt::format("# Adds the material `tag` and n_springs zeroLength elements, numbered from `first`, "
                     "between the plate's\n"
                     "# node and the slider's (same place, ndm 3). The slider presses where it moves {:.4g} "
                     "m outwards.\n"
                     "proc rim_springs {{tag first plate slider}} {{\n"
                     "  global n_springs\n"
                     "  uniaxialMaterial {} $tag {:.10g}{}{}\n"
                     "  for {{set i 0}} {{$i < $n_springs}} {{incr i}} {{\n"
                     "    set angle [expr {{2.0 * acos(-1.0) * $i / $n_springs}}]\n"
                     "    set c [expr {{cos($angle)}}]\n"
                     "    set s [expr {{sin($angle)}}]\n"
                     "    element zeroLength [expr {{$first + $i}}] $plate $slider -mat $tag -dir 1 -orient "
                     "[expr {{-$c}}] "
                     "[expr {{-$s}}] 0 $s [expr {{-$c}}] 0\n"
                     "  }}\n"
                     "}}\n",
                     r.lateral_capacity, material.name, fmt::join(material.arguments, " "),
                     material.option.empty() ? "" : " ", material.option);
}

std::string opensees_python(const RimSprings &r, int n) {
  const Material material = material_of(r);
  return stated(r, n, material, "{} = {:.10g}") +
         fmt::format(
             "\n\ndef rim_springs(ops, tag, first, plate, slider):\n"
             "    \"\"\"Adds the material `tag` and n_springs zeroLength elements, numbered from `first`, "
             "between the\n"
             "    plate's node and the slider's (same place, ndm 3). `ops` is openseespy.opensees.\"\"\"\n"
             "    from math import cos, pi, sin\n"
             "    ops.uniaxialMaterial(\"{}\", tag, {:.10g}{})\n"
             "    for i in range(int(n_springs)):\n"
             "        c, s = cos(2 * pi * i / n_springs), sin(2 * pi * i / n_springs)\n"
             "        ops.element(\"zeroLength\", first + i, plate, slider, \"-mat\", tag, \"-dir\", 1,\n"
             "                    \"-orient\", -c, -s, 0.0, s, -c, 0.0)\n",
             material.name, fmt::join(material.arguments, ", "),
             material.option.empty() ? "" : fmt::format(", \"{}\"", material.option));
}

} // namespace rimpact::calibration
