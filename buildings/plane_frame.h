/// Regular inelastic frames in the plane by lines, storeys and sections, as a TOML file says them or as built in.
#pragma once
#include "buildings/frame.h"
#include <map>

namespace rimpact {
class KeyVisitor;
}

namespace rimpact::buildings {

/// A class of members. What is not given follows: yield moment by PlaneFrame::design, axial yield 0.85 f_c times area.
struct MemberClass {
  std::optional<double> yield_moment; ///< [N m], > 0
  std::optional<double> axial_yield;  ///< [N], > 0
  InelasticSection law;               ///< the rest of it
};

/// Equivalent lateral forces that yield moments follow from: V_st at the base, over the floors as w h^k (ASCE 7-16,
/// 17.5.6), elastic moments with those of the weight; every member of a class yields at its largest times overstrength.
struct FrameDesign {
  double shear = 0.17;          ///< V_st over the weight of all levels [-], > 0 (thesis 2.5.1)
  double height_exponent = 1.4; ///< k = 14 beta_M T_fb [-], >= 0: 14 x 0.20 x 0.5 s
  double overstrength = 1.25;   ///< [-], > 0; assumption
};

struct PlaneFrame {
  std::string name = "frame";
  std::vector<double> x;       ///< column lines [m], growing
  std::vector<double> storeys; ///< heights from the base up [m], > 0
  double load = 40e3;          ///< seismic weight along the beams of every level, the base too [N/m], > 0
  double gravity = 9.81;       ///< makes masses of it [m/s^2]
  double E = 23.4e9;           ///< concrete [Pa]
  double strength = 24.8e6;    ///< f_c [Pa]: (E / 4700 MPa)^2, ACI 318; assumption
  double column_x = 0.5, column_y = 0.5, beam_width = 0.5, beam_depth = 0.65; ///< [m]
  double damping_ratio = 0.02;
  FrameDesign design;
  MemberClass column, beam;
  std::map<int, std::string> bearings; ///< as RegularBuilding has them
  std::vector<std::string> assumed;    ///< "key = value" of what no one has given
};

/// Walks over the keys of the file.
void visit(KeyVisitor &v, PlaneFrame &frame);
/// Euler-Bernoulli members in the plane y = 0, yield moments by design where none are given. Throws InputError.
Frame make_frame(const PlaneFrame &frame);

/// Whether the text describes such a frame: it has load_kN_per_m or one of the tables design, column, beam.
bool is_plane_frame(const std::string &text, const std::string &origin);
/// Throws InputError with file, line, value and bound.
PlaneFrame parse_plane_frame(const std::string &text, const std::string &origin);

} // namespace rimpact::buildings
