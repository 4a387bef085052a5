#include "buildings/builtin_buildings.h"

namespace rimpact::buildings {
namespace {

const char *thesis_24 =
    R"(# Thesis 2.4: three storeys, two bays by one, reinforced concrete, six isolators.
name = "thesis-2.4"
x_m = [0.0, 8.0, 16.0]
y_m = [0.0, 8.0]
storeys_m = [3.5, 3.5, 3.5]
load_kN_per_m2 = 10.0     # on four levels: 5,120 kN
E_GPa = 23.4
nu = 0.2
column_x_mm = 500.0
column_y_mm = 500.0
beam_width_mm = 500.0
beam_depth_mm = 650.0
damping_ratio = 0.02
)";

const char *thesis_35 =
    R"(# Thesis 3.5: the same plan and weight with stiffer columns, on six double concave bearings.
name = "thesis-3.5"
x_m = [0.0, 8.0, 16.0]
y_m = [0.0, 8.0]
storeys_m = [3.5, 3.5, 3.5]
load_kN_per_m2 = 10.0
E_GPa = 23.4
nu = 0.2
column_x_mm = 700.0
column_y_mm = 700.0
beam_width_mm = 400.0
beam_depth_mm = 700.0
damping_ratio = 0.02
)";

} // namespace

const std::vector<BuiltinBuilding> &builtin_buildings() {
  static const std::vector<BuiltinBuilding> list{{"thesis-2.4", thesis_24}, {"thesis-3.5", thesis_35}};
  return list;
}

} // namespace rimpact::buildings
