#include "calibration/export/opensees.h"
#include "calibration/export/comment.h"
#include "files/error.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

namespace {

std::string exact(double value) {
  return fmt::format("{:.10g}", value);
}

OpenSeesRim elastoplastic(const ExportedRim &rim) {
  OpenSeesRim out{.springs = gap_springs(rim), .material = {}, .values = {}, .check = {}, .notes = {}};
  out.check = self_check(
      rim, "four ElasticPPGap in parallel", [&](double) { return std::make_unique<GapSpringsContact>(out.springs); },
      total_stiffness(out.springs));
  out.notes = {"Rim: four bilinear gap springs in parallel, tuned to the law over the speeds of the self-check. They "
               "unload in straight lines where the law's unloading bends.",
               "rim_springs: two along x, each side keeps its own dent; blind to y. rim_round: one round rim for any "
               "direction, but every impact meets it as new: no dents."};
  return out;
}

OpenSeesRim dashpot(const ExportedRim &rim) {
  const auto element = rim.element();
  OpenSeesRim out{.springs = {}, .material = RimMaterial::viscoelastic_gap, .values = {}, .check = {}, .notes = {}};
  out.values = {{"k_i", exact(element.stiffness), "N/m"},
                {"c_i", exact(element.damping), "N s/m, 2 xi sqrt(k_i m1), m2 infinite"}};
  out.check = self_check(
      rim, "ViscoelasticGap",
      [&](double) { return std::make_unique<DashpotContact>(element.stiffness, element.damping, true); },
      element.stiffness);
  out.notes = {element.law->unilateral ? "Rim: ViscoelasticGap pulls just before release, which the law does not: it "
                                         "returns e exactly, the law a little more."
                                       : "Rim: ViscoelasticGap is the law itself; it pulls just before release.",
               "rim_springs: two along x, blind to y: OpenSees has no round gap with a dashpot. Turn x along the "
               "motion, or export a law of the rim (elastoplastic)."};
  return out;
}

OpenSeesRim hertzdamp(const ExportedRim &rim) {
  const auto element = rim.element();
  const double d = reduced::hunt_crossley_penetration, K = element.stiffness * std::pow(d, 1 - element.exponent),
               xi = element.dissipation * rim.settings.reference_speed;
  OpenSeesRim out{.springs = {}, .material = RimMaterial::hertzdamp, .values = {}, .check = {}, .notes = {}};
  out.values = {{"K_h", exact(K), "N/m^n"},
                {"xi_norm", exact(xi), "chi times the reference speed"},
                {"exponent", exact(element.exponent), "n"}};
  const double deep = std::sqrt(rim.mass / element.stiffness) * rim.to,
               stiff =
                   element.stiffness * std::max(1.0, 4 * element.exponent * std::pow(deep / d, element.exponent - 1));
  out.check = self_check(
      rim, "Hertzdamp", [&](double v) { return std::make_unique<HertzdampContact>(K, xi, element.exponent, v); },
      stiff);
  out.notes = {fmt::format("Rim: Hertzdamp is the law at {:g} m/s; its damping is normalised by each impact's own "
                           "speed, so that the restitution stays where the law's falls with speed.",
                           rim.settings.reference_speed),
               "rim_springs: two along x, blind to y. No dents."};
  return out;
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
  }
  for (const auto &[name, value, what] : r.values) line(name, value, what);
  if (r.material && r.values.size() == 2)
    line("restitution", exact(rim.settings.restitution), "e, from which c_i is made");
  return text;
}

std::string dish_variables(const Language &in, const ExportedRim &rim, const Dish &dish) {
  std::string text;
  const auto line = [&](const std::string &name, const std::string &value, const std::string &what) {
    text += in.assign(name, value) + "  # " + what + "\n";
  };
  line("mu_slow", exact(dish.mu_slow), "friction at rest");
  line("mu_fast", exact(dish.mu_fast), "friction at speed");
  line("friction_rate", exact(dish.mu_slow == dish.mu_fast ? 1 : dish.rate),
       dish.mu_slow == dish.mu_fast ? "s/m, without effect: the two are equal" : "s/m, of the change between the two");
  line("friction_stiffness", exact(dish.initial_stiffness(rim.vertical)), "N/m, before it slides");
  line("vertical_stiffness", exact(dish.vertical_stiffness), "N/m, of the pad");
  line("free_rotation", "1.0", "N m/rad, a hinge's small stiffness");
  if (dish.sphere) {
    line("dish_radius", exact(dish.radius), "m");
    return text;
  }
  std::vector<std::string> travel, force;
  for (std::size_t i = 1; i < dish.travel.size(); ++i)
    travel.push_back(exact(dish.travel[i])), force.push_back(exact(rim.vertical * dish.slope[i]));
  line("dish_travel", in.list(travel), "m, from the centre");
  line("dish_force", in.list(force), "N, restoring force W h'(r)");
  return text;
}

