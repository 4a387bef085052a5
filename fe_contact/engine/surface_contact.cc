#include "fe_contact/engine/surface_contact.h"

#include "fe_contact/engine/threads.h"
#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <stdexcept>

namespace rimpact::fe {

using Eigen::Vector3d;

SurfaceContactState SurfaceContact::open(const Eigen::VectorXd &u) const {
  const std::size_t n = search_.points().size();
  SurfaceContactState state = SurfaceContactState::of(n);
  for (std::size_t k = 0; k < n; ++k) update_active(k, u, state);
  for (std::size_t k = 0; k < n; ++k) state.start.push_back(search_.relative_position(k, u, state.opposite[k]));
  return state;
}

SurfaceContactState SurfaceContact::carried(const SurfaceContactState &other, const Eigen::VectorXd &u) const {
  if (other.covered.size() != search_.points().size()) throw std::invalid_argument("a contact's state of other points");
  SurfaceContactState state = open(u);
  state.stiffening = other.stiffening;
  for (std::size_t k = 0; k < search_.points().size(); ++k) {
    if (!state.covered[k] || !other.covered[k]) continue; // edges differ by what the meshes' faces do
    state.multiplier[k] = other.multiplier[k], state.tangential[k] = other.tangential[k];
    state.entry[k] = other.entry[k];
  }
  return state;
}

SurfaceContact::FaceResult SurfaceContact::assemble_face(std::size_t f, const CoulombContact &law,
                                                         const Eigen::VectorXd &u, SurfaceContactState &state,
                                                         double dt, bool with_stiffness) const {
  FaceResult result;
  SurfaceContactReport &report = result.report;
  const std::size_t per_face = search_.points_a_face();
  for (std::size_t k = f * per_face; k < (f + 1) * per_face; ++k) {
    const FacePoint &point = search_.points()[k];
    state.pressure[k] = 0;
    state.friction[k].setZero();
    state.pulled_back[k].setZero();
    state.status[k] = ContactStatus::open;
    state.gap[k] = std::numeric_limits<double>::infinity();
    if (!state.covered[k]) continue;
    const auto coupling = search_.couple(k, u, state.opposite[k], ContactSearch::reach_past_edges);
    if (!coupling) {
      report.lost += search_.is_candidate(k, u, state.opposite[k]);
      continue;
    }
    state.opposite[k] = coupling->carrier_face;
    CarriedDistance distance = CarriedDistance::of(search_.master(), *coupling);
    state.gap[k] = distance.gap;
    report.smallest_gap = std::min(report.smallest_gap, distance.gap);
    distance.gap += state.entry[k];
    if (state.multiplier[k] - law.normal_penalty * distance.gap <= 0) continue;
    TractionTangents D;
    const auto acts = traction_at(law, distance, *coupling,
                                  {state.multiplier[k], state.tangential[k], coupling->y - state.start[k], dt}, D);
    state.pressure[k] = acts.pressure;
    state.friction[k] = acts.friction;
    state.pulled_back[k] = coupling->inverse.transpose().inverse() * acts.friction;
    state.status[k] = acts.status;
    report.force += point.area * acts.traction;
    report.friction += point.area * acts.friction;
    report.penetration = std::max(report.penetration, std::abs(state.gap[k]));
    report.largest_pressure = std::max(report.largest_pressure, acts.pressure);
    ++(acts.status == ContactStatus::stick ? report.stick : report.slip);
    if (coupling->carrier_face >= 0 && !search_.in_pattern(f, coupling->carrier_face)) {
      report.pattern_holds = false;
      continue;
    }
    if (result.pairs.empty() || result.pairs.back().carrier_face != coupling->carrier_face)
      result.pairs.push_back({coupling->carrier_face});
    result.pairs.back().add(*coupling, point.area, acts.traction, D, distance.nu, with_stiffness);
  }
  return result;
}

SurfaceContactReport SurfaceContact::assemble(const Eigen::VectorXd &u, SurfaceContactState &state, double dt,
                                              const Equations &equations, Eigen::VectorXd &forces,
                                              Tangent *tangent) const {
  CoulombContact law = law_;
  law.normal_penalty *= state.stiffening;
  law.tangential_penalty *= state.stiffening;
  const std::vector<std::size_t> offsets = shares_of_ranks(state);
  const std::size_t first = offsets[ranks().own], n = offsets[ranks().own + 1] - first;
  std::vector<FaceResult> results(n);
  const int workers = assembly_threads();
  on_each_thread(workers, [&](int w) { // contact is in patches: every worker takes of all of them
    for (std::size_t f = w; f < n; f += workers)
      results[f] = assemble_face(first + f, law, u, state, dt, tangent != nullptr);
  });
  SurfaceContactReport report;
  for (auto &result : results) { // face by face, so that sums do not depend on the threads
    report.add(result.report);
    for (auto &pair : result.pairs) pair.add_to(equations, forces, tangent);
  }
  if (ranks().size > 1) {
    all_gather(offsets, state);
    report.all_reduce();
  }
  return report;
}

/// Contact is in patches: by numbers of faces one rank would have them all.
std::vector<std::size_t> SurfaceContact::shares_of_ranks(const SurfaceContactState &state) const {
  if (ranks().size == 1) return {0, search_.faces().size()};
  constexpr std::size_t searched = 2, bearing = 6; // work of a point, roughly, where a face without any costs 1
  const std::size_t per_face = search_.points_a_face();
  std::vector<std::size_t> work{0};
  for (std::size_t f = 0; f < search_.faces().size(); ++f) {
    std::size_t sum = 1;
    for (std::size_t k = f * per_face; k < (f + 1) * per_face; ++k)
      if (state.covered[k]) sum += state.status[k] == ContactStatus::open ? searched : bearing;
    work.push_back(work.back() + sum);
  }
  std::vector<std::size_t> offsets;
  for (const std::size_t due : ranks().offsets(work.back()))
    offsets.push_back(std::lower_bound(work.begin(), work.end(), due) - work.begin());
  return offsets;
}

void SurfaceContact::all_gather(std::vector<std::size_t> offsets, SurfaceContactState &state) const {
  for (auto &start : offsets) start *= search_.points_a_face(); // of points, whole faces each
  ranks().all_gather(state.gap, offsets);
  ranks().all_gather(state.pressure, offsets);
  ranks().all_gather(state.friction, offsets);
  ranks().all_gather(state.pulled_back, offsets);
  ranks().all_gather(state.status, offsets);
  ranks().all_gather(state.opposite, offsets);
}

void SurfaceContact::update_active(std::size_t k, const Eigen::VectorXd &u, SurfaceContactState &state) const {
  const auto coupling = search_.couple(k, u, state.opposite[k], 0.0);
  const bool was_covered = state.covered[k];
  state.covered[k] = coupling && coupling->inside;
  state.opposite[k] = coupling ? coupling->carrier_face : -1;
  double &entry = state.entry[k];
  if (coupling && coupling->inside) {
    entry = was_covered ? std::clamp(-state.gap[k], 0.0, entry)
                        : std::max(0.0, -CarriedDistance::of(search_.master(), *coupling).gap);
    return;
  }
  entry = state.multiplier[k] = 0;
  state.tangential[k].setZero();
}

std::vector<SurfaceContact::Place> SurfaceContact::places(const Eigen::VectorXd &u,
                                                          const SurfaceContactState &state) const {
  std::vector<Place> result;
  for (std::size_t k = 0; k < search_.points().size(); ++k) {
    const int opposite = state.opposite[k];
    const auto coupling = search_.couple(k, u, opposite, ContactSearch::reach_past_edges);
    result.push_back({coupling ? coupling->y : search_.position_by_motion(k, u, opposite),
                      coupling && coupling->inside && coupling->carrier_face == opposite});
  }
  return result;
}

void SurfaceContact::add_work(const SurfaceContactState &before, const SurfaceContactState &after,
                              const std::vector<Place> &places, SurfaceContactReport &report) const {
  for (std::size_t k = 0; k < search_.points().size(); ++k) {
    const double area = search_.points()[k].area, p0 = before.pressure[k], p1 = after.pressure[k];
    if (p0 == 0 && p1 == 0) continue;
    const Vector3d &y = places[k].y;
    // What came over an edge or left over it had a force at one end of the step, and that force did work.
    const bool over_an_edge = !std::isfinite(before.gap[k]) || !std::isfinite(after.gap[k]);
    const double g0 = std::isfinite(before.gap[k]) ? before.gap[k] : search_.master().distance(before.start[k]).gap,
                 g1 = std::isfinite(after.gap[k]) ? after.gap[k] : search_.master().distance(y).gap;
    // A penalty's spring stores energy; what is left of the trapezoidal rule at touch and release is an error of
    // the step, and must show as one. With multipliers there is only the work.
    const bool spring = before.multiplier[k] == 0 && after.multiplier[k] == 0 && before.entry[k] == 0;
    if (spring && !over_an_edge)
      report.normal_work += area * (p1 * p1 - p0 * p0) / (2 * law_.normal_penalty * after.stiffening);
    else
      report.normal_work -= 0.5 * area * (p0 + p1) * (g1 - g0);
    report.friction_work -= 0.5 * area * (before.pulled_back[k] + after.pulled_back[k]).dot(y - before.start[k]);
  }
}

void SurfaceContact::commit(const Eigen::VectorXd &u, const std::vector<Place> &places, SurfaceContactState &state,
                            const Renewal &renewal) const {
  const Augmentation next = augmentation(state);
  state.tangential = next.tangential;
  if (renewal.normal == NextMultipliers::none) std::fill(state.multiplier.begin(), state.multiplier.end(), 0.0);
  if (renewal.normal == NextMultipliers::augmented)
    for (std::size_t k = 0; k < search_.points().size(); ++k)
      if (next.multiplier[k] > 0) // what bears nothing keeps nothing
        state.multiplier[k] += renewal.share * (next.multiplier[k] - state.multiplier[k]);
      else
        state.multiplier[k] = 0;
  constexpr double entries_given_up = 2; // e-folds over a point's width
  for (std::size_t k = 0; k < search_.points().size(); ++k) {
    const Vector3d &y = places[k].y;
    if (state.entry[k] > 0) {
      const Vector3d way = y - state.start[k], n = search_.master().distance(y).normal;
      state.entry[k] *= std::exp(-entries_given_up * (way - n.dot(way) * n).norm() /
                                 std::sqrt(search_.points()[k].area / search_.pass_share()));
    }
    state.start[k] = y;
    if (places[k].settled && state.covered[k])
      state.entry[k] = std::clamp(-state.gap[k], 0.0, state.entry[k]);
    else
      update_active(k, u, state);
  }
}

std::vector<SurfaceContact::Sample> SurfaceContact::samples(const Eigen::VectorXd &u,
                                                            const SurfaceContactState &state) const {
  std::vector<Sample> result;
  for (std::size_t k = 0; k < search_.points().size(); ++k)
    result.push_back({search_.relative_position(k, u, state.opposite[k]), state.friction[k], search_.points()[k].area,
                      state.pressure[k], state.gap[k]});
  return result;
}

} // namespace rimpact::fe
