/// The answer of the main job while its runs come in: from three windows on, sharper with each that is added.
#pragma once
#include "app/console/console.h"
#include "app/jobs/main_jobs.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

class EarlyAnswer {
public:
  /// `folder`: of the main job. `laws`: those that are ranked. `until`: the error asked for [-], the largest of peak
  /// force and rebound of windows left out of the fit one at a time; none: every run is made.
  EarlyAnswer(std::string folder, std::vector<std::string> laws, std::optional<double> until, Console &console);

  /// After runs have ended. The law is fitted where three windows touch the rim, the fastest and the slowest among
  /// them, and where all have ended; with `until` each time one is added. It is written to DIR/calibration and said.
  /// Once its error is small enough, the windows and pulses that are not begun are left out, and the twins of windows
  /// left out.
  void operator()(std::vector<Job> &jobs);

  /// Why runs were left out, a sentence; empty: none were.
  const std::string &left_out() const { return left_out_; }
  /// For main.json: asked_percent, reached_percent, left_out (names); null without `until`.
  nlohmann::json to_json() const;

private:
  bool due(std::size_t done, std::size_t all) const;
  std::optional<double> error_of(const std::vector<std::string> &folders);
  void leave_out(std::vector<Job> &jobs);

  std::string folder_, left_out_;
  std::vector<std::string> laws_, names_;
  std::optional<double> until_, reached_;
  Console &console_;
  std::size_t fitted_ = 0; ///< windows of the last fit
};

} // namespace rimpact::app
