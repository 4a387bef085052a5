#include "meshes/slider_angles.h"

#include "meshes/half_disc.h"
#include "meshes/touched_places.h"
#include "meshes/units.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

PlaceSizes sizes_of(double radius, double h) {
  return {2 * 10 * mm * h / radius, 20 * mm / radius, M_PI / 2, 0.9 * h};
}

/// Lines from the first place to `end` [rad], finest at the places; in equal pairs, because gmsh halves every edge of
/// the core's plan.
std::vector<double> lines_to(double end, const std::vector<double> &places, const PlaceSizes &sizes, double h) {
  std::vector<Anchor> anchors = anchors_at(places, sizes);
  if (const double left = end - anchors.back().at; left > sizes.past_zone()) {
    anchors.push_back({anchors.back().at + sizes.zone, sizes.fine});
    anchors.push_back({end, std::max(sizes.fine, 2 * 1.5 * h * left / M_PI)});
  } else if (left > 1e-9) {
    anchors.push_back({end, sizes.fine});
  }
  return halved(graded_lines(anchors));
}

/// Places and their images in the plane x = 0, of the quarter x >= 0.
std::vector<double> folded_twice(const std::vector<double> &places, double apart) {
  std::vector<double> quarter;
  for (const double place : folded(places, apart)) {
    const double angle = std::min(place, M_PI - place);
    quarter.push_back(M_PI / 2 - angle < apart ? M_PI / 2 : angle);
  }
  return folded(quarter, apart);
}

} // namespace

std::vector<double> half_angles(const std::vector<double> &places, double radius, double h) {
  const PlaceSizes sizes = sizes_of(radius, h);
  return lines_to(M_PI, folded(places, sizes.apart()), sizes, h);
}

std::vector<double> quarter_angles(const std::vector<double> &places, double radius, double h) {
  const PlaceSizes sizes = sizes_of(radius, h);
  return lines_to(M_PI / 2, folded_twice(places, sizes.apart()), sizes, h);
}

std::vector<double> with_image(const std::vector<double> &quarter) {
  std::vector<double> half = quarter;
  for (auto k = quarter.rbegin() + 1; k != quarter.rend(); ++k) half.push_back(M_PI - *k);
  return half;
}

} // namespace rimpact::meshes
