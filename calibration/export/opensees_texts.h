/// What an export to OpenSees says in every file, in Tcl and in Python; numbers stand before it as variables.
#pragma once

namespace rimpact::calibration {

inline constexpr const char *tcl_springs_elastoplastic = R"(
# Makes the rim's material `tag` of parts tag+1 ...; `sign` -1: gaps that close in compression, +1: those that open in
# tension; `gaps`: the strain at which each part begins; forces per unit of strain times `length`.
proc rim_material {tag sign gaps length damage} {
  global rim_stiffness rim_yield_force rim_hardening
  set parts {}
  foreach E $rim_stiffness Fy $rim_yield_force eta $rim_hardening gap $gaps {
    set part [expr {$tag + 1 + [llength $parts]}]
    uniaxialMaterial ElasticPPGap $part [expr {$E * $length}] [expr {$sign * $Fy}] [expr {$sign * $gap}] $eta $damage
    lappend parts $part
  }
  uniaxialMaterial Parallel $tag {*}$parts
}
# Two springs along x between the plate's node and the slider's, which lie at the same place: elements first, first+1.
proc rim_springs {tag first plate slider} {
  global rim_begins
  rim_material $tag -1 $rim_begins 1.0 damage
  element zeroLength $first $plate $slider -mat $tag -dir 1 -orient -1 0 0 0 -1 0
  element zeroLength [expr {$first + 1}] $plate $slider -mat $tag -dir 1 -orient 1 0 0 0 1 0
}
# The round rim: element `first` from the node `anchor` (see anchor_node) to the slider.
proc rim_round {tag first anchor slider} {
  global rim_begins anchor_depth
  set gaps {}
  foreach r $rim_begins { lappend gaps [expr {(sqrt($r ** 2 + $anchor_depth ** 2) - $anchor_depth) / $anchor_depth}] }
  rim_material $tag 1 $gaps $anchor_depth noDamage
  element corotTruss $first $anchor $slider 1.0 $tag
}
)";

inline constexpr const char *python_springs_elastoplastic = R"(

def rim_material(ops, tag, sign, gaps, length, damage):
    """The rim's material `tag` of parts tag+1 ...; `sign` -1: gaps that close in compression, +1: those that open in
    tension; `gaps`: the strain at which each part begins; forces per unit of strain times `length`."""
    parts = []
    for E, Fy, eta, gap in zip(rim_stiffness, rim_yield_force, rim_hardening, gaps):
        parts.append(tag + 1 + len(parts))
        ops.uniaxialMaterial("ElasticPPGap", parts[-1], E * length, sign * Fy, sign * gap, eta, damage)
    ops.uniaxialMaterial("Parallel", tag, *parts)


def rim_springs(ops, tag, first, plate, slider):
    """Two springs along x between the plate's node and the slider's, which lie at the same place: elements first,
    first+1. `ops` is openseespy.opensees."""
    rim_material(ops, tag, -1, rim_begins, 1.0, "damage")
    ops.element("zeroLength", first, plate, slider, "-mat", tag, "-dir", 1, "-orient", -1.0, 0.0, 0.0, 0.0, -1.0, 0.0)
    ops.element("zeroLength", first + 1, plate, slider, "-mat", tag, "-dir", 1, "-orient", 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)


def rim_round(ops, tag, first, anchor, slider):
    """The round rim: element `first` from the node `anchor` (see anchor_node) to the slider."""
    gaps = [(hypot(r, anchor_depth) - anchor_depth) / anchor_depth for r in rim_begins]
    rim_material(ops, tag, 1, gaps, anchor_depth, "noDamage")
    ops.element("corotTruss", first, anchor, slider, 1.0, tag)
)";

inline constexpr const char *tcl_springs_one = R"(
# Two springs along x between the plate's node and the slider's, which lie at the same place: elements first, first+1.
proc rim_springs {{tag first plate slider}} {{
  global lateral_capacity {0}
  uniaxialMaterial {1} $tag {2}
  element zeroLength $first $plate $slider -mat $tag -dir 1 -orient -1 0 0 0 -1 0
  element zeroLength [expr {{$first + 1}}] $plate $slider -mat $tag -dir 1 -orient 1 0 0 0 1 0
}}
)";

inline constexpr const char *python_springs_one = R"(

