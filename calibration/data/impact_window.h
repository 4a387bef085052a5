/// What a fit reads from a run folder: the run's impacts, each cut out with the state it starts from.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include "responses/summary.h"
#include <cmath>
#include <optional>

namespace rimpact::calibration {

/// Where a reduced rim begins in a fit.
enum class TouchReference {
  automatic, ///< L_c for an arc without a dent, own_touch where the reference was already beyond L_c without touching
  gap,       ///< always L_c: penetration = -gap as docs/interface.md defines it
  own_touch  ///< the travel at which the reference itself touched
};

/// Stated uncertainties of the reference. Those of force and speed are shares of the run's own largest value,
/// so a light second impact does not outweigh the hard one.
struct Uncertainty {
  double force = 0.01;         ///< share of the run's peak impact force, > 0
  double displacement = 0.001; ///< share of L_c, > 0
  double speed = 0.01;         ///< share of the run's largest approach speed, > 0
  double time = 0;             ///< of the reference's clock within one impact [s]; 0: exact
  double gain = 0; ///< of the force channel, one error common to all impacts [-]: no record's noise shows it; measured
                   ///< records only
};

struct WindowOptions {
  TouchReference touch = TouchReference::automatic;
  double lead = 0;            ///< travel before touch at which a shot starts [m], where the response allows; >= 0
  double tail = 0.05;         ///< compared after release [s], cut at the next touch; > 0
  bool measured = false;      ///< a record with noise, cut by measured_cutter.h; false: zero force means no contact
  double force_threshold = 0; ///< share of the peak below which no contact is looked for (measured); 0..0.5
  double stated_speed_error =
      0.01; ///< share of a window's stated speed, used where a record begins at touch (measured); > 0
  double stated_clock_error = 0;   ///< of force against displacement [s] (measured); >= 0
  int minimum_samples = 8;         ///< with rim force, below which an impact is not fitted; >= 4
  double grazing_overshoot = 0.01; ///< share of L_c; see ImpactWindow::grazing; >= 0
  void validate() const;           ///< throws InputError naming option, value and bound
};

/// A weighted sum of neighbouring samples of a window, taken of the model and of the record alike.
struct Functional {
  std::size_t first = 0;
  std::vector<double> weights; ///< empty: the record does not tell
  double of(const std::vector<double> &samples) const {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * samples[first + i];
    return sum;
  }
};

/// What a measured impact says, and how well: errors of samples are independent but for the inflations.
struct Measurement {
  double sigma_force = 0, sigma_displacement = 0;     ///< noise of one sample [N], [m]
  double freedom_force = 1, freedom_displacement = 1; ///< degrees of freedom these were found with, >= 1
  /// Whether the record's own noise is what its errors are judged by; a table without any comes from a program, and its
  /// errors are stated ones, as of every run folder.
  bool noisy() const { return sigma_force > 0 || sigma_displacement > 1e-7; }
  double inflation = 1;       ///< variance of an average of many displacements over that of independent ones
  double inflation_force = 1; ///< the same of forces
  /// Of one sample, as it counts in an average of many.
  double noise_force() const { return sigma_force * std::sqrt(inflation_force); }
  double noise_displacement() const { return sigma_displacement * std::sqrt(inflation); }
  Eigen::Matrix2d start_factor =
      Eigen::Matrix2d::Zero(); ///< lower factor of the covariance of radial (u, v) at the start [m], [m/s]
  std::size_t pressed_first = 0, pressed_last = 0; ///< samples of the window whose force is compared
  std::size_t flown = 0;                           ///< first sample behind those the start is fitted to
  Functional peak;    ///< of the force [N]: a quartic's value at the instant of its largest
  Functional rebound; ///< of the displacement [m/s]: inward slope over the samples after release
};

/// One impact of a reference, in the radial direction of its touch. The reduced model is started from
/// `start`, a state of the reference just before the rim acts, so that a fit does not see errors of the
/// flight before it.
struct ImpactWindow {
  Impact impact;
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< outward unit vector at touch
  reduced::BearingState start;
  double end_time = 0; ///< release + tail, or the next touch, or where the response ends [s]
  double capacity = 0; ///< travel at which the reduced rim begins [m]: L_c, or beyond it where the rim is dented
  bool dented = false; ///< the reference was beyond L_c without rim force
  std::vector<double> times, displacement,
      force;            ///< samples in start.t..end_time: [s], radial [m], pushing > 0 [N]
  double peak = 0;      ///< peak of the radial force by smooth_peak() [N]
  double overshoot = 0; ///< travel beyond `capacity` if there were no rim [m], infinite when nothing else stops it
  /// overshoot < grazing_overshoot L_c: a slightly different flight would miss the rim, so its force says
  /// little. Never a window's, which comes with a speed that is given.
  bool grazing = false;
  std::optional<Measurement> measurement; ///< none: the reference has no noise
};

/// What made a run; several are named in this order.
enum class RunSource { finite_elements, measured, reduced_model };
constexpr auto choices(RunSource) {
  using enum RunSource;
  return choices_of<RunSource>(
      {{finite_elements, "finite elements"}, {measured, "measured"}, {reduced_model, "reduced model"}});
}

/// A stored run with its impacts. A `window` run is one isolated impact at a given speed.
struct StoredRun {
  std::string folder;
  scene::Scene scene;
  Response response;
  Summary summary; ///< peaks and impacts, made anew from the response
  std::vector<ImpactWindow> impacts;
  std::optional<Uncertainty> uncertainty; ///< the run's own, instead of the fit's
  double clock_error = 0; ///< of its force against its displacement, where a lag was found, beside the stated one [s]
  std::vector<std::string> notes;  ///< impacts left out and why, a run that stopped early, ...
  std::vector<std::string> noise;  ///< of a measured record: what is worth telling, among the notes too
  std::vector<std::string> doubts; ///< of a measured record: what its noise does not explain
  bool is_window() const { return scene.excitation.kind == scene::ExcitationKind::window; }
  double peak_force() const;     ///< of all impacts [N]
  double approach_speed() const; ///< the largest [m/s]
};

/// A mapping file is read by read_measured(). Otherwise reads scene.toml, the response and (for its status)
/// summary.json. Velocities are differentiated where a CSV has none. Throws InputError or DataError naming
/// folder and reason.
StoredRun read_run(const std::string &folder, const WindowOptions &options);
/// The same from memory.
StoredRun make_run(const std::string &folder, const scene::Scene &scene, Response response,
                   const WindowOptions &options);

} // namespace rimpact::calibration
