/// Regular buildings by grids, storeys and sections, as a TOML file says them or as built in.
#pragma once
#include "buildings/frame.h"
#include <map>

namespace rimpact {
class KeyVisitor;
class TomlFile;
} // namespace rimpact

namespace rimpact::buildings {

struct RegularBuilding {
  std::string name = "building";
  std::vector<double> x, y;    ///< column lines [m], growing
  std::vector<double> storeys; ///< heights from the base up [m], > 0; none: a base alone
  double load = 10e3;          ///< seismic weight on every level, the base too [N/m^2], > 0
  double gravity = 9.81;       ///< makes masses of it [m/s^2]
  double E = 23.4e9, nu = 0.2; ///< concrete [Pa], [-]
  double column_x = 0.5, column_y = 0.5, beam_width = 0.5, beam_depth = 0.65; ///< [m]
  double beam_inertia_factor = 1; ///< bending of a beam in the vertical plane over its rectangle's: a slab's flange [-]
  bool shear = true;              ///< Timoshenko members; false: Euler-Bernoulli
  Eigen::Vector2d eccentricity = Eigen::Vector2d::Zero(); ///< of every level's mass and weight, shares of the plan's
                                                          ///< sides [-], -0.45..0.45
  double damping_ratio = 0.02;
  std::map<int, std::string> bearings; ///< names or files of bearings of their own, by the node above, from 1
};
/// Walks over the keys of the file.
void visit(KeyVisitor &v, RegularBuilding &building);
/// Slabs are rigid in their plane; their bending is left out. Beams run along every line on every level, the base too.
Frame make_frame(const RegularBuilding &building);

/// A TOML file or the name of a built-in building (builtin_buildings.h). Throws InputError with file, line, value and
/// bound.
RegularBuilding load_building(const std::string &where);
RegularBuilding parse_building(const std::string &text, const std::string &origin);

/// Throws InputError naming `key` unless there are two lines at least and they grow.
void check_lines(const char *key, const std::vector<double> &lines);
/// Length of floor that a line carries: half the bay on each side [m].
double tributary(const std::vector<double> &lines, std::size_t i);
/// [bearings]: node = "name or file".
std::map<int, std::string> own_bearings(const TomlFile &file);

} // namespace rimpact::buildings
