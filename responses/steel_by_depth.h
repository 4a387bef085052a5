/// How far a rim's steel is strained at a penetration, as the runs of a calibration say: what a reduced model, which
/// has no steel, knows of its own impacts.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rimpact {

class SteelByDepth {
public:
  /// Penetrations [m], > 0, and the largest plastic strain of the rim's steel there [-], of impacts in any order.
  explicit SteelByDepth(std::vector<std::pair<double, double>> rows);
  /// Of answer.strain in FOLDER/calibration.json; nullptr where that cannot be read or has no such rows. A folder is
  /// read once; safe from several threads.
  static std::shared_ptr<const SteelByDepth> of(const std::string &folder);

  /// Whether an impact so deep strains the steel beyond `limit`: between two runs by a straight line, from no strain at
  /// no depth. None deeper than any run, where the deepest stays below.
  std::optional<bool> is_beyond(double depth, double limit) const;

private:
  std::vector<std::pair<double, double>> rows_; ///< by depth, the strain never falling
};

} // namespace rimpact
