/// What a fit makes small, one block an impact or a flight; see fit.h for the groups.
#pragma once
#include "calibration/fit.h"
#include <memory>
#include <span>

namespace rimpact::calibration {

/// Residuals first .. first + count - 1 of a block share one stated uncertainty and together count as one
/// observation.
struct Group {
  std::string name;
  int first, count;
  double weight;
};

class ResidualBlock {
public:
  explicit ResidualBlock(const scene::Scene &scene) : scene_(scene) {}
  virtual ~ResidualBlock() = default;
  const scene::Scene &scene() const { return scene_; }
  const std::vector<Group> &groups() const { return groups_; }
  int size() const { return groups_.empty() ? 0 : groups_.back().first + groups_.back().count; }
  /// `scene` is scene() with trial values. May throw what the reduced model throws.
  virtual void evaluate(const scene::Scene &scene, std::span<double> residuals) const = 0;

protected:
  /// Adds a group; returns weight / (sigma sqrt(count)), what its differences are multiplied by.
  double add_group(const std::string &name, int count, double weight, double sigma);

private:
  scene::Scene scene_;
  std::vector<Group> groups_;
};

std::unique_ptr<ResidualBlock> impact_block(const StoredRun &run, const ImpactWindow &window,
                                            const FitOptions &options);
/// Motion from rest to the first touch; of quasi-static scenes the force instead.
std::unique_ptr<ResidualBlock> flight_block(const StoredRun &run, const FitOptions &options);

} // namespace rimpact::calibration
