/// The dish of an export to OpenSees, in Tcl and in Python: the linkage on which the slider rides (rider.h).
///
/// Nodes, by their place behind `anchor`: +1 the seat, tied to the plate, and +0 anchor_depth below it; +2 the foot,
/// which slides in the plane; +3 the hinge, tied to the slider; +4 the lever's end (not for a sphere); +5 the
/// ellipsoid's centre, above the end; +6 the hanger, at its place, which moves up and down with the foot. The truss
/// from end to centre keeps its length, so the end rises with travel, and the hinge by dish_ratio of it. All that the
/// slider weighs comes down at the foot, whose sliding element has the friction.
#pragma once

namespace rimpact::calibration {

inline constexpr const char *tcl_rider_nodes = R"(
# Makes the nodes anchor ... anchor+6: the seat (+1, tied to the plate; the anchor below it), the foot (+2), the hinge of
# the slider (+3), the lever's end (+4, not for a sphere), the ellipsoid's centre (+5) and its hanger (+6).
proc rider_nodes {anchor plate} {
  global anchor_depth dish_ratio dish_half_width lever_arm
  lassign [nodeCoord $plate] x y z
  set low [expr {$x - $dish_ratio * $lever_arm}]
  set high [expr {$x + (1.0 - $dish_ratio) * $lever_arm}]
  set top [expr {$z + $dish_half_width}]
  set seat [expr {$anchor + 1}]; set foot [expr {$anchor + 2}]; set hinge [expr {$anchor + 3}]
  set end [expr {$anchor + 4}]; set centre [expr {$anchor + 5}]; set hanger [expr {$anchor + 6}]
  node $anchor $low $y [expr {$z - $anchor_depth}]
  equalDOF $plate $anchor 1 2 3 4 5 6
  node $seat $low $y $z
  equalDOF $plate $seat 1 2 3 4 5 6
  node $foot $low $y $z
  fix $foot 0 0 0 1 0 1
  node $hinge $x $y $z
  fix $hinge 0 0 0 1 0 1
  if {$dish_ratio < 1.0} {
    node $end $high $y $z
    fix $end 0 0 0 1 0 1
  }
  node $centre $high $y $top
  fix $centre 0 0 0 1 1 1
  equalDOF $plate $centre 1 2
  node $hanger $high $y $top
  fix $hanger 1 1 0 1 1 1
  equalDOF $foot $hanger 3
}
)";
inline constexpr const char *python_rider_nodes = R"(

def rider_nodes(ops, anchor, plate):
    """Makes the nodes anchor ... anchor+6: the seat (+1, tied to the plate; the anchor below it), the foot (+2), the
    hinge of the slider (+3), the lever's end (+4, not for a sphere), the ellipsoid's centre (+5) and its hanger (+6)."""
    x, y, z = ops.nodeCoord(plate)
    low, high, top = x - dish_ratio * lever_arm, x + (1.0 - dish_ratio) * lever_arm, z + dish_half_width
    seat, foot, hinge, end, centre, hanger = range(anchor + 1, anchor + 7)
    ops.node(anchor, low, y, z - anchor_depth)
    ops.equalDOF(plate, anchor, 1, 2, 3, 4, 5, 6)
    ops.node(seat, low, y, z)
    ops.equalDOF(plate, seat, 1, 2, 3, 4, 5, 6)
    ops.node(foot, low, y, z)
    ops.fix(foot, 0, 0, 0, 1, 0, 1)
    ops.node(hinge, x, y, z)
    ops.fix(hinge, 0, 0, 0, 1, 0, 1)
    if dish_ratio < 1.0:
        ops.node(end, high, y, z)
        ops.fix(end, 0, 0, 0, 1, 0, 1)
    ops.node(centre, high, y, top)
    ops.fix(centre, 0, 0, 0, 1, 1, 1)
    ops.equalDOF(plate, centre, 1, 2)
    ops.node(hanger, high, y, top)
    ops.fix(hanger, 1, 1, 0, 1, 1, 1)
    ops.equalDOF(foot, hanger, 3)
)";

