/// Which of gmsh's entities make up each named group of a bearing. Private to the meshes.
#pragma once
#include "scene/own_mesh_settings.h"
#include <map>
#include <string>
#include <vector>

namespace rimpact::meshes {

using NamedEntities = std::map<std::string, std::vector<int>>;

/// Of the model open in gmsh; groups are numbered as in scene::mesh_group_names. Throws DataError for a name of
/// [model.own_mesh.groups] that the file has not, and for cells no group claims.
class GmshGroups {
public:
  explicit GmshGroups(const scene::OwnMesh &own);
  const std::vector<int> &entities(std::size_t group) const { return entities_[group]; } ///< none: the file has it not
  std::string name(std::size_t group) const; ///< with the file's name for it
  /// Two bodies that are one piece, by their groups, get a common face where they lie on one another (joined_bodies.h).
  void join(std::size_t one, std::size_t other);

private:
  void refuse_unclaimed(const NamedEntities &volumes) const;
  const scene::OwnMesh &own_;
  std::vector<std::vector<int>> entities_;
};

} // namespace rimpact::meshes