std::string head(const ExportedRim &rim, const OpenSeesRim &r, const std::optional<Dish> &dish,
                 const std::vector<std::string> &header) {
  std::string text = comment_lines("#", header) + comment_lines("#", rim.statement) + comment_lines("#", r.notes);
  if (dish) text += comment_lines("#", dish->lines(rim.vertical));
  text += comment_lines("#", r.check.lines());
  const double shortest = r.check.rows.back().spring.duration;
  text += comment_line(
      "#", fmt::format("Time step while the rim is pressed: at most {:.2g} s, a fortieth of the contact at {:.3g} m/s.",
                       shortest / 40, r.check.rows.back().speed));
  return text + comment_line("#", "Units: N, m, s, kg. Not run in OpenSees here: the spring was flown by rimpact's own "
                                  "integrator with the rules of OpenSees' source.");
}

} // namespace

OpenSeesRim opensees_rim(const ExportedRim &rim) {
  if (rim.law() == "elastoplastic") return elastoplastic(rim);
  if (rim.law() == "hunt-crossley") return hertzdamp(rim);
  if (rim.law() == "signed" || rim.law() == "no-tension") return dashpot(rim);
  throw DataError(fmt::format("OpenSees has no material for the impact law {}", rim.law()));
}

namespace {

constexpr const char *tcl_springs_elastoplastic = R"(
# Makes the rim's material `tag` of parts tag+1 ...; `sign` -1: a gap that closes in compression, +1: one that opens to
# `gap` in tension; forces per unit of strain times `length`.
proc rim_material {tag sign gap length damage} {
  global rim_stiffness rim_yield_force rim_hardening
  set parts {}
  foreach E $rim_stiffness Fy $rim_yield_force eta $rim_hardening {
    set part [expr {$tag + 1 + [llength $parts]}]
    uniaxialMaterial ElasticPPGap $part [expr {$E * $length}] [expr {$sign * $Fy}] [expr {$sign * $gap}] $eta $damage
    lappend parts $part
  }
  uniaxialMaterial Parallel $tag {*}$parts
}
# Two springs along x between the plate's node and the slider's, which lie at the same place: elements first, first+1.
proc rim_springs {tag first plate slider} {
  global lateral_capacity
  rim_material $tag -1 $lateral_capacity 1.0 damage
  element zeroLength $first $plate $slider -mat $tag -dir 1 -orient -1 0 0 0 -1 0
  element zeroLength [expr {$first + 1}] $plate $slider -mat $tag -dir 1 -orient 1 0 0 0 1 0
}
# The round rim: element `first` from the node `anchor` (see anchor_node) to the slider.
proc rim_round {tag first anchor slider} {
  global lateral_capacity anchor_depth
  set gap [expr {(sqrt($lateral_capacity ** 2 + $anchor_depth ** 2) - $anchor_depth) / $anchor_depth}]
  rim_material $tag 1 $gap $anchor_depth noDamage
  element corotTruss $first $anchor $slider 1.0 $tag
}
)";

constexpr const char *python_springs_elastoplastic = R"(

def rim_material(ops, tag, sign, gap, length, damage):
    """The rim's material `tag` of parts tag+1 ...; `sign` -1: a gap that closes in compression, +1: one that opens to
    `gap` in tension; forces per unit of strain times `length`."""
    parts = []
    for E, Fy, eta in zip(rim_stiffness, rim_yield_force, rim_hardening):
        parts.append(tag + 1 + len(parts))
        ops.uniaxialMaterial("ElasticPPGap", parts[-1], E * length, sign * Fy, sign * gap, eta, damage)
    ops.uniaxialMaterial("Parallel", tag, *parts)


def rim_springs(ops, tag, first, plate, slider):
    """Two springs along x between the plate's node and the slider's, which lie at the same place: elements first,
    first+1. `ops` is openseespy.opensees."""
    rim_material(ops, tag, -1, lateral_capacity, 1.0, "damage")
    ops.element("zeroLength", first, plate, slider, "-mat", tag, "-dir", 1, "-orient", -1.0, 0.0, 0.0, 0.0, -1.0, 0.0)
    ops.element("zeroLength", first + 1, plate, slider, "-mat", tag, "-dir", 1, "-orient", 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)


def rim_round(ops, tag, first, anchor, slider):
    """The round rim: element `first` from the node `anchor` (see anchor_node) to the slider."""
    gap = (hypot(lateral_capacity, anchor_depth) - anchor_depth) / anchor_depth
    rim_material(ops, tag, 1, gap, anchor_depth, "noDamage")
    ops.element("corotTruss", first, anchor, slider, 1.0, tag)
)";

