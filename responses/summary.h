/// What summary.json holds (docs/interface.md). Peaks are of the horizontal norm.
#pragma once
#include "responses/choices.h"
#include "responses/foot_report.h"
#include "responses/response.h"
#include "responses/steel_report.h"
#include "scene/scene.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact {

struct Impact {
  double touch_time, release_time;      ///< first and last instant of non-zero rim force [s]
  double direction_deg;                 ///< of the displacement at touch
  double approach_speed, rebound_speed; ///< radial, at touch and release [m/s]
  double peak_force, peak_penetration;  ///< [N], [m]
  std::optional<double> impulse = {};   ///< of the rim's force towards the middle [N s]; none: not measured
  double restitution() const { return approach_speed > 0 ? rebound_speed / approach_speed : 0; }
};

/// Energy ledger of a run [J]. external: work of the ground motion and drives; gravity: potential energy gained
/// (positive when lifted; of a building as if no axial spring were strained); damping: lost in a building's
/// dashpots and in the pad; impact: dissipated by the reduced impact law; contact: stored in or lost by contact
/// penalties; integrator: the time integrator's loss from its own formula.
struct EnergyLedger {
  double external = 0, gravity = 0, kinetic = 0, elastic = 0, plastic = 0, damping = 0, friction = 0, impact = 0,
         contact = 0, integrator = 0;
  double initial = 0;       ///< energy present at the start (a window's kinetic energy)
  double largest_input = 0; ///< running maximum of |external| + initial
  /// initial + external - (gravity + kinetic + elastic + plastic + damping + friction + impact + contact + integrator),
  /// divided by largest_input, or by the largest term where hardly anything is put in.
  double imbalance_relative() const;
};

struct Summary {
  double peak_displacement = 0, peak_lateral_force = 0, residual_displacement = 0, peak_vertical_displacement = 0;
  /// Horizontal, at the same last instant as residual_displacement, which is a place of rest only where it is 0 [m/s].
  std::optional<double> final_speed;
  std::optional<double> peak_impact_force, min_normal_force, max_plastic_strain;
  SteelReport steel;              ///< of finite elements; empty: none were there
  std::optional<FootReport> foot; ///< of finite elements
  std::vector<Impact> impacts;
  std::optional<EnergyLedger> energy;
  SolvedBy rung = SolvedBy::reduced;
  std::optional<int> mesh;
  long n_dofs = 0, n_steps = 0, n_newton_iterations = 0;
  std::map<std::string, double> time_split; ///< search, assembly, factor, solve, output [s]
  double wall_time = 0;                     ///< [s]
  std::optional<double> processor_time;     ///< of all threads and ranks [s]; none: not measured
  long peak_memory_bytes = 0;
  RunStatus status = RunStatus::done;
  std::string reason;
  nlohmann::json extra = nlohmann::json::object(); ///< further keys, merged in (plan, warnings, ...)
};

nlohmann::json to_json(const Summary &summary);
/// Fills peaks and impacts from a response: an impact is a run of consecutive non-zero impact_x|y samples.
void summarise_response(const Response &response, Summary &summary);
/// The impacts' impulses from samples in time (trapezoidal rule), of a response whose impacts they are.
void add_impulses(const Response &response, std::vector<Impact> &impacts);
/// What to say of a scene that ends with the rim pressed, whose last impact has no rebound yet.
std::optional<std::string> doubt_of_rebound(const Response &response, const std::vector<Impact> &impacts);
/// What to say of a stack of solids that leaves its dish and has come back to it where the response ends, or may have:
/// no loss of the pad ends the bounce.
std::optional<std::string> doubt_of_bounce(const Response &response);
/// What to say of a run, finished or stopped, whose energies do not add up.
std::optional<std::string> doubt_of_ledger(const EnergyLedger &ledger);
/// What to say of a run whose contacts have given back energy that was not there: `mass` [kg] leaves the impacts at
/// their rebound speeds, which are overstated by about the share that the created energy has in theirs, halved.
std::optional<std::string> doubt_of_contact(const EnergyLedger &ledger, const std::vector<Impact> &impacts,
                                            double mass);
/// Processor time of this process so far, all its threads [s].
double processor_seconds();
/// Peak resident memory of this process [bytes].
long peak_memory_bytes();

} // namespace rimpact
