/// A measured record as a whole: its contacts, the free flights between them, its noise.
#pragma once
#include "calibration/data/contact_detector.h"
#include "calibration/data/flight_fit.h"
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// Samples first..last; none where last < first.
struct Span {
  std::size_t first = 1, last = 0;
  std::size_t size() const { return last + 1 > first ? last + 1 - first : 0; }
};
/// Beside one contact: up to 50 ms before it and the window's tail after it, less what the rim may still bear there.
struct Flights {
  Span before, after;
};
inline constexpr std::size_t shortest_flight = 4; ///< samples
inline constexpr double noise_reach = 5;          ///< standard errors beyond which a difference is no noise

class MeasuredRecord {
public:
  /// `run` and `options` must outlive it.
  MeasuredRecord(const StoredRun &run, const WindowOptions &options);

  const std::vector<Contact> &contacts() const { return force_.contacts; }
  const ContactRecord &force() const { return force_; }
  const Flights &flights(std::size_t contact) const { return flights_[contact]; }
  /// The state at t_ref, within the flight.
  FlightFit state(const Span &flight, double t_ref) const;

  /// Noise of one displacement sample [m]: root mean square of what all flights leave. Of a record without a flight: by
  /// differences.
  double sigma() const { return sigma_; }
  double freedom() const { return freedom_; } ///< degrees of freedom sigma() was found with
  /// What the correlation of neighbouring errors costs an average of many, >= 1: (1 + rho) / (1 - rho) where rho is
  /// sure.
  double inflation() const { return inflation_; }
  /// What was found, and the force_noise that goes with it.
  std::string sentence() const;

private:
  Span between(double from, double to) const;
  Flights flights_of(std::size_t contact) const;
  double free_until(const Contact &contact) const; ///< [s]; surely
  double free_from(const Contact &contact) const;
  bool inside(std::size_t sample) const; ///< the mean travel of five samples is below L_c
  void measure_noise();

  const StoredRun &run_;
  const Response &r_;
  const std::vector<double> &times_;
  const WindowOptions &options_;
  ContactRecord force_;
  std::vector<Flights> flights_;
  double sigma_ = 0, freedom_ = 0, inflation_ = 1;
  bool planar_ = false; ///< y is measured too
};

} // namespace rimpact::calibration
