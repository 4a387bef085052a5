/// A mesh drawn elsewhere that takes the place of the built-in one: [model.own_mesh].
#pragma once
#include "io/files/choice.h"
#include <array>
#include <string>

namespace rimpact::scene {

/// Names of the groups a mesh of the bearing carries (docs/interface.md): five volumes, then the surfaces.
inline constexpr std::array mesh_group_names{"plate",    "rim",        "pad",         "foot",       "upper_slider",
                                             "dish",     "rim_wall",   "pad_face",    "pad_top",    "foot_seat",
                                             "foot_cap", "socket",     "slider_side", "top",        "fixed",
                                             "symmetry", "sector_end", "pad_side",    "foot_recess"};

enum class LengthUnit { m, cm, mm, in };
constexpr auto choices(LengthUnit) {
  using enum LengthUnit;
  return choices_of<LengthUnit>({{m, "m"}, {cm, "cm"}, {mm, "mm"}, {in, "in"}});
}
constexpr double metres(LengthUnit unit) {
  constexpr std::array lengths{1.0, 1e-2, 1e-3, 0.0254};
  return lengths[static_cast<std::size_t>(unit)];
}

struct OwnMesh {
  std::string file;                ///< .msh of hexahedra; .geo or .step, which gmsh meshes; empty: the built-in mesh
  LengthUnit unit = LengthUnit::m; ///< of its lengths
  double size = 0.04;              ///< of cells meshed from .geo or .step, at most [m], > 0
  double contact_size = 0.01;      ///< of those where slider and rim meet [m], > 0
  /// What mesh_group_names are called in the file, one or several with commas between: physical or part names,
  /// "volume 3", "surface 14"; empty: the name itself.
  std::array<std::string, mesh_group_names.size()> groups;

  bool any() const { return !file.empty(); }
  double metres() const { return scene::metres(unit); } ///< of one unit
};

} // namespace rimpact::scene
