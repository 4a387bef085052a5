#include "meshes/touched_places.h"

#include <algorithm>
#include <cmath>

namespace rimpact::meshes {
namespace {

constexpr double same_angle = 1e-9; ///< [rad]

void sort_and_merge(std::vector<double> &angles, double apart) {
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end(), [&](double a, double b) { return b - a < apart; }),
               angles.end());
}

void cut_at_symmetry(RimArc &arc) {
  arc.from_symmetry = arc.angles.front() < -same_angle;
  arc.to_symmetry = arc.angles.back() > M_PI + same_angle;
  const auto outside = [](double angle) { return angle < -same_angle || angle > M_PI + same_angle; };
  arc.angles.erase(std::remove_if(arc.angles.begin(), arc.angles.end(), outside), arc.angles.end());
}

/// Between two neighbouring places, neither of them included.
void add_between(std::vector<Anchor> &anchors, double from, double to, const PlaceSizes &sizes) {
  const double half = 0.5 * (to - from), grows_to = std::min(half, sizes.reach);
  if (grows_to < sizes.past_zone()) return;
  anchors.push_back({from + sizes.zone, sizes.fine});
  if (half > sizes.past_reach())
    anchors.insert(anchors.end(), {{from + sizes.reach, sizes.coarse}, {to - sizes.reach, sizes.coarse}});
  else
    anchors.push_back(
        {from + half, sizes.fine + (sizes.coarse - sizes.fine) * (grows_to - sizes.zone) / (sizes.reach - sizes.zone)});
  anchors.push_back({to - sizes.zone, sizes.fine});
}

/// From place `first` on, `count` of them, neighbours joined.
RimArc arc_about(const std::vector<double> &places, std::size_t first, std::size_t count, const PlaceSizes &sizes) {
  std::vector<double> joined;
  joined.reserve(count);
  for (std::size_t k = first; k < first + count; ++k)
    joined.push_back(places[k % places.size()] + (k < places.size() ? 0 : 2 * M_PI));
  std::vector<Anchor> anchors = anchors_at(joined, sizes);
  RimArc arc;
  arc.closed = count > places.size();
  if (!arc.closed) {
    anchors.insert(anchors.begin(),
                   {{joined.front() - sizes.reach, sizes.coarse}, {joined.front() - sizes.zone, sizes.fine}});
    anchors.insert(anchors.end(),
                   {{joined.back() + sizes.zone, sizes.fine}, {joined.back() + sizes.reach, sizes.coarse}});
  }
  arc.angles = graded_lines(anchors);
  return arc;
}

} // namespace

std::vector<double> from_the_first(const std::vector<double> &directions) {
  std::vector<double> places;
  for (const double direction : directions) {
    double angle = std::remainder(direction - directions.front(), 2 * M_PI);
    if (angle < -same_angle) angle += 2 * M_PI;
    places.push_back(std::abs(angle) < same_angle ? 0.0 : std::abs(angle - M_PI) < same_angle ? M_PI : angle);
  }
  sort_and_merge(places, same_angle);
  return places;
}

std::vector<double> folded(const std::vector<double> &places, double apart) {
  std::vector<double> result;
  result.reserve(places.size());
  for (const double place : places) {
    const double angle = place > M_PI ? 2 * M_PI - place : place;
    result.push_back(angle < apart ? 0.0 : M_PI - angle < apart ? M_PI : angle);
  }
  sort_and_merge(result, std::max(apart, same_angle));
  return result;
}

std::vector<Anchor> anchors_at(const std::vector<double> &places, const PlaceSizes &sizes) {
  std::vector<Anchor> anchors;
  for (const double place : places) {
    if (!anchors.empty()) add_between(anchors, anchors.back().at, place, sizes);
    anchors.push_back({place, sizes.fine});
  }
  return anchors;
}

std::vector<RimArc> rim_arcs(const std::vector<double> &places, const PlaceSizes &sizes, bool half) {
  const std::size_t n = places.size();
  const auto joined = [&](std::size_t k) { // to the next
    const double next = k + 1 < n ? places[k + 1] : places[0] + 2 * M_PI;
    return next - places[k] < 2 * sizes.reach - same_angle;
  };
  std::size_t start = 0; // where nothing comes before
  while (start < n && joined((start + n - 1) % n)) ++start;
  if (start == n) return {arc_about(places, 0, n + 1, sizes)};
  std::vector<RimArc> arcs;
  for (std::size_t k = start, count = 1; k < start + n; k += count, count = 1) {
    while (joined((k + count - 1) % n)) ++count;
    arcs.push_back(arc_about(places, k, count, sizes));
    if (half) cut_at_symmetry(arcs.back());
  }
  return arcs;
}

} // namespace rimpact::meshes