constexpr const char *tcl_springs_one = R"(
# Two springs along x between the plate's node and the slider's, which lie at the same place: elements first, first+1.
proc rim_springs {{tag first plate slider}} {{
  global lateral_capacity {0}
  uniaxialMaterial {1} $tag {2}
  element zeroLength $first $plate $slider -mat $tag -dir 1 -orient -1 0 0 0 -1 0
  element zeroLength [expr {{$first + 1}}] $plate $slider -mat $tag -dir 1 -orient 1 0 0 0 1 0
}}
)";

constexpr const char *python_springs_one = R"(

def rim_springs(ops, tag, first, plate, slider):
    """Two springs along x between the plate's node and the slider's, which lie at the same place: elements first,
    first+1. `ops` is openseespy.opensees."""
    ops.uniaxialMaterial("{0}", tag, {1})
    ops.element("zeroLength", first, plate, slider, "-mat", tag, "-dir", 1, "-orient", -1.0, 0.0, 0.0, 0.0, -1.0, 0.0)
    ops.element("zeroLength", first + 1, plate, slider, "-mat", tag, "-dir", 1, "-orient", 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
)";

constexpr const char *tcl_anchor = R"(
# A node tied to the plate's, anchor_depth below it: what a corotTruss from it elongates by is the travel, in any direction.
proc anchor_node {node plate} {
  global anchor_depth
  set at [nodeCoord $plate]
  node $node [lindex $at 0] [lindex $at 1] [expr {[lindex $at 2] - $anchor_depth}]
  equalDOF $plate $node 1 2 3 4 5 6
}
)";
constexpr const char *python_anchor = R"(

def anchor_node(ops, node, plate):
    """A node tied to the plate's, anchor_depth below it: what a corotTruss from it elongates by is the travel, in any
    direction."""
    x, y, z = ops.nodeCoord(plate)
    ops.node(node, x, y, z - anchor_depth)
    ops.equalDOF(plate, node, 1, 2, 3, 4, 5, 6)
)";

constexpr const char *tcl_slider = R"(
# Materials tag, tag+1 and the friction model tag of the sliding element.
proc slider_materials {tag} {
  global mu_slow mu_fast friction_rate vertical_stiffness free_rotation
  uniaxialMaterial Elastic $tag $vertical_stiffness
  uniaxialMaterial Elastic [expr {$tag + 1}] $free_rotation
  frictionModel VelDependent $tag $mu_slow $mu_fast $friction_rate
}
)";
constexpr const char *python_slider = R"(

def slider_materials(ops, tag):
    """Materials tag, tag+1 and the friction model tag of the sliding element."""
    ops.uniaxialMaterial("Elastic", tag, vertical_stiffness)
    ops.uniaxialMaterial("Elastic", tag + 1, free_rotation)
    ops.frictionModel("VelDependent", tag, mu_slow, mu_fast, friction_rate)
)";

constexpr const char *tcl_sphere = R"(
# The dish: element `first` between the plate's node and the slider's.
proc dish {tag first plate slider anchor} {
  global dish_radius friction_stiffness
  slider_materials $tag
  set hinge [expr {$tag + 1}]
  element singleFPBearing $first $plate $slider $tag $dish_radius $friction_stiffness -P $tag -T $hinge -My $hinge -Mz $hinge -orient 0 0 1 1 0 0
}
)";
constexpr const char *python_sphere = R"(

def dish(ops, tag, first, plate, slider, anchor):
    """The dish: element `first` between the plate's node and the slider's."""
    slider_materials(ops, tag)
    ops.element("singleFPBearing", first, plate, slider, tag, dish_radius, friction_stiffness, "-P", tag, "-T", tag + 1,
                "-My", tag + 1, "-Mz", tag + 1, "-orient", 0.0, 0.0, 1.0, 1.0, 0.0, 0.0)
)";
constexpr const char *tcl_table = R"(
# The dish: element `first` slides, first+1 restores; its table turned from travel to elongation of a truss of anchor_depth.
proc dish {tag first plate slider anchor} {
  global dish_travel dish_force friction_stiffness anchor_depth
  slider_materials $tag
  set hinge [expr {$tag + 1}]
  element flatSliderBearing $first $plate $slider $tag $friction_stiffness -P $tag -T $hinge -My $hinge -Mz $hinge -orient 0 0 1 1 0 0
  set strain {-1.0 0.0}
  set force {0.0 0.0}
  foreach r $dish_travel F $dish_force {
    set length [expr {sqrt($r ** 2 + $anchor_depth ** 2)}]
    lappend strain [expr {$length / $anchor_depth - 1.0}]
    lappend force [expr {$F * $length / $r}]
  }
  uniaxialMaterial ElasticMultiLinear [expr {$tag + 2}] -strain {*}$strain -stress {*}$force
  element corotTruss [expr {$first + 1}] $anchor $slider 1.0 [expr {$tag + 2}]
}
)";
constexpr const char *python_table = R"(

