#include "scene/double_concave_scenes.h"

namespace rimpact::scene {
namespace {

const char *stages =
    R"(# The stages of an LIR-DCFP bearing (thesis Fig. 3-5): low-friction sliding, both rims, sliding of the interface, return.
[load]
vertical_kN = 2000.0
mass_kg = 203874.0

[excitation]
kind = "cyclic"           # slowly
amplitude_m = 0.33        # C_t + 0.01 R_eff: the interface slides by that
cycles = 2.0

[reduced]
model = "lir-dcfp"
mu_fast = 0.05

[isolator]                # the default: R_eff = 3.00 m, C_t = 0.30 m, gap 40 mm
top_wall_mm = 50.0
)";

const char *specimen =
    R"(# The tested LIR-DCFP specimen (thesis appendix B): first hit at 175 mm, then at 165 mm on the other side.
[load]
vertical_kN = 150.0
mass_kg = 15290.5

[excitation]
kind = "cyclic"           # the test moved at constant speed; slowly driven, only the path counts
amplitude_m = 0.185
cycles = 2.0

[reduced]
model = "lir-dcfp"
mu_fast = 0.066
k_i_kN_per_m = 1e6

[isolator]
radius_m = 0.75
capacity_m = 0.175
slider_diameter_mm = 140.0  # assumption
top_height_mm = 45.0        # assumption, but for the sum of 85 mm
bottom_height_mm = 40.0
top_wall_mm = 30.0          # assumption: a gap that is not used up
bottom_wall_mm = 10.0
slider_mass_kg = 10.0       # assumption
mu_interface = 0.126
)";

const char *slider_study =
    R"(# The slider study of thesis 3.4 under Newhall 360 (Northridge 1994): slenderness 0.33, gap ratio and heights as its first case.
# The record is PEER's (NGA-West2, RSN 1044) and not part of this program: put your own copy beside this file.
[load]
vertical_kN = 1964.9      # 200,300 kg
mass_kg = 200300.0

[excitation]
kind = "record"
x = "RSN1044_NORTHR_NWH360.AT2"
duration_s = 20.0

[reduced]
model = "lir-dcfp"
mu_slow = 0.04
mu_fast = 0.06
rate_s_per_m = 20.0
k_i_kN_per_m = 4e4        # k_imp of the thesis, one rim's
impact_law = "hunt-crossley"  # K d (1 + chi d'): no jump at touch, which kicks the light slider
impact_exponent = 1.0
reference_speed_m_per_s = 0.4 # assumption, of e

[isolator]
radius_m = 1.5515         # (3-94) with H_s = 103 mm
capacity_m = 0.30
slider_diameter_mm = 310.0
top_height_mm = 51.5
bottom_height_mm = 51.5
top_wall_mm = 50.0        # assumption
bottom_wall_mm = 10.0     # assumption
slider_mass_kg = 100.0
mu_interface = 0.15
points = 5
)";

const char *comparison =
    R"(# The isolators compared in thesis 4.3, the superstructure rigid: LIR-DCFP of 25 cm and a gap of 5 cm. The DCFP ones: --model dcfp,
# and --set isolator.capacity_m=0.30 for the larger. The record is PEER's (RSN 180, H-E05140): put your own copy beside this file.
[load]
vertical_kN = 4905.0
mass_kg = 500000.0

[excitation]
kind = "record"
scale = 1.6               # unscaled, a rigid superstructure does not reach the rims
x = "RSN180_IMPVALL.H_H-E05140.AT2"
duration_s = 20.0

)";

} // namespace

std::string isolators_of_43() {
  return R"([reduced]
model = "lir-dcfp"
mu_slow = 0.035
mu_fast = 0.07
rate_s_per_m = 30.0
k_i_kN_per_m = 4e4
impact_law = "hunt-crossley"
impact_exponent = 1.0
reference_speed_m_per_s = 0.4 # assumption

[isolator]
radius_m = 1.175          # R_eff = 2.25 m
capacity_m = 0.25
top_height_mm = 50.0      # assumption
bottom_height_mm = 50.0   # assumption
top_wall_mm = 60.0
bottom_wall_mm = 10.0
mu_interface = 0.14
)";
}

std::vector<BuiltinScene> double_concave_scenes() {
  return {{"lir-dcfp-stages", stages},
          {"lir-dcfp-specimen", specimen},
          {"lir-dcfp-slider-study", slider_study,
           needs_record("lir-dcfp-slider-study", "RSN1044", "RSN1044_NORTHR_NWH360.AT2")},
          {"lir-dcfp-compared", comparison + isolators_of_43(),
           needs_record("lir-dcfp-compared", "RSN180", "RSN180_IMPVALL.H_H-E05140.AT2")}};
}

} // namespace rimpact::scene
