/// Words of the verbs that rimpact-fe carries out; rimpact shows them.
#pragma once
#include "app/console/verb.h"

namespace rimpact::app {

inline constexpr VerbText text_of_curve{
    .name = "curve",
    .help = "push a bearing's rim once for every speed: curve.h5, flown by impact_law = \"curve\"",
    .examples = "rimpact curve my-case/bearing.toml -o my-curve --mass-kg 203900",
    .next = "rimpact reduced SCENE --set reduced.impact_law=curve --set reduced.impact_curve={}/curve.h5"};
inline constexpr VerbText text_of_mesh{
    .name = "mesh",
    .help = "mesh the rim sector and the slider of a bearing",
    .examples = "rimpact mesh shfps-225 -o bearing.msh --png\nrimpact mesh my-case/bearing.toml --mesh 2 -o fine.msh\n"
                "rimpact mesh --surfaces drawn.step",
    .next = "gmsh FILE shows it; rimpact run SCENE makes its own"};
inline constexpr VerbText text_of_run{.name = "run",
                                      .help = "run a scene by finite elements",
                                      .examples = "rimpact run impact-window --mesh 0 -o my-run\n"
                                                  "rimpact run my-case/scene.toml --rung rigid-dish --dry-run\n"
                                                  "rimpact run my-case/scene.toml -o my-run --resume",
                                      .next = "rimpact report {}"};

} // namespace rimpact::app