def dish(ops, tag, first, plate, slider, anchor):
    """The dish: element `first` slides, first+1 restores; its table turned from travel to elongation of a truss of
    anchor_depth."""
    slider_materials(ops, tag)
    ops.element("flatSliderBearing", first, plate, slider, tag, friction_stiffness, "-P", tag, "-T", tag + 1,
                "-My", tag + 1, "-Mz", tag + 1, "-orient", 0.0, 0.0, 1.0, 1.0, 0.0, 0.0)
    strain, force = [-1.0, 0.0], [0.0, 0.0]
    for r, F in zip(dish_travel, dish_force):
        length = hypot(r, anchor_depth)
        strain.append(length / anchor_depth - 1.0)
        force.append(F * length / r)
    ops.uniaxialMaterial("ElasticMultiLinear", tag + 2, "-strain", *strain, "-stress", *force)
    ops.element("corotTruss", first + 1, anchor, slider, 1.0, tag + 2)
)";

constexpr const char *tcl_bearing = R"(
# The whole bearing between the plate's node and the slider's (same place, ndm 3, ndf 6, z up). Uses tags tag ... tag+19 of
# materials and friction models, tag ... tag+3 of elements and the node `anchor`. The slider's node carries m1 and dead_load.
proc rimpact_bearing {{tag plate slider anchor}} {{
  anchor_node $anchor $plate
  dish $tag $tag $plate $slider $anchor
  {}
}}
)";
constexpr const char *python_bearing = R"(

def rimpact_bearing(ops, tag, plate, slider, anchor):
    """The whole bearing between the plate's node and the slider's (same place, ndm 3, ndf 6, z up). Uses tags tag ...
    tag+19 of materials and friction models, tag ... tag+3 of elements and the node `anchor`. The slider's node carries
    m1 and dead_load."""
    anchor_node(ops, anchor, plate)
    dish(ops, tag, tag, plate, slider, anchor)
    {}
)";

constexpr const char *anchor_comment = "m, below the plate's node: length of the trusses at rest";

} // namespace

std::string opensees_tcl(const ExportedRim &rim, const OpenSeesRim &r, const std::optional<Dish> &dish,
                         const std::vector<std::string> &header) {
  std::string text = head(rim, r, dish, header) + rim_variables(tcl, rim, r) +
                     fmt::format("set anchor_depth 0.001;  # {}\n", anchor_comment);
  if (dish) text += dish_variables(tcl, rim, *dish);
  if (!r.springs.empty())
    text += tcl_springs_elastoplastic;
  else {
    const bool hertz = r.material == RimMaterial::hertzdamp;
    text += fmt::format(tcl_springs_one, hertz ? "K_h xi_norm exponent" : "k_i c_i", word(*r.material),
                        hertz ? "$K_h $xi_norm [expr {-$lateral_capacity}] $exponent"
                              : "$k_i $c_i [expr {-$lateral_capacity}]");
  }
  if (!dish) return text;
  text += std::string(tcl_anchor) + tcl_slider + (dish->sphere ? tcl_sphere : tcl_table);
  return text + fmt::format(tcl_bearing, r.springs.empty()
                                             ? "rim_springs [expr {$tag + 10}] [expr {$tag + 2}] $plate $slider"
                                             : "rim_round [expr {$tag + 10}] [expr {$tag + 2}] $anchor $slider");
}

std::string opensees_python(const ExportedRim &rim, const OpenSeesRim &r, const std::optional<Dish> &dish,
                            const std::vector<std::string> &header) {
  std::string text = head(rim, r, dish, header) + "from math import hypot\n\n" + rim_variables(python, rim, r) +
                     fmt::format("anchor_depth = 0.001  # {}\n", anchor_comment);
  if (dish) text += dish_variables(python, rim, *dish);
  if (!r.springs.empty())
    text += python_springs_elastoplastic;
  else
    text += fmt::format(python_springs_one, word(*r.material),
                        r.material == RimMaterial::hertzdamp ? "K_h, xi_norm, -lateral_capacity, exponent"
                                                             : "k_i, c_i, -lateral_capacity");
  if (!dish) return text;
  text += std::string(python_anchor) + python_slider + (dish->sphere ? python_sphere : python_table);
  return text + fmt::format(python_bearing, r.springs.empty() ? "rim_springs(ops, tag + 10, tag + 2, plate, slider)"
                                                              : "rim_round(ops, tag + 10, tag + 2, anchor, slider)");
}

} // namespace rimpact::calibration
