/// Of runs of a table: how many of their hits on the rim lie where the models are not known to hold, and how many of
/// their frames.
#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::fleets {

/// A number of a run's row by its column (hit_limits.h has their meanings); none where the cell is empty.
using CellReader = std::function<std::optional<double>(const char *column)>;

class HitShares {
public:
  /// Above this share of the hits is a doubt; a rim pressed through and a steel beyond its limit are one at any share.
  static constexpr double bound = 0.05;

  struct Part {
    std::size_t n_known = 0, n_beyond = 0; ///< hits of runs that know it, and those of them that lie beyond
    std::optional<double> share() const;   ///< none: of no hit is it known
    std::optional<double> count() const;   ///< the same of n_beyond
    bool is_above(double least) const { return share().value_or(0) > least; }
  };

  /// A run without a result has no hits.
  void add(const CellReader &run);
  void add(const HitShares &other);
  std::size_t n_hits() const { return n_hits_; }
  const Part &fit() const { return fit_; }
  const Part &pair() const { return pair_; }
  const Part &rim() const { return rim_; }
  const Part &steel() const { return steel_; }
  std::optional<double> fastest() const { return speeds_.second; }
  std::optional<double> known_to() const { return known_.second; }

  /// Counts, shares and speeds; null: not known.
  nlohmann::ordered_json json() const;
  /// Sentences with the share, the speeds and the bound.
  /// `with_frame`: also of the frame beyond responses/frame_limits.h; false where a study has bounds of its own.
  std::vector<std::string> doubts(bool with_frame = true) const;

private:
  using Speeds = std::pair<std::optional<double>, std::optional<double>>;
  static void widen(Speeds &speeds, const Speeds &by);

  std::size_t n_runs_ = 0, n_with_impact_ = 0, n_hits_ = 0;
  Part fit_, pair_, rim_, steel_;
  std::size_t n_beyond_frame_ = 0;          ///< runs, frame_limits.h
  std::optional<double> ductility_, drift_; ///< the largest
  Speeds speeds_, known_; ///< the widest range of the approaches, and that the elements are known for [m/s]
};

} // namespace rimpact::fleets
