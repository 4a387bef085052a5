/// Watches the run of a building: stores samples, keeps peaks, impacts and the energy ledger.
#pragma once
#include "buildings/dynamics.h"
#include "buildings/hinge_envelope.h"
#include "buildings/members.h"
#include "reduced_models/motion/step_budget.h"
#include "responses/summary.h"
#include <functional>

namespace rimpact::buildings {

/// That a response has signals for (responses/response.cc); of members only inelastic ones.
inline constexpr int most_bearings = 64, most_floors = 40, most_members = 200;

/// A piece of the solution on one branch.
struct BuildingSegment {
  double t0, t1;
  const Eigen::VectorXd &y0, &y1;
  std::function<Eigen::VectorXd(double)> at;
};

/// A building as it stands at one instant.
struct BuildingInstant {
  double t = 0;
  Eigen::VectorXd q;
  std::vector<double> normal, rim_force; ///< of each bearing [N]
  Eigen::VectorXd members;               ///< end forces of inelastic members; empty: linear ones
};

/// What a run leaves besides its signals.
struct BuildingTrace {
  double step = 0; ///< between `instants` [s]; 0: none
  std::vector<BuildingInstant> instants;
  BuildingInstant hardest; ///< largest force of any rim, or, untouched, largest travel
  MemberEnvelope members;  ///< over the samples and the steps between them
  HingeEnvelope hinges;
};

class BuildingRecorder {
public:
  /// `response` may be null: peaks and impacts only. `trace` with the frame's `members`, or null. Throws InputError
  /// beyond most_bearings, most_floors.
  BuildingRecorder(const BuildingBasis &building, Response *response, double output_step,
                   BuildingTrace *trace = nullptr, const MemberForces *members = nullptr);

  /// A run by branches (building_run.h).
  void begin(const BuildingDynamics &dynamics, const BearingModes &modes, const Eigen::VectorXd &y);
  void segment(const BuildingDynamics &dynamics, const BearingModes &modes, const BuildingSegment &segment);
  void branch(const BuildingDynamics &dynamics, const BearingModes &before, const BearingModes &after, double t,
              const Eigen::VectorXd &y, double loss);

  /// A run by steps that end at every sample (implicit_run.h).
  void begin(const Eigen::VectorXd &y, const BuildingResponse &r);
  void step(double t, const Eigen::VectorXd &y, const BuildingResponse &r);
  double next_sample() const { return next_sample_; }

  void end(double t, const Eigen::VectorXd &y, const BuildingResponse &r);

  EnergyLedger ledger(const Eigen::VectorXd &y) const;
  /// Peaks, impacts of all bearings in order, energies; `bearings`, `floors` and `worst_bearing` in extra.
  void summarise(Summary &summary) const;
  const HingeEnvelope &hinges() const { return hinges_; } ///< empty of a linear building

  reduced::StepCount steps; ///< taken so far

private:
  struct BearingPeaks {
    double travel = 0, force = 0, impact = 0, largest_normal = 0, smallest_normal = 1e300, lift = 0;
    std::vector<Impact> impacts;
    bool pressed = false;
    double watched = 0, rim_force = 0; ///< at the instant last watched
    Eigen::Vector2d interface_slip = Eigen::Vector2d::Zero();
  };
  struct FloorPeaks {
    double displacement = 0, drift = 0, drift_x = 0, drift_y = 0, acceleration = 0, shear = 0;
  };
  nlohmann::json table_of(std::size_t bearing, double residual) const; ///< of the summary; residual travel [m]
  void store(double t, const Eigen::VectorXd &y, const BuildingResponse &r);
  void watch(double t, const Eigen::VectorXd &y, const BuildingResponse &r);
  void trace(double t, const Eigen::VectorXd &y, const BuildingResponse &r);
  BuildingInstant instant(double t, const Eigen::VectorXd &y, const BuildingResponse &r) const;
  Eigen::Vector2d drift(int floor, const Eigen::VectorXd &y) const;
  Eigen::Vector2d overturning(const BuildingResponse &r) const;
  double next_after(bool on_rims, double t) const;
  void press(int b, bool pressed, double t, const Eigen::Vector2d &u, const Eigen::Vector2d &v);

  const BuildingBasis &dynamics_;
  Response *response_;
  BuildingTrace *trace_;
  const MemberForces *members_;
  double hardest_force_ = 0, hardest_travel_ = -1;
  double output_step_, contact_step_, next_sample_ = 0, last_sample_ = -1e300;
  double initial_elastic_ = 0, initial_gravity_ = 0, initial_kinetic_ = 0, initial_height_ = 0, landing_loss_ = 0,
         largest_input_ = 0;
  std::vector<BearingPeaks> bearings_;
  std::vector<FloorPeaks> floors_;
  HingeEnvelope hinges_;
  double base_acceleration_ = 0, peak_displacement_ = 0, peak_shear_ = 0, peak_overturning_ = 0, peak_rotation_ = 0,
         smallest_total_ = 1e300, peak_height_ = -1e300;
  Eigen::VectorXd final_;
};

} // namespace rimpact::buildings
