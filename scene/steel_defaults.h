/// Numbers of a steel that follow from its other keys: of a grade, a hardness, a curve.
#pragma once
#include "io/files/toml_file.h"
#include "scene/bearing.h"

namespace rimpact::scene {

/// A steel of a bearing, with its place in the file.
struct SteelTable {
  Material &steel;
  std::string table; ///< behind the bearing's prefix: "material.steel."
  double thickness;  ///< of the part, which a grade's numbers go by [m]
};

/// Fills what the file leaves out, and marks what is an assumption by that. `prefix`: of the bearing's keys. Throws
/// InputError for keys that contradict each other.
void resolve_steel(const TomlFile &file, const std::string &prefix, const SteelTable &of, AssumedKeys &assumed);

/// A material's keys that hang together: no yield, no slope past it; yield alone is perfectly plastic. `table`: prefix
/// of its keys.
void resolve_slope(const TomlFile &file, const std::string &table, Material &material);

/// The steels of the parts that have a table, [material.rim], [material.dish] or [material.slider]: what it leaves out
/// is the bearing's steel's or, with a grade, the grade's. After the bearing's steel is settled. `folder`: of the file.
void read_part_steels(const TomlFile &file, const std::string &prefix, const std::string &folder, Bearing &bearing);

/// Of a part, which a grade's numbers go by [m].
double thickness_of(const Bearing &bearing, SteelPart part);

/// Puts the rows of a steel's file in its place. `table`: prefix of its keys.
void read_flow_curve(const TomlFile &file, const std::string &table, Hardening &hardening, const std::string &folder);

} // namespace rimpact::scene
