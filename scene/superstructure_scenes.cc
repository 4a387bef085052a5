#include "scene/superstructure_scenes.h"

#include "scene/double_concave_scenes.h"

namespace rimpact::scene {
namespace {

const char *four_dof =
    R"(# The four-degrees-of-freedom model of thesis 2.6.1: base and inelastic frame, each moving sideways and up, on the SH-FPS
# bearing. One of its 64 systems: T_s = 0.6 s, gamma = 0.7, r_H = 0.10, R_I = 1 (table 2-3), mu_max = 0.05.
[bearing]
name = "shfps-225"

[bearing.slider]
diameter_mm = 220.0       # L_c = 0.41 m, table 2-3

[load]                    # any: the frame is told by ratios
vertical_kN = 853.0
mass_kg = 86952.0

[excitation]
kind = "ricker"           # the thesis's records are scaled to S_a(3 s): see the user guide
amplitude_g = 0.78
period_s = 1.0

[reduced]
mu_fast = 0.05
mu_slow = 0.025
rate_s_per_m = 20.0       # assumption: not printed in chapter 2

[superstructure]
kind = "bouc-wen"
mass_ratio = 0.7
period_s = 0.6
yield_mm = 18.6
post_yield_ratio = 0.10
damping_ratio = 0.02      # assumption: chapter 4's
vertical_period_s = 0.1   # assumption: k_v is not printed
)";

const char *motion_for_lir =
    R"(# Thesis 4.3: an inelastic frame on an LIR-DCFP bearing of 25 cm with a gap of 5 cm. The DCFP ones: --model dcfp, and
# --set isolator.capacity_m=0.30 for the larger. The thesis names H-E05140 "of Array #4"; unscaled, neither it nor Array #4's
# E04140 reaches the rim. The same station's H-E05230 does. PEER's RSN 180: put your own copy beside this file.
[load]
vertical_kN = 4905.0
mass_kg = 500000.0

[excitation]
kind = "record"
x = "RSN180_IMPVALL.H_H-E05230.AT2"
duration_s = 20.0

)";

const char *frame_on_lir =
    R"(
[superstructure]
kind = "bouc-wen"
mass_ratio = 0.7
period_s = 0.6
damping_ratio = 0.02
yield_mm = 20.0
post_yield_ratio = 0.05   # negative softens: the frame collapses where its strength is gone
vertical_period_s = 0.05  # assumption: the thesis's superstructure moves sideways only
)";

const char *building =
    R"(# A linear five-storey shear building on the SH-FPS bearing under a synthetic near-fault motion, built in.
[bearing]
name = "shfps-225"

[excitation]
kind = "record"
x = "builtin:near-fault-x"
y = "builtin:near-fault-y"
duration_s = 12.0

[superstructure]
kind = "shear-building"
storeys = 5
mass_ratio = 0.8
period_s = 0.5            # first, with the base held
damping_ratio = 0.02
vertical_period_s = 0.1
)";

} // namespace

std::vector<BuiltinScene> superstructure_scenes() {
  return {{"frame-four-dof", four_dof},
          {"frame-on-lir-dcfp", motion_for_lir + isolators_of_43() + frame_on_lir,
           needs_record("frame-on-lir-dcfp", "RSN180", "RSN180_IMPVALL.H_H-E05230.AT2")},
          {"shear-building", building}};
}

} // namespace rimpact::scene
