#include "calibration/export/opensees.h"
#include "calibration/export/comment.h"
#include "calibration/export/dish_text.h"
#include "calibration/export/flown_there.h"
#include "calibration/export/opensees_dish_texts.h"
#include "calibration/export/opensees_texts.h"
#include "calibration/export/self_check_text.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

namespace {

std::string exact(double value) {
  return fmt::format("{:.10g}", value);
}

/// What differs between the two languages.
struct Language {
  std::string (*assign)(const std::string &name, const std::string &value);
  std::string (*list)(const std::vector<std::string> &values);
};
std::string set_tcl(const std::string &name, const std::string &value) {
  return "set " + name + " " + value + ";";
}
std::string set_python(const std::string &name, const std::string &value) {
  return name + " = " + value;
}
std::string list_tcl(const std::vector<std::string> &values) {
  return fmt::format("{{{}}}", fmt::join(values, " "));
}
std::string list_python(const std::vector<std::string> &values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}
constexpr Language tcl{set_tcl, list_tcl}, python{set_python, list_python};

template <class Each> std::vector<std::string> column(const std::vector<GapSpring> &springs, Each each) {
  std::vector<std::string> out;
  for (const auto &spring : springs) out.push_back(exact(each(spring)));
  return out;
}

std::string rim_variables(const Language &in, const ExportedRim &rim, const OpenSeesRim &r) {
  std::string text;
  const auto line = [&](const std::string &name, const std::string &value, const std::string &what) {
    text += in.assign(name, value) + "  # " + what + "\n";
  };
  line("m1", exact(rim.mass), "kg, the supported mass; m2, the rim, is fixed");
  line("dead_load", exact(rim.vertical), "N, W");
  line("lateral_capacity", exact(rim.lateral_capacity), "m, travel at which the rim begins");
  if (!r.springs.empty()) {
    line("rim_stiffness", in.list(column(r.springs, [](auto &s) { return s.stiffness; })),
         "N/m, of each spring's loading and unloading");
    line("rim_yield_force", in.list(column(r.springs, [](auto &s) { return s.yield_force; })), "N");
    line("rim_hardening", in.list(column(r.springs, [](auto &s) { return s.hardening; })),
         "slope beyond yield over rim_stiffness");
    line("rim_begins", in.list(column(r.springs, [&](auto &s) { return rim.lateral_capacity + s.start; })),
         "m, travel at which each spring begins");
  }
  for (const auto &[name, value, what] : r.material.numbers) line(name, exact(value), what);
  if (rim.law().of_mass) line("restitution", exact(rim.settings.restitution), "e, from which c_i is made");
  return text;
}

constexpr double lever_arm = 0.1;      ///< from foot to end [m]; the linkage's motion does not depend on it
constexpr double rigid_over_pad = 100; ///< stiffness of the linkage's parts over the pad's

/// Yield moment and stiffness of the hinge between seat and foot that opposes the rise: the lever turns by the rise
/// over ratio times arm. It builds up over the travel that the friction does, at half the way to the rim.
std::pair<double, double> rise_hinge(const ExportedRim &rim, const Dish &dish) {
  const double per_rise = dish.rider.ratio * lever_arm, moment = dish.rises * rim.vertical * per_rise;
  return {moment, moment * per_rise / (dish.elastic_slip * dish.rider.slope(rim.lateral_capacity / 2))};
}

std::string dish_variables(const Language &in, const ExportedRim &rim, const Dish &dish) {
  std::string text;
  const auto line = [&](const std::string &name, const std::string &value, const std::string &what) {
    text += in.assign(name, value) + "  # " + what + "\n";
  };
  line("mu_slow", exact(dish.ride_slow), "friction of the sliding element at rest");
  line("mu_fast", exact(dish.ride_fast), "friction of the sliding element at speed");
  line("friction_rate", exact(dish.is_coulomb() ? 1 : dish.rate),
       dish.is_coulomb() ? "s/m, without effect: the two are equal" : "s/m, of the change between the two");
  line("friction_stiffness", exact(dish.ride_stiffness(rim.vertical)), "N/m, before it slides");
  line("vertical_stiffness", exact(dish.vertical_stiffness), "N/m, of the pad");
  line("rigid_stiffness", exact(rigid_over_pad * dish.vertical_stiffness), "N/m, of the linkage's parts");
  line("free_rotation", "1.0", "N m/rad, a hinge's small stiffness");
  line("dish_half_width", exact(dish.rider.half_width), "m, of the ellipsoid: length of its truss");
  line("dish_ratio", exact(dish.rider.ratio), "its height over its half-width, 1: a sphere");
  line("lever_arm", exact(lever_arm), "m, from the foot to the lever's end");
  const auto [moment, stiffness] = rise_hinge(rim, dish);
  line("rise_moment", exact(moment), "N m, of the friction that opposes the rise");
  line("rise_stiffness", exact(stiffness), "N m/rad, before it slides");
  std::vector<std::string> travel, force;
  for (std::size_t i = 1; i < dish.travel.size(); ++i)
    travel.push_back(exact(dish.travel[i])), force.push_back(exact(rim.vertical * dish.left[i]));
  line("dish_travel", in.list(travel), "m, from the centre");
  line("dish_force_left", in.list(force), "N, restoring force that the ellipsoid leaves");
  return text;
}

std::string head(const ExportedRim &rim, const OpenSeesRim &r, const std::optional<Dish> &dish,
                 const std::vector<std::string> &header) {
  std::string text =
      comment_lines("#", header) + comment_lines("#", rim.statement) + comment_lines("#", r.material.notes);
  if (dish && !r.springs.empty())
    text +=
        comment_line("#", "rimpact_bearing takes rim_round, or with along_x as its last word rim_springs: for motion "
                          "along x they keep the dents that a second hit meets.");
  if (dish) text += comment_lines("#", riding_lines(*dish, rim.vertical));
  text += comment_lines("#", lines_of(r.check));
  const double shortest = r.check.rows.back().spring.duration;
  text += comment_line(
      "#", fmt::format("Time step while the rim is pressed: at most {:.2g} s, a fortieth of the contact at {:.3g} m/s.",
                       shortest / 40, r.check.rows.back().speed));
  return text + comment_line("#", FlownThere{}.sentence()) +
         comment_line("#",
                      "Units: N, m, s, kg. The self-check is of rimpact's own integrator with the rules of OpenSees' "
                      "source.");
}

/// A material's numbers by name, its gap third as OpenSees takes it; none: without a gap.
std::vector<std::string> numbers_with_gap(const OpenSeesRim &r, const std::string &sigil,
                                          const std::optional<std::string> &gap) {
  std::vector<std::string> words;
  for (const auto &number : r.material.numbers) words.push_back(sigil + number.name);
  if (gap) words.insert(words.begin() + 2, *gap);
  return words;
}

constexpr const char *anchor_comment = "m, below the plate's node: length of the trusses at rest";

} // namespace

