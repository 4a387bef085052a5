#include "meshes/surface_list.h"
#include "meshes/gmsh_session.h"
#include "meshes/surface_shape.h"
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::meshes {
namespace {

using nlohmann::json;

/// Boxes of OpenCASCADE are wider by 1e-7.
double clean(double value) {
  constexpr double step = 1e-6;
  return std::round(value / step) * step + 0.0; // no -0
}

json number_or_null(const std::optional<double> &value) {
  return value ? json(clean(*value)) : json();
}
json vector_or_null(const std::optional<Eigen::Vector3d> &v) {
  return v ? json{clean(v->x()), clean(v->y()), clean(v->z())} : json();
}

json entity(int dimension, int number) {
  std::string name;
  gmsh::model::getEntityName(dimension, number, name);
  double low[3], high[3];
  gmsh::model::getBoundingBox(dimension, number, low[0], low[1], low[2], high[0], high[1], high[2]);
  json box{json::array(), json::array()};
  for (int i = 0; i < 3; ++i) box[0].push_back(clean(low[i])), box[1].push_back(clean(high[i]));
  return {{"number", number}, {"name", name.substr(name.find_last_of('/') + 1)}, {"box", box}};
}

json surface_json(int number) {
  const SurfaceShape shape = surface_shape(number);
  json said = entity(2, number);
  said.update({{"kind", shape.kind},
               {"radius", number_or_null(shape.radius)},
               {"centre", vector_or_null(shape.centre)},
               {"axis", vector_or_null(shape.axis)},
               {"around", number_or_null(shape.around)}});
  std::vector<int> bodies, edges;
  gmsh::model::getAdjacencies(2, number, bodies, edges);
  said["of"] = bodies;
  return said;
}

std::string triple(const json &x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0].get<double>(), x[1].get<double>(), x[2].get<double>());
}

std::string box_in_words(const json &box) {
  std::string text;
  for (const int i : {0, 1, 2})
    text += fmt::format("{}{} {:.6g} to {:.6g}", i > 0 ? ", " : "", "xyz"[i], box[0][i].get<double>(),
                        box[1][i].get<double>());
  return text;
}

std::string named(const char *what, const json &entity) {
  const std::string name = entity["name"];
  return fmt::format("{} {}{}", what, entity["number"].get<int>(), name.empty() ? "" : " '" + name + "'");
}

std::string shape_in_words(const json &surface) {
  std::string text = surface["kind"];
  if (surface["radius"].is_number()) text += fmt::format(", radius {:.6g}", surface["radius"].get<double>());
  if (surface["around"].is_number()) text += fmt::format(" on a circle of {:.6g}", surface["around"].get<double>());
  if (surface["centre"].is_array()) text += ", centre " + triple(surface["centre"]);
  if (surface["axis"].is_array())
    text += (surface["kind"] == "Plane" ? ", normal " : ", axis along ") + triple(surface["axis"]);
  return text;
}

} // namespace

json surfaces_of_model() {
  json bodies = json::array();
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  for (const auto &[dimension, number] : volumes) {
    json body = entity(dimension, number);
    body["surfaces"] = json::array();
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{dimension, number}}, boundary, false, false, false);
    for (const auto &[of_boundary, surface] : boundary) body["surfaces"].push_back(surface_json(surface));
    bodies.push_back(body);
  }
  return bodies;
}

std::string describe_surfaces(const json &bodies) {
  std::string text;
  for (const auto &body : bodies) {
    text += fmt::format("{}: {}\n", named("volume", body), box_in_words(body["box"]));
    for (const auto &surface : body["surfaces"])
      text += fmt::format("  {}: {}; {}{}\n", named("surface", surface), shape_in_words(surface),
                          box_in_words(surface["box"]),
                          surface["of"].size() > 1 ? fmt::format("; common to volumes {}",
                                                                 fmt::join(surface["of"].get<std::vector<int>>(), ", "))
                                                   : "");
  }
  return text;
}

} // namespace rimpact::meshes
