#include "meshes/joined_bodies.h"
#include "meshes/gmsh_session.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

namespace rimpact::meshes {
namespace {

namespace occ = gmsh::model::occ;

/// What tells a surface of a body from its others, whatever its number.
struct Face {
  int number = 0, body = 0;
  std::string kind = {};
  std::array<double, 6> box = {}; ///< least x, y, z, most x, y, z
  double area = 0;
};

gmsh::vectorpair tagged(int dimension, const std::vector<int> &numbers) {
  gmsh::vectorpair all;
  for (const int number : numbers) all.emplace_back(dimension, number);
  return all;
}

std::vector<Face> faces_of(const std::vector<int> &bodies) {
  std::vector<Face> faces;
  for (const int body : bodies) {
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{3, body}}, boundary, false, false, false);
    for (const auto &[dimension, number] : boundary) {
      Face face{.number = number, .body = body};
      auto &b = face.box;
      gmsh::model::getType(2, number, face.kind);
      gmsh::model::getBoundingBox(2, number, b[0], b[1], b[2], b[3], b[4], b[5]);
      occ::getMass(2, number, face.area);
      faces.push_back(face);
    }
  }
  return faces;
}

bool are_of_opencascade(const std::vector<int> &bodies) {
  gmsh::vectorpair known;
  occ::getEntities(known, 3);
  return std::all_of(bodies.begin(), bodies.end(), [&](int body) {
    return std::find(known.begin(), known.end(), std::pair<int, int>(3, body)) != known.end();
  });
}

double size_of(const Face &face) {
  return std::hypot(face.box[3] - face.box[0], face.box[4] - face.box[1], face.box[5] - face.box[2]);
}

/// Whether `part` may be cut out of `whole`.
bool may_be_of(const Face &part, const Face &whole) {
  const double near = 1e-6 * size_of(whole);
  for (std::size_t i = 0; i < 3; ++i)
    if (part.box[i] < whole.box[i] - near || part.box[i + 3] > whole.box[i + 3] + near) return false;
  return part.body == whole.body && part.kind == whole.kind && part.area <= whole.area * (1 + 1e-6);
}

bool is_same(const Face &a, const Face &b) {
  return may_be_of(a, b) && may_be_of(b, a);
}

[[noreturn]] void refuse_unclear(int surface) {
  throw "surface " + std::to_string(surface) +
      " is cut where two bodies of one piece touch, and what it has become cannot be told: draw them as one body";
}

std::map<int, std::vector<int>> children(const std::vector<Face> &before, std::vector<Face> after) {
  std::map<int, std::vector<int>> found;
  std::vector<Face> cut;
  for (const auto &face : before) {
    const auto same = std::find_if(after.begin(), after.end(), [&](const auto &other) { return is_same(face, other); });
    if (same == after.end()) {
      cut.push_back(face);
      continue;
    }
    found[face.number].push_back(same->number);
    after.erase(same);
  }
  for (const auto &face : cut) {
    double area = 0;
    for (const auto &part : after)
      if (may_be_of(part, face)) found[face.number].push_back(part.number), area += part.area;
    if (std::abs(area / face.area - 1) > 1e-6) refuse_unclear(face.number);
  }
  return found;
}

/// A face of two bodies lies inside their one piece: no surface has it any longer.
void drop_common(std::map<int, std::vector<int>> &found, const std::vector<Face> &after) {
  std::map<int, int> bodies;
  for (const auto &face : after) ++bodies[face.number];
  for (auto &[surface, parts] : found) std::erase_if(parts, [&](int part) { return bodies[part] > 1; });
}

} // namespace

std::map<int, std::vector<int>> join_bodies(const std::vector<int> &one, const std::vector<int> &other) {
  std::vector<int> both = one;
  both.insert(both.end(), other.begin(), other.end());
  if (one.empty() || other.empty() || std::set<int>(both.begin(), both.end()).size() < both.size() ||
      !are_of_opencascade(both))
    return {};
  const auto before = faces_of(both);
  std::set<int> numbers;
  for (const auto &face : before) numbers.insert(face.number);
  if (numbers.size() < before.size()) return {}; // they have a common face
  gmsh::vectorpair made;
  std::vector<gmsh::vectorpair> became;
  occ::fragment(tagged(3, one), tagged(3, other), made, became);
  occ::synchronize();
  for (std::size_t k = 0; k < both.size(); ++k)
    if (became[k] != gmsh::vectorpair{{3, both[k]}})
      throw "volume " + std::to_string(both[k]) + " goes into another one: bodies of one piece must only touch";
  const auto after = faces_of(both);
  auto found = children(before, after);
  drop_common(found, after);
  return found;
}

} // namespace rimpact::meshes
