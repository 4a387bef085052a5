/// What a drawn file holds, for a user who has to say which surface is which: bodies, and each of their surfaces with
/// its kind, radius and centre as OpenCASCADE has them. Lengths in the file's unit.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace rimpact::meshes {

// clang-format off
/// Of the file, read in a process apart (mesh_process.h), without meshing it. A list of bodies, each with `number`,
/// `name` (empty: the file gives none), `box` ([[x, y, z] least, [x, y, z] most]) and `surfaces`. These have `number`,
/// `box`, and
///   kind    Plane, Cylinder, Cone, Sphere, Torus, ... as gmsh says; "Discrete surface" of a mesh
///   radius  of a cylinder, a sphere, and of a torus its tube; null: another kind
///   centre  of a sphere, a torus, or the point of a cylinder's axis in the middle of the surface's height; else null
///   axis    a unit vector along a cylinder's or a torus's axis, or a plane's normal; else null
///   around  of a torus: radius of the circle that its tube follows; else null
///   of      numbers of the bodies that have it: two for a common face
/// Throws as read_mesh_apart().
// clang-format on
nlohmann::json list_surfaces(const std::string &file);
/// Lines of text.
std::string describe_surfaces(const nlohmann::json &bodies);

/// Of the model that is open in gmsh.
nlohmann::json surfaces_of_model();

} // namespace rimpact::meshes
