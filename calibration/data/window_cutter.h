/// Cuts one impact out of a run: where it begins, from which state, until when, and whether it only grazes.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// Travel beyond L_c without rim force that means a dent [m]; above the contact's own gap tolerance. A measured one's
/// own error comes on top.
inline constexpr double dent_tolerance = 1e-5;

/// Horizontal part of a signal at sample i.
inline Eigen::Vector2d planar(const Response &response, const std::string &signal, std::size_t i) {
  return {response.series(signal + "_x")[i], response.series(signal + "_y")[i]};
}

/// Why an impact that the response ends in is not cut.
inline constexpr const char *still_pressed =
    "the response ends while the rim still bears, so its rebound is not known: let it go on to 10 ms after release";
/// The dents that impacts before `index` have left on a rim that yields.
void press_earlier(reduced::BearingState &start, const StoredRun &run, std::size_t index);
/// Fills overshoot and grazing from the window's start.
void judge_grazing(ImpactWindow &window, const StoredRun &run, const reduced::PhysicalModel &model,
                   const WindowOptions &options);

class WindowCutter {
public:
  /// Both must outlive the cutter; run.summary holds the impacts.
  WindowCutter(const StoredRun &run, const WindowOptions &options);
  /// Empty, with a reason, when the impact cannot be fitted.
  std::optional<ImpactWindow> cut(std::size_t index, std::string &reason) const;

private:
  double travel(std::size_t i) const { return planar(r_, "displacement", i).norm(); }
  double pressing(std::size_t i) const { return planar(r_, "impact", i).norm(); }
  std::size_t touch_sample(const Impact &impact) const;
  /// Travel at which the reduced rim is to begin.
  double touch_travel(std::size_t touch, bool &dented) const;
  reduced::BearingState state(std::size_t i) const;
  void collect(ImpactWindow &window, std::size_t start, double end) const;

  const StoredRun &run_;
  const Response &r_;
  const std::vector<double> &times_;
  const WindowOptions &options_;
  reduced::PhysicalModel model_;
  double L_c_;
};

} // namespace rimpact::calibration
