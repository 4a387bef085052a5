#include "fe_contact/drive/steel_places.h"

#include <algorithm>
#include <vector>

namespace rimpact::fe {
namespace {

using Eigen::Vector3d;
using meshes::Volume;

/// A quadrature point of the steel.
struct SteelPoint {
  Vector3d place;
  double volume, strain, damage, locus_damage;
  std::size_t index; ///< in the history
};

/// The place of a point; none: the pad.
class Places {
public:
  explicit Places(const scene::Bearing &bearing)
      : root_top_(scene::make_surface(bearing.surface)->at(bearing.surface.planar_radius, 0).z +
                  bearing.rim.thickness / 4) {}
  std::optional<SteelPlace> of(Volume volume, const Vector3d &place) const {
    switch (volume) {
    case Volume::plate:
      return SteelPlace::dish;
    case Volume::rim:
      return place.z() < root_top_ ? SteelPlace::rim_root : SteelPlace::rim_wall;
    case Volume::foot:
    case Volume::upper_slider:
      return SteelPlace::slider_edge;
    case Volume::pad:
      break;
    }
    return {};
  }

private:
  double root_top_; ///< [m]
};

/// Weighted means of a body about a place of it.
struct Means {
  double strain, damage, locus_damage;
};
Means averaged(const std::vector<SteelPoint> &body, const Vector3d &middle) {
  constexpr double reach = averaging_radius * averaging_radius;
  double volume = 0, strain = 0, damage = 0, locus_damage = 0;
  for (const SteelPoint &p : body) {
    const double share = 1 - (p.place - middle).squaredNorm() / reach;
    if (!(share > 0)) continue;
    const double weight = share * share * p.volume;
    volume += weight, strain += weight * p.strain;
    damage += weight * p.damage, locus_damage += weight * p.locus_damage;
  }
  return {strain / volume, damage / volume, locus_damage / volume};
}

SteelAtPlace worst_of(std::vector<SteelPoint> points, const std::vector<SteelPoint> &body,
                      const SolidHistory &history) {
  SteelAtPlace result;
  std::stable_sort(points.begin(), points.end(),
                   [](const SteelPoint &a, const SteelPoint &b) { return a.strain > b.strain; });
  const SteelPoint &largest = points.front();
  if (!(largest.strain > 0)) return result;
  result.largest = largest.strain;
  result.place = largest.place;
  result.triaxiality = history[largest.index].triaxiality / largest.strain;
  result.lode = history[largest.index].lode / largest.strain;
  for (const SteelPoint &p : points) {
    result.damage = std::max(result.damage, p.damage);
    result.locus_damage = std::max(result.locus_damage, p.locus_damage);
    // About lower points no mean is sought.
    const bool higher = p.strain > result.averaged || p.damage > result.averaged_damage;
    const bool higher_by_locus = p.locus_damage > result.averaged_locus_damage;
    if (!higher && !higher_by_locus) continue;
    const Means means = averaged(body, p.place);
    if (higher) {
      result.averaged = std::max(result.averaged, means.strain);
      result.averaged_damage = std::max(result.averaged_damage, means.damage);
    }
    if (higher_by_locus) result.averaged_locus_damage = std::max(result.averaged_locus_damage, means.locus_damage);
  }
  return result;
}

/// Plate and rim are one body; foot and upper slider are apart.
Volume body_of(Volume volume) {
  return volume == Volume::rim ? Volume::plate : volume;
}

} // namespace

SteelReport steel_by_place(const Discretisation &space, const scene::Bearing &bearing, const SolidHistory &history) {
  const Places places(bearing);
  const int n = space.nodes_per_cell, n_points = space.full.n_points;
  std::map<Volume, std::vector<SteelPoint>> bodies;
  std::map<std::pair<SteelPlace, Volume>, std::vector<SteelPoint>> by_place;
  for (std::size_t c = 0; c < space.n_cells; ++c)
    for (int q = 0; q < n_points; ++q) {
      Vector3d x = Vector3d::Zero();
      for (int a = 0; a < n; ++a) x += space.full_values[q * n + a] * space.positions[space.cell_nodes[c * n + a]];
      const auto place = places.of(space.volumes[c], x);
      if (!place) continue;
      const std::size_t index = c * n_points + q;
      const J2State &state = history[index];
      const SteelPoint point{x, space.full.weights[index], state.alpha, state.damage, state.locus_damage, index};
      bodies[body_of(space.volumes[c])].push_back(point);
      by_place[{*place, body_of(space.volumes[c])}].push_back(point);
    }
  SteelReport report;
  for (const auto &[key, points] : by_place)
    keep_worst(report, {{key.first, worst_of(points, bodies.at(key.second), history)}});
  return report;
}

} // namespace rimpact::fe
