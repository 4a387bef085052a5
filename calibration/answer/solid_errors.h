/// Of an answer's errors the parts of the finite elements and of what they model: mesh, step, rung, energy, steel and
/// geometry.
#pragma once
#include "calibration/answer/error_parts.h"
#include "calibration/answer/kept_errors.h"

namespace rimpact::calibration {

class SolidErrors {
public:
  using Runs = std::vector<const StoredRun *>;
  /// All must live as long as this.
  SolidErrors(const Calibration &c, const Answer &answer, const Runs &runs, const std::vector<StoredStudy> &studies);
  void add_to(ErrorParts &parts) const;

private:
  /// A command for the hardest run; none without one.
  template <class Find> std::optional<Finding> found_by(Find find) const;
  /// Of kept runs: the worst, by load and depth; unknown without any, with the command and the reason `none`.
  void add_kept(ErrorParts &parts, ErrorSource source, const std::vector<KeptError> &kept,
                const std::optional<Finding> &find, const std::string &none) const;
  void of_mesh(ErrorParts &parts) const;
  void of_step(ErrorParts &parts) const;
  void of_rung(ErrorParts &parts) const;
  /// Energy that no entry accounts for, a share s, goes at worst into the rebound (s / 2 e^2), into the force of a rim
  /// that does not yield (F^2 / 2 k: s / 2) or into the depth of one that yields at one force (F d: s).
  void of_energy(ErrorParts &parts) const;
  /// The law's steel has no rate, or one of two; how far it is from the other is the band of the twins.
  void of_steel(ErrorParts &parts) const;
  void of_band(ErrorParts &parts, const SteelBand &band) const;
  void of_geometry(ErrorParts &parts) const;
  bool all_by(scene::Rung rung) const; ///< every run fitted

  const Calibration &c_;
  const Answer &answer_;
  const Runs &runs_;
  const std::vector<StoredStudy> &studies_;
  const StoredRun *hardest_; ///< of finite elements, whose commands are named; nullptr: none hits the rim
};

/// Kind of excitation of a run, and its deepest penetration [m].
std::string load_of(const SolidErrors::Runs &runs, const std::string &folder);
std::optional<double> depth_of(const SolidErrors::Runs &runs, const std::string &folder);

} // namespace rimpact::calibration
