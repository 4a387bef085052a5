/// What went through the rim's foot in a finite-element run, as summary.json has it ("rim_foot"), made from the signals
/// `rim_foot_...` of the response: the instant at which the joint, or two fillet welds in its place, is used most.
#pragma once
#include "responses/foot_strength.h"
#include "responses/response.h"
#include <nlohmann/json.hpp>

namespace rimpact {

struct FootReport {
  double time = 0;                          ///< [s], or the load parameter
  FootLine worst;                           ///< per length, where the joint is used most; `along` is not stored
  double weld = 0;                          ///< of one of two fillet welds there [N/m]
  double needed_throat = 0;                 ///< of two fillet welds that bear it [m], with the joint's weld strength
  std::optional<double> use;                ///< of the joint [-]; none: one piece with the plate
  double normal = 0, shear = 0, moment = 0; ///< over the whole foot at that instant [N], [N], [N m]
  /// Of the rim where that use first passes 1 [N], on a straight line between two instants; none: it does not.
  std::optional<double> goes_at_force;
  bool exceeded() const { return use && *use > 1; }
};

/// Of a run's response; none: nobody looked at its foot.
std::optional<FootReport> foot_report(const Response &response, const scene::Bearing &bearing);
nlohmann::ordered_json to_json(const FootReport &report, const scene::RimConnection &connection);
/// Of a summary.json; none where it has none. Throws DataError, naming `origin`, for one that cannot be read, or that
/// does not tell the force at which its joint goes.
std::optional<FootReport> foot_report_in(const nlohmann::json &summary, const std::string &origin);

} // namespace rimpact
