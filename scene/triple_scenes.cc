#include "scene/triple_scenes.h"

namespace rimpact::scene {
namespace {

const char *triple_stages =
    R"(# The five stages of a triple friction pendulum, slowly, on the bearing that Fenz and Constantinou (2008) tested.
# Inner slider; lower slide plate too; both plates; the bottom rim holds the lower plate; the top rim holds the upper one.
[load]
vertical_kN = 112.0       # assumption
mass_kg = 11416.9

[excitation]
kind = "cyclic"           # slowly
amplitude_m = 0.14        # stages begin at 3.2, 27.6, 101.8 and 126.2 mm; the inner rims are met at 144 mm
cycles = 1.5

[reduced]
model = "tfp"
mu_fast = 0.05            # assumption; of the bottom plate. The inner slider's and the top plate's are in the catalogue
k_i_kN_per_m = 1e5        # assumption

[isolator]
name = "tfp-fenz-2008"    # rimpact list bearings
)";

const char *triple_pulse =
    R"(# A triple friction pendulum under 13345 kN, driven by a pulse past all its rims: configuration A of Kim and Constantinou (2023).
[load]
vertical_kN = 13345.0
mass_kg = 1360346.6

[excitation]
kind = "ricker"
amplitude_g = 0.38
period_s = 2.4

[reduced]
model = "tfp"
mu_fast = 0.04            # of the bottom plate
k_i_kN_per_m = 1e6        # assumption, one rim's
impact_law = "hunt-crossley"  # K d (1 + chi d'): no jump at touch, which kicks the light slide plates
impact_exponent = 1.0
reference_speed_m_per_s = 0.4 # assumption, of e

[isolator]
name = "tfp-kim-2023"     # rimpact list bearings
)";

} // namespace

std::vector<BuiltinScene> triple_scenes() {
  return {{"tfp-stages", triple_stages}, {"tfp-pulse", triple_pulse}};
}

} // namespace rimpact::scene