inline constexpr const char *tcl_dish = R"(
# A beam `element` of the lever from node `i` to node `j`, `length` long: so stiff that it does not bend.
proc lever_beam {element i j length transf} {
  global rigid_stiffness
  set bends [expr {$rigid_stiffness * $length ** 3}]
  geomTransf Linear $transf 0.0 1.0 0.0
  element elasticBeamColumn $element $i $j [expr {$rigid_stiffness * $length}] 1.0 1.0 $bends $bends $bends $transf
}
# The dish: elements first (slides), first+1 (what the ellipsoid leaves), first+4 ... first+9 (the linkage), between the
# nodes of rider_nodes and the slider's. The table is turned from travel to elongation of a truss of anchor_depth.
proc dish {tag first slider anchor} {
  global mu_slow mu_fast friction_rate friction_stiffness vertical_stiffness free_rotation rigid_stiffness
  global dish_half_width dish_ratio dish_travel dish_force_left rise_moment rise_stiffness lever_arm anchor_depth
  set hinged [expr {$tag + 1}]; set rigid [expr {$tag + 3}]
  set seat [expr {$anchor + 1}]; set foot [expr {$anchor + 2}]; set hinge [expr {$anchor + 3}]
  set end [expr {$dish_ratio < 1.0 ? $anchor + 4 : $hinge}]; set centre [expr {$anchor + 5}]
  uniaxialMaterial Elastic $tag $vertical_stiffness
  uniaxialMaterial Elastic $hinged $free_rotation
  frictionModel VelDependent $tag $mu_slow $mu_fast $friction_rate
  element flatSliderBearing $first $seat $foot $tag $friction_stiffness -P $tag -T $hinged -My $hinged -Mz $hinged -orient 0 0 1 1 0 0
  set strain {-1.0 0.0}
  set force {0.0 0.0}
  foreach r $dish_travel F $dish_force_left {
    set length [expr {sqrt($r ** 2 + $anchor_depth ** 2)}]
    lappend strain [expr {$length / $anchor_depth - 1.0}]
    lappend force [expr {$F * $length / $r}]
  }
  uniaxialMaterial ElasticMultiLinear [expr {$tag + 2}] -strain {*}$strain -stress {*}$force
  element corotTruss [expr {$first + 1}] $anchor $foot 1.0 [expr {$tag + 2}]
  uniaxialMaterial Elastic $rigid $rigid_stiffness
  element zeroLength [expr {$first + 4}] $hinge $slider -mat $rigid $rigid $rigid -dir 1 2 3
  element zeroLength [expr {$first + 5}] [expr {$anchor + 6}] $centre -mat $rigid -dir 3
  if {$rise_moment > 0.0} {
    uniaxialMaterial ElasticPP [expr {$tag + 5}] $rise_stiffness [expr {$rise_moment / $rise_stiffness}]
    element zeroLength [expr {$first + 6}] $seat $foot -mat [expr {$tag + 5}] -dir 5
  }
  lever_beam [expr {$first + 7}] $foot $hinge [expr {$dish_ratio * $lever_arm}] $tag
  if {$dish_ratio < 1.0} {lever_beam [expr {$first + 8}] $hinge $end [expr {(1.0 - $dish_ratio) * $lever_arm}] [expr {$tag + 1}]}
  uniaxialMaterial Elastic [expr {$tag + 4}] [expr {$rigid_stiffness * $dish_half_width}]
  element corotTruss [expr {$first + 9}] $end $centre 1.0 [expr {$tag + 4}]
}
)";
inline constexpr const char *python_dish = R"(

def lever_beam(ops, element, i, j, length, transf):
    """A beam `element` of the lever from node `i` to node `j`, `length` long: so stiff that it does not bend."""
    bends = rigid_stiffness * length ** 3
    ops.geomTransf("Linear", transf, 0.0, 1.0, 0.0)
    ops.element("elasticBeamColumn", element, i, j, rigid_stiffness * length, 1.0, 1.0, bends, bends, bends, transf)


def dish(ops, tag, first, slider, anchor):
    """The dish: elements first (slides), first+1 (what the ellipsoid leaves), first+4 ... first+9 (the linkage), between
    the nodes of rider_nodes and the slider's. The table is turned from travel to elongation of a truss of anchor_depth."""
    seat, foot, hinge, end, centre, hanger = range(anchor + 1, anchor + 7)
    end = end if dish_ratio < 1.0 else hinge
    ops.uniaxialMaterial("Elastic", tag, vertical_stiffness)
    ops.uniaxialMaterial("Elastic", tag + 1, free_rotation)
    ops.frictionModel("VelDependent", tag, mu_slow, mu_fast, friction_rate)
    ops.element("flatSliderBearing", first, seat, foot, tag, friction_stiffness, "-P", tag, "-T", tag + 1,
                "-My", tag + 1, "-Mz", tag + 1, "-orient", 0.0, 0.0, 1.0, 1.0, 0.0, 0.0)
    strain, force = [-1.0, 0.0], [0.0, 0.0]
    for r, F in zip(dish_travel, dish_force_left):
        length = hypot(r, anchor_depth)
        strain.append(length / anchor_depth - 1.0)
        force.append(F * length / r)
    ops.uniaxialMaterial("ElasticMultiLinear", tag + 2, "-strain", *strain, "-stress", *force)
    ops.element("corotTruss", first + 1, anchor, foot, 1.0, tag + 2)
    ops.uniaxialMaterial("Elastic", tag + 3, rigid_stiffness)
    ops.element("zeroLength", first + 4, hinge, slider, "-mat", tag + 3, tag + 3, tag + 3, "-dir", 1, 2, 3)
    ops.element("zeroLength", first + 5, hanger, centre, "-mat", tag + 3, "-dir", 3)
    if rise_moment > 0.0:
        ops.uniaxialMaterial("ElasticPP", tag + 5, rise_stiffness, rise_moment / rise_stiffness)
        ops.element("zeroLength", first + 6, seat, foot, "-mat", tag + 5, "-dir", 5)
    lever_beam(ops, first + 7, foot, hinge, dish_ratio * lever_arm, tag)
    if dish_ratio < 1.0:
        lever_beam(ops, first + 8, hinge, end, (1.0 - dish_ratio) * lever_arm, tag + 1)
    ops.uniaxialMaterial("Elastic", tag + 4, rigid_stiffness * dish_half_width)
    ops.element("corotTruss", first + 9, end, centre, 1.0, tag + 4)
)";

} // namespace rimpact::calibration