def rim_springs(ops, tag, first, plate, slider):
    """Two springs along x between the plate's node and the slider's, which lie at the same place: elements first,
    first+1. `ops` is openseespy.opensees."""
    ops.uniaxialMaterial("{0}", tag, {1})
    ops.element("zeroLength", first, plate, slider, "-mat", tag, "-dir", 1, "-orient", -1.0, 0.0, 0.0, 0.0, -1.0, 0.0)
    ops.element("zeroLength", first + 1, plate, slider, "-mat", tag, "-dir", 1, "-orient", 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
)";

inline constexpr const char *tcl_anchor = R"(
# A node tied to the plate's, anchor_depth below it: what a corotTruss from it elongates by is the travel, in any direction.
proc anchor_node {node plate} {
  global anchor_depth
  set at [nodeCoord $plate]
  node $node [lindex $at 0] [lindex $at 1] [expr {[lindex $at 2] - $anchor_depth}]
  equalDOF $plate $node 1 2 3 4 5 6
}
)";
inline constexpr const char *python_anchor = R"(

def anchor_node(ops, node, plate):
    """A node tied to the plate's, anchor_depth below it: what a corotTruss from it elongates by is the travel, in any
    direction."""
    x, y, z = ops.nodeCoord(plate)
    ops.node(node, x, y, z - anchor_depth)
    ops.equalDOF(plate, node, 1, 2, 3, 4, 5, 6)
)";

inline constexpr const char *tcl_slider = R"(
# Materials tag, tag+1 and the friction model tag of the sliding element.
proc slider_materials {tag} {
  global mu_slow mu_fast friction_rate vertical_stiffness free_rotation
  uniaxialMaterial Elastic $tag $vertical_stiffness
  uniaxialMaterial Elastic [expr {$tag + 1}] $free_rotation
  frictionModel VelDependent $tag $mu_slow $mu_fast $friction_rate
}
)";
inline constexpr const char *python_slider = R"(

def slider_materials(ops, tag):
    """Materials tag, tag+1 and the friction model tag of the sliding element."""
    ops.uniaxialMaterial("Elastic", tag, vertical_stiffness)
    ops.uniaxialMaterial("Elastic", tag + 1, free_rotation)
    ops.frictionModel("VelDependent", tag, mu_slow, mu_fast, friction_rate)
)";

inline constexpr const char *tcl_sphere = R"(
# The dish: element `first` between the plate's node and the slider's.
proc dish {tag first plate slider anchor} {
  global dish_radius friction_stiffness
  slider_materials $tag
  set hinge [expr {$tag + 1}]
  element singleFPBearing $first $plate $slider $tag $dish_radius $friction_stiffness -P $tag -T $hinge -My $hinge -Mz $hinge -orient 0 0 1 1 0 0
}
)";
inline constexpr const char *python_sphere = R"(

def dish(ops, tag, first, plate, slider, anchor):
    """The dish: element `first` between the plate's node and the slider's."""
    slider_materials(ops, tag)
    ops.element("singleFPBearing", first, plate, slider, tag, dish_radius, friction_stiffness, "-P", tag, "-T", tag + 1,
                "-My", tag + 1, "-Mz", tag + 1, "-orient", 0.0, 0.0, 1.0, 1.0, 0.0, 0.0)
)";
inline constexpr const char *tcl_table = R"(
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
inline constexpr const char *python_table = R"(

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

inline constexpr const char *tcl_bearing = R"(
# The whole bearing between the plate's node and the slider's (same place, ndm 3, ndf 6, z up). Uses tags tag ... tag+19 of
# materials and friction models, tag ... tag+3 of elements and the node `anchor`. The slider's node carries m1 and dead_load.
proc rimpact_bearing {{tag plate slider anchor}} {{
  anchor_node $anchor $plate
  dish $tag $tag $plate $slider $anchor
  {}
}}
)";
inline constexpr const char *python_bearing = R"(

def rimpact_bearing(ops, tag, plate, slider, anchor):
    """The whole bearing between the plate's node and the slider's (same place, ndm 3, ndf 6, z up). Uses tags tag ...
    tag+19 of materials and friction models, tag ... tag+3 of elements and the node `anchor`. The slider's node carries
    m1 and dead_load."""
    anchor_node(ops, anchor, plate)
    dish(ops, tag, tag, plate, slider, anchor)
    {}
)";

} // namespace rimpact::calibration
