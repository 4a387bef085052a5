/// Bodies of a drawing that lie on one another become one piece: OpenCASCADE cuts their common faces out and lets both
/// have them (its fragments). Private to the meshes.
#pragma once
#include <map>
#include <vector>

namespace rimpact::meshes {

/// Of each surface of the bodies, by its number before, what it has become on the outside of both; empty where nothing
/// is done: they have a common face already, are one and the same, or are no geometry of OpenCASCADE. Volumes keep
/// their numbers. Throws std::string, as gmsh does, where the bodies go into one another.
std::map<int, std::vector<int>> join_bodies(const std::vector<int> &one, const std::vector<int> &other);

} // namespace rimpact::meshes
