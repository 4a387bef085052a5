#include "scene/scene_catalogue.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "scene/bearing_catalogue.h"
#include "scene/double_concave_scenes.h"
#include "scene/scene.h"
#include "scene/superstructure_scenes.h"
#include "scene/toml_writer.h"
#include "scene/triple_scenes.h"
#include <algorithm>
#include <vector>

namespace rimpact::scene {
namespace {

const char *static_unidirectional =
    R"(# One slow cycle along x (thesis 2.3.1): the lateral force over displacement against the closed form.
[bearing]
name = "shfps-225"

[excitation]
kind = "cyclic"
amplitude_m = 0.39        # just short of the rim at L_c = 0.400 m
cycles = 1.0

[model]
rung = "rigid-dish"
)";

const char *static_figure_eight =
    R"(# Slow figure-eight (thesis 2.3.1): ux = u0 sin(w t), uy = u0 sin(2 w t). Largest radius 1.25 u0: no impact.
[bearing]
name = "shfps-225"

[excitation]
kind = "figure-eight"
amplitude_m = 0.31        # u0
cycles = 1.0

[model]
rung = "rigid-dish"
)";

const char *ricker_short =
    R"(# Ricker pulse of 1.0 s (thesis 2.3.2, Fig. 2-7). At the printed amplitude it only grazes the rim: the impact force is
# then nearly singular in everything. scale = 1.05 or 1.10 gives well-conditioned impacts.
[bearing]
name = "shfps-225"

[load]
vertical_kN = 853.0       # dead load
mass_kg = 86952.0         # inertia

[excitation]
kind = "ricker"
scale = 1.0
amplitude_g = 0.78
period_s = 1.0

[model]
rung = "rim"
)";

const char *ricker_long =
    R"(# Ricker pulse of 1.5 s (thesis 2.3.2, Fig. 2-8). At the printed amplitude it only grazes the rim: the impact force is
# then nearly singular in everything. scale = 1.05 or 1.10 gives well-conditioned impacts.
[bearing]
name = "shfps-225"

[load]
vertical_kN = 853.0       # dead load
mass_kg = 86952.0         # inertia

[excitation]
kind = "ricker"
scale = 1.0
amplitude_g = 0.38
period_s = 1.5

[model]
rung = "rim"
)";

const char *impact_window =
    R"(# One impact at a given speed, isolated: no ground motion, no weight, no friction. Only here is rebound over approach
# speed the coefficient of restitution.
[bearing]
name = "shfps-225"

[excitation]
kind = "window"
speed_m_per_s = 0.1
direction_deg = 0.0
with = []                 # "weight", "friction", "ground"

[model]
rung = "rim"
)";

const char *rim_push =
    R"(# The slider pressed slowly into the rim and withdrawn: stiffness, yielding, residual indentation.
[bearing]
name = "shfps-225"

[excitation]
kind = "push"
direction_deg = 0.0
travel_mm = 8.0           # beyond touch
return = true             # unload afterwards

[model]
rung = "rim"
)";

const char *sylmar =
    R"(# Sylmar - Olive View Med FF, Northridge 1994, both horizontal components (thesis 2.3.2, Figs. 2-9 to 2-11), scaled by
# 0.86. The thesis sees the impact mainly along x, so the stronger component, 360, is put there.
# The records are PEER's (NGA-West2, RSN 1086) and not part of this program: put your own copy beside this file.
[bearing]
name = "shfps-225"

[excitation]
kind = "record"
scale = 0.86
x = "RSN1086_NORTHR_SYL360.AT2"
y = "RSN1086_NORTHR_SYL090.AT2"

[model]
rung = "rim"
)";

const char *pulse_bidirectional =
    R"(# A synthetic near-fault motion, built in: a fault-normal velocity pulse along x, a fault-parallel one along y.
[bearing]
name = "shfps-225"

[excitation]
kind = "record"
x = "builtin:near-fault-x"
y = "builtin:near-fault-y"
duration_s = 12.0

[model]
rung = "rim"
)";

// The catalogue: one line a scene.
const std::vector<BuiltinScene> &scenes() {
  static const std::vector<BuiltinScene> scenes = [] {
    std::vector<BuiltinScene> list{
        {"static-unidirectional", static_unidirectional},
        {"static-figure-eight", static_figure_eight},
        {"ricker-0.78g-1.0s", ricker_short},
        {"ricker-0.38g-1.5s", ricker_long},
        {"impact-window", impact_window},
        {"rim-push", rim_push},
        {"sylmar-bidirectional", sylmar,
         "sylmar-bidirectional needs your own copy of PEER's NGA-West2 record RSN1086: "
         "RSN1086_NORTHR_SYL360.AT2 and "
         "RSN1086_NORTHR_SYL090.AT2 in the current folder or in that of RIMPACT_RECORDS, or --set excitation.x=FILE "
         "--set excitation.y=FILE"},
        {"pulse-bidirectional", pulse_bidirectional},
    };
    for (auto &scene : double_concave_scenes()) list.push_back(std::move(scene));
    for (auto &scene : triple_scenes()) list.push_back(std::move(scene));
    for (auto &scene : superstructure_scenes()) list.push_back(std::move(scene));
    return list;
  }();
  return scenes;
}

} // namespace

std::string needs_record(const std::string &scene, const std::string &record, const std::string &file) {
  return scene + " needs your own copy of PEER's NGA-West2 record " + record + ": " + file +
         " in the current folder or in that of RIMPACT_RECORDS, or --set excitation.x=FILE";
}

const BuiltinScene *find_builtin_scene(const std::string &name) {
  for (const auto &scene : scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

std::vector<std::string> builtin_scene_names() {
  std::vector<std::string> names;
  for (const auto &scene : scenes()) names.push_back(scene.name);
  return names;
}

std::string builtin_scene_text(const std::string &name) {
  if (const auto *scene = find_builtin_scene(name)) return scene->text;
  const auto bearings = builtin_bearing_names();
  if (std::find(bearings.begin(), bearings.end(), name) != bearings.end()) return to_toml(builtin_bearing(name));
  throw InputError("scene " + unknown_word(name, builtin_scene_names()));
}

} // namespace rimpact::scene
