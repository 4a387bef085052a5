#include "reduced_models/record/run_peaks.h"
#include "reduced_models/record/inner_maximum.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {

namespace {

double lateral(const Evaluation &e) {
  return (e.pendular + e.friction + e.impact).head<2>().norm();
}

} // namespace

void RunPeaks::watch(const Mode &mode, const State &y, const Evaluation &e) {
  peak_displacement_ = std::max(peak_displacement_, std::hypot(y[iX], y[iY]));
  peak_height_ = std::max(peak_height_, y[iZ]);
  peak_lateral_ = std::max(peak_lateral_, lateral(e));
  smallest_normal_ = std::min(smallest_normal_, mode.support == Support::airborne ? 0.0 : std::max(0.0, e.normal));
  smallest_gap_ = std::min(smallest_gap_, e.gap);
  if (in_impact_) {
    auto &i = impacts_.back();
    i.peak_force = std::max(i.peak_force, e.rim_force);
    i.peak_penetration = std::max(i.peak_penetration, -e.gap);
  }
}

void RunPeaks::refine(const Mode &mode, const Segment &s, const State &middle, const Evaluation &e0,
                      const Evaluation &mid, const Evaluation &e1) {
  const auto at = [&](double theta) {
    const double t = s.t0 + theta * (s.t1 - s.t0);
    State y = s.at(t);
    dynamics_.place(mode, y);
    return dynamics_.evaluate(mode, t, y);
  };
  peak_lateral_ = std::max(peak_lateral_, inner_maximum([&](double x) { return lateral(at(x)); }, lateral(e0),
                                                        lateral(mid), lateral(e1), peak_lateral_));
  if (mode.support != Support::airborne)
    smallest_normal_ =
        std::min(smallest_normal_, std::max(0.0, -inner_maximum([&](double x) { return -at(x).normal; }, -e0.normal,
                                                                -mid.normal, -e1.normal, -smallest_normal_)));
  if (in_impact_) {
    auto &force = impacts_.back().peak_force;
    force = std::max(force, inner_maximum([&](double x) { return at(x).rim_force; }, e0.rim_force, mid.rim_force,
                                          e1.rim_force, force));
  }
  if (dynamics_.rises(mode))
    peak_height_ = std::max(peak_height_, inner_maximum([&](double x) { return s.at(s.t0 + x * (s.t1 - s.t0))[iZ]; },
                                                        s.y0[iZ], middle[iZ], s.y1[iZ], peak_height_));
}

void RunPeaks::press(double duration, const Evaluation &e0, const Evaluation &mid, const Evaluation &e1) {
  if (in_impact_) *impacts_.back().impulse += duration / 6 * (e0.rim_force + 4 * mid.rim_force + e1.rim_force);
}

void RunPeaks::open_impact(double t, const State &y) {
  in_impact_ = true;
  const double r = std::hypot(y[iX], y[iY]);
  Impact impact{};
  impact.touch_time = t, impact.impulse = 0;
  impact.direction_deg = std::atan2(y[iY], y[iX]) * 180 / std::numbers::pi;
  impact.approach_speed = (y[iX] * y[iVX] + y[iY] * y[iVY]) / r;
  impacts_.push_back(left_open(impact));
}

void RunPeaks::close_impact(double t, const State &y) {
  in_impact_ = false;
  impacts_.back().release_time = t;
  impacts_.back().rebound_speed = -(y[iX] * y[iVX] + y[iY] * y[iVY]) / std::hypot(y[iX], y[iY]);
}

void RunPeaks::end(double t, const State &y, double rim_force) {
  if (in_impact_ && !still_bears(rim_force, impacts_.back().peak_force)) close_impact(t, y);
}

void RunPeaks::summarise(Summary &summary) const {
  summary.peak_displacement = peak_displacement_;
  summary.peak_lateral_force = peak_lateral_;
  summary.peak_vertical_displacement = peak_height_;
  if (!dynamics_.height.is_plane()) summary.min_normal_force = smallest_normal_; // a window without weight has none
  summary.impacts = impacts_;
  double peak = 0;
  for (const auto &impact : impacts_) peak = std::max(peak, impact.peak_force);
  summary.peak_impact_force = peak;
}

} // namespace rimpact::reduced
