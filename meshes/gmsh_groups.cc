#include "meshes/gmsh_groups.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include "meshes/gmsh_session.h"
#include "meshes/hex_mesh.h"
#include "meshes/joined_bodies.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace rimpact::meshes {
namespace {

/// Entities of a dimension by every name a user may call them: physical group, part of a STEP file, "volume 3".
NamedEntities named_entities(int dimension) {
  NamedEntities result;
  gmsh::vectorpair groups, entities;
  gmsh::model::getPhysicalGroups(groups, dimension);
  for (const auto &[dim, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    std::vector<int> members;
    gmsh::model::getEntitiesForPhysicalGroup(dim, tag, members);
    auto &list = result[name.empty() ? fmt::format("group {}", tag) : name];
    list.insert(list.end(), members.begin(), members.end());
  }
  gmsh::model::getEntities(entities, dimension);
  for (const auto &[dim, tag] : entities) {
    std::string name;
    gmsh::model::getEntityName(dim, tag, name);
    name = name.substr(name.find_last_of('/') + 1); // "Shapes/assembly/part"
    if (!name.empty() && result.count(name) == 0) result[name] = {tag};
    result[fmt::format("{} {}", dimension == 3 ? "volume" : "surface", tag)] = {tag};
  }
  return result;
}

std::vector<std::string> names_of(const NamedEntities &entities) {
  std::vector<std::string> names;
  names.reserve(entities.size());
  for (const auto &[name, list] : entities) names.push_back(name);
  return names;
}

} // namespace

GmshGroups::GmshGroups(const scene::OwnMesh &own) : own_(own), entities_(scene::mesh_group_names.size()) {
  const std::set<std::string> taken(own.groups.begin(), own.groups.end()); // one of our names, given to another group
  for (const int dimension : {3, 2}) {
    const NamedEntities known = named_entities(dimension);
    const std::size_t first = dimension == 3 ? 0 : n_volumes, last = dimension == 3 ? n_volumes : entities_.size();
    for (std::size_t k = first; k < last; ++k) {
      const bool mapped = !own.groups[k].empty();
      if (!mapped && taken.count(scene::mesh_group_names[k])) continue;
      const std::string names = mapped ? own.groups[k] : scene::mesh_group_names[k];
      for (const auto &part : split(names, ',')) {
        const std::string name(trim(part));
        const auto found = known.find(name);
        if (found != known.end())
          entities_[k].insert(entities_[k].end(), found->second.begin(), found->second.end());
        else if (mapped)
          throw DataError(fmt::format("{}: model.own_mesh.groups.{}: {}", own.file, scene::mesh_group_names[k],
                                      unknown_word(name, names_of(known))));
      }
    }
    if (dimension == 3) refuse_unclaimed(known);
  }
}

std::string GmshGroups::name(std::size_t group) const {
  const std::string ours = scene::mesh_group_names[group];
  return own_.groups[group].empty() ? ours : fmt::format("{} ({})", ours, own_.groups[group]);
}

void GmshGroups::join(std::size_t one, std::size_t other) {
  const auto became = join_bodies(entities_[one], entities_[other]);
  for (std::size_t k = n_volumes; k < entities_.size(); ++k) {
    std::vector<int> now;
    for (const int surface : entities_[k]) {
      const auto parts = became.find(surface);
      if (parts == became.end())
        now.push_back(surface);
      else
        now.insert(now.end(), parts->second.begin(), parts->second.end());
    }
    entities_[k] = std::move(now);
  }
}

/// A body nobody named would be left out without a word.
void GmshGroups::refuse_unclaimed(const NamedEntities &volumes) const {
  std::set<int> claimed;
  for (std::size_t k = 0; k < n_volumes; ++k) claimed.insert(entities_[k].begin(), entities_[k].end());
  for (const auto &[name, list] : volumes)
    for (const int entity : list)
      if (claimed.count(entity) == 0)
        throw DataError(fmt::format("{}: volume '{}' is none of plate, rim, pad, foot, upper_slider: say which in "
                                    "[model.own_mesh.groups], or leave it "
                                    "out of the file",
                                    own_.file, name));
}

} // namespace rimpact::meshes