std::string opensees_tcl(const ExportedRim &rim, const OpenSeesRim &r, const std::optional<Dish> &dish,
                         const std::vector<std::string> &header) {
  std::string text = head(rim, r, dish, header) + rim_variables(tcl, rim, r) +
                     fmt::format("set anchor_depth 0.001;  # {}\n", anchor_comment);
  if (dish) text += dish_variables(tcl, rim, *dish);
  const BearingWords *whole = &tcl_bearing_one;
  if (r.material.material == laws::RimMaterial::gap_springs)
    text += tcl_springs_elastoplastic, whole = &tcl_bearing_either;
  else if (r.in_series)
    text += tcl_springs_in_series, whole = &tcl_bearing_series;
  else
    text += fmt::format(tcl_springs_one, fmt::join(numbers_with_gap(r, "", {}), " "), word(r.material.material),
                        fmt::join(numbers_with_gap(r, "$", "[expr {-$lateral_capacity}]"), " "));
  if (!dish) return text;
  return text + tcl_anchor + tcl_rider_nodes + tcl_dish +
         fmt::format(tcl_bearing, whole->says, whole->word, whole->rim);
}

std::string opensees_python(const ExportedRim &rim, const OpenSeesRim &r, const std::optional<Dish> &dish,
                            const std::vector<std::string> &header) {
  std::string text = head(rim, r, dish, header) + "from math import hypot\n\n" + rim_variables(python, rim, r) +
                     fmt::format("anchor_depth = 0.001  # {}\n", anchor_comment);
  if (dish) text += dish_variables(python, rim, *dish);
  const BearingWords *whole = &python_bearing_one;
  if (r.material.material == laws::RimMaterial::gap_springs)
    text += python_springs_elastoplastic, whole = &python_bearing_either;
  else if (r.in_series)
    text += python_springs_in_series, whole = &python_bearing_series;
  else
    text += fmt::format(python_springs_one, word(r.material.material),
                        fmt::join(numbers_with_gap(r, "", "-lateral_capacity"), ", "));
  if (!dish) return text;
  return text + python_anchor + python_rider_nodes + python_dish +
         fmt::format(python_bearing, whole->word, whole->says, whole->rim);
}

} // namespace rimpact::calibration
