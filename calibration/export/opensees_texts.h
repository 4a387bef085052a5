/// What an export to OpenSees says of rim and bearing, in Tcl and in Python; numbers stand before it as variables. The
/// dish: opensees_dish_texts.h.
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

inline constexpr const char *tcl_springs_in_series = R"(
# Two springs along x between the plate's node and the slider's, which lie at the same place: each a gap that only presses
# (elements first, first+1) and, behind the nodes joint and joint+1 that this makes, spring and dashpot (first+8, first+9).
proc rim_springs {tag first plate slider joint} {
  global lateral_capacity k_i c_i
  lassign [nodeCoord $plate] x y z
  uniaxialMaterial ElasticPPGap $tag [expr {1000.0 * $k_i}] [expr {-1e6 * $k_i}] [expr {-$lateral_capacity}]
  uniaxialMaterial Elastic [expr {$tag + 1}] $k_i $c_i
  foreach side {0 1} way {-1 1} {
    set node [expr {$joint + $side}]
    node $node $x $y $z
    fix $node 0 1 1 1 1 1
    element zeroLength [expr {$first + $side}] $node $slider -mat $tag -dir 1 -orient $way 0 0 0 $way 0
    element zeroLength [expr {$first + 8 + $side}] $plate $node -mat [expr {$tag + 1}] -dir 1
  }
}
)";

inline constexpr const char *python_springs_in_series = R"(

def rim_springs(ops, tag, first, plate, slider, joint):
    """Two springs along x between the plate's node and the slider's, which lie at the same place: each a gap that only
    presses (elements first, first+1) and, behind the nodes joint and joint+1 that this makes, spring and dashpot
    (first+8, first+9). `ops` is openseespy.opensees."""
    x, y, z = ops.nodeCoord(plate)
    ops.uniaxialMaterial("ElasticPPGap", tag, 1000.0 * k_i, -1e6 * k_i, -lateral_capacity)
    ops.uniaxialMaterial("Elastic", tag + 1, k_i, c_i)
    for side, way in enumerate((-1, 1)):
        ops.node(joint + side, x, y, z)
        ops.fix(joint + side, 0, 1, 1, 1, 1, 1)
        ops.element("zeroLength", first + side, joint + side, slider, "-mat", tag, "-dir", 1, "-orient", way, 0, 0, 0, way, 0)
        ops.element("zeroLength", first + 8 + side, plate, joint + side, "-mat", tag + 1, "-dir", 1)
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

inline constexpr const char *tcl_bearing = R"(
# The whole bearing between the plate's node and the slider's (same place, ndm 3, ndf 6, z up). Uses tags tag ... tag+19 of
# materials and friction models, tag and tag+1 of geomTransf, tag ... tag+11 of elements and the nodes anchor ... anchor+8.
# The slider's node carries m1 and dead_load; it must be free to rise.{}
proc rimpact_bearing {{tag plate slider anchor{}}} {{
  rider_nodes $anchor $plate
  dish $tag $tag $slider $anchor
  {}
}}
)";
inline constexpr const char *python_bearing = R"(

def rimpact_bearing(ops, tag, plate, slider, anchor{}):
    """The whole bearing between the plate's node and the slider's (same place, ndm 3, ndf 6, z up). Uses tags tag ...
    tag+19 of materials and friction models, tag and tag+1 of geomTransf, tag ... tag+11 of elements and the nodes anchor
    ... anchor+8. The slider's node carries m1 and dead_load; it must be free to rise.{}"""
    rider_nodes(ops, anchor, plate)
    dish(ops, tag, tag, slider, anchor)
    {}
)";

/// What rimpact_bearing says of its last word, the word, and the rim it makes.
struct BearingWords {
  const char *says, *word, *rim;
};
inline constexpr BearingWords tcl_bearing_either{
    "\n# `rim`: round, of any direction, new at every touch; or along_x, which keeps the dents of either side.",
    " {rim round}",
    R"(if {$rim eq "along_x"} {
    rim_springs [expr {$tag + 10}] [expr {$tag + 2}] [expr {$anchor + 1}] [expr {$anchor + 2}]
  } elseif {$rim eq "round"} {
    rim_round [expr {$tag + 10}] [expr {$tag + 2}] $anchor [expr {$anchor + 2}]
  } else {error "rimpact_bearing: rim $rim is neither round nor along_x"})"};
inline constexpr BearingWords python_bearing_either{" `rim`: \"round\", of any direction, new at\n    every touch; or "
                                                    "\"along_x\", which keeps the dents of either side.",
                                                    ", rim=\"round\"",
                                                    R"(if rim == "along_x":
        rim_springs(ops, tag + 10, tag + 2, anchor + 1, anchor + 2)
    elif rim == "round":
        rim_round(ops, tag + 10, tag + 2, anchor, anchor + 2)
    else:
        raise ValueError(f"rimpact_bearing: rim {rim} is neither round nor along_x"))"};
inline constexpr BearingWords tcl_bearing_one{
    "", "", "rim_springs [expr {$tag + 10}] [expr {$tag + 2}] [expr {$anchor + 1}] [expr {$anchor + 2}]"};
inline constexpr BearingWords python_bearing_one{"", "", "rim_springs(ops, tag + 10, tag + 2, anchor + 1, anchor + 2)"};
inline constexpr BearingWords tcl_bearing_series{
    "", "",
    "rim_springs [expr {$tag + 10}] [expr {$tag + 2}] [expr {$anchor + 1}] "
    "[expr {$anchor + 2}] [expr {$anchor + 7}]"};
inline constexpr BearingWords python_bearing_series{
    "", "", "rim_springs(ops, tag + 10, tag + 2, anchor + 1, anchor + 2, anchor + 7)"};

} // namespace rimpact::calibration
