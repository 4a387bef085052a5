/// Peaks and impacts of a run of one mass: at the instants it is shown, and between them by interpolation.
#pragma once
#include "reduced_models/motion/segment.h"
#include <vector>

namespace rimpact::reduced {

class RunPeaks {
public:
  /// `dynamics` must outlive it.
  explicit RunPeaks(const Dynamics &dynamics) : dynamics_(dynamics) {}

  void watch(const Mode &mode, const State &y, const Evaluation &e);
  /// Inside a segment: `middle` is its state half way; e0, mid and e1 act at its start, middle and end.
  void refine(const Mode &mode, const Segment &segment, const State &middle, const Evaluation &e0,
              const Evaluation &mid, const Evaluation &e1);
  /// The rim's impulse over a segment (Simpson), by what acts at its start, middle and end.
  void press(double duration, const Evaluation &e0, const Evaluation &mid, const Evaluation &e1);
  void open_impact(double t, const State &y);
  void close_impact(double t, const State &y);
  /// The run ends: an impact that is not let go has no rebound.
  void end(double t, const State &y, double rim_force);

  double smallest_gap() const { return smallest_gap_; }
  void summarise(Summary &summary) const;

private:
  const Dynamics &dynamics_;
  bool in_impact_ = false;
  std::vector<Impact> impacts_;
  double peak_displacement_ = 0, peak_height_ = -1e300, peak_lateral_ = 0, smallest_normal_ = 1e300;
  double smallest_gap_ = 1e300;
};

} // namespace rimpact::reduced
