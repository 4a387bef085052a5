/// What a calibration's answer says of the rim's law, for other programs: its numbers, checked and in SI, and the
/// sentences that go with them. A number that is missing or out of its range is refused (DataError) with file and key.
#pragma once
#include "laws/impact/catalogue.h"
#include "scene/scene.h"
#include "scene/stored_calibration.h"
#include <optional>

namespace rimpact::calibration {

struct ExportChoice {
  std::string law = {}; ///< empty: the answer's; "pair": the answer's constant pair; else one of the ranked laws
  std::optional<double> mass = {};     ///< [kg] that the bearing carries; none: the answer's, or what `vertical` weighs
  std::optional<double> vertical = {}; ///< dead load [N]; none: the answer's, or W = m g of a mass that is given
};

struct ExportedRim {
  scene::ReducedSettings settings;  ///< impact_law and every number it reads
  bool of_mass = false;             ///< its numbers hold for `fitted_mass` only
  double mass = 0, fitted_mass = 0; ///< carried here and in the calibration [kg]
  double vertical = 0;              ///< dead load W [N]
  double gravity = 0;               ///< [m/s^2]
  double lateral_capacity = 0;      ///< travel at which the rim begins [m]
  double from = 0,
         to = 0; ///< approach speeds at `mass` [m/s] it is tuned and checked for: where the law holds, or those fitted
  double tuned_to =
      0; ///< fastest touch that springs and links are tuned to [m/s], >= to: those of the check's pulses too
  static constexpr double least_span =
      1.5;          ///< of `to` over `from`: where the law holds over less, the speeds fitted are taken
  std::string foot; ///< where its law ends because the joint at its foot goes, a sentence; empty: it does not
  std::string bearing, rim_identity;
  std::vector<std::string> statement; ///< bearing, load, law, range, errors, doubts: plain sentences in this order

  const laws::ImpactLaw &law() const { return *settings.impact_law; }
  laws::RimElement element() const { return settings.element(mass); }
};

/// Throws DataError where the calibration has no answer or a bad number. Throws InputError where `choice` asks for a
/// law that was not ranked, a pair that was not found, or a law of one mass at another (more than 1 % off). Throws
/// InputError for a law whose speeds all break the rim's foot.
ExportedRim exported_rim(const scene::StoredCalibration &calibration, const ExportChoice &choice);

} // namespace rimpact::calibration
