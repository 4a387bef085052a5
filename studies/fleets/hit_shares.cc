#include "studies/fleets/hit_shares.h"
#include "io/files/json_text.h"
#include "responses/frame_limits.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::fleets {
namespace {

using nlohmann::ordered_json;

std::string share_in_words(const HitShares::Part &part) {
  const double share = 100 * *part.share();
  return fmt::format("{} % of the hits on the rim ({} of {})",
                     share < 10 ? fmt::format("{:.2g}", share) : fmt::format("{:.0f}", share), part.n_beyond,
                     part.n_known);
}

/// "0.05 to 0.2 m/s", or one end of it.
std::string in_words(const std::optional<double> &from, const std::optional<double> &to) {
  if (from && to) return fmt::format("{:.3g} to {:.3g} m/s", *from, *to);
  return from ? fmt::format("{:.3g} m/s upwards", *from) : fmt::format("up to {:.3g} m/s", to.value_or(0));
}

void raise(std::optional<double> &largest, const std::optional<double> &value) {
  if (value) largest = std::max(largest.value_or(*value), *value);
}

} // namespace

std::optional<double> HitShares::Part::share() const {
  if (n_known == 0) return std::nullopt;
  return static_cast<double>(n_beyond) / static_cast<double>(n_known);
}

std::optional<double> HitShares::Part::count() const {
  if (n_known == 0) return std::nullopt;
  return static_cast<double>(n_beyond);
}

void HitShares::widen(Speeds &speeds, const Speeds &by) {
  if (by.first) speeds.first = std::min(speeds.first.value_or(*by.first), *by.first);
  if (by.second) speeds.second = std::max(speeds.second.value_or(*by.second), *by.second);
}

void HitShares::add(const CellReader &run) {
  const auto n = run("n_impacts");
  if (!n) return;
  ++n_runs_;
  const auto ductility = run("ductility"), drift = run("peak_drift_m");
  n_beyond_frame_ += is_beyond_frame(ductility, drift);
  raise(ductility_, ductility), raise(drift_, drift);
  if (!(*n > 0)) return;
  const auto hits = static_cast<std::size_t>(*n);
  ++n_with_impact_, n_hits_ += hits;
  for (const auto &[column, part] : {std::pair{"hits_beyond_fit", &fit_},
                                     {"hits_beyond_pair", &pair_},
                                     {"hits_beyond_rim", &rim_},
                                     {"hits_beyond_steel", &steel_}})
    if (const auto beyond = run(column)) part->n_known += hits, part->n_beyond += static_cast<std::size_t>(*beyond);
  widen(speeds_, {run("slowest_approach_speed_m_s"), run("fastest_approach_speed_m_s")});
  widen(known_, {run("known_from_m_s"), run("known_to_m_s")});
}

void HitShares::add(const HitShares &other) {
  n_runs_ += other.n_runs_, n_with_impact_ += other.n_with_impact_, n_hits_ += other.n_hits_;
  for (const auto &[part, more] :
       {std::pair{&fit_, &other.fit_}, {&pair_, &other.pair_}, {&rim_, &other.rim_}, {&steel_, &other.steel_}})
    part->n_known += more->n_known, part->n_beyond += more->n_beyond;
  widen(speeds_, other.speeds_), widen(known_, other.known_);
  n_beyond_frame_ += other.n_beyond_frame_;
  raise(ductility_, other.ductility_), raise(drift_, other.drift_);
}

ordered_json HitShares::json() const {
  ordered_json all{{"n_runs", n_runs_},
                   {"n_runs_with_impact", n_with_impact_},
                   {"n_hits", n_hits_},
                   {"slowest_approach_speed_m_s", or_null<ordered_json>(speeds_.first)},
                   {"fastest_approach_speed_m_s", or_null<ordered_json>(speeds_.second)},
                   {"known_from_m_s", or_null<ordered_json>(known_.first)},
                   {"known_to_m_s", or_null<ordered_json>(known_.second)},
                   {"bound_of_share", bound}};
  for (const auto &[name, part] : {std::pair{"fit", &fit_}, {"pair", &pair_}, {"rim", &rim_}, {"steel", &steel_}}) {
    all[fmt::format("hits_beyond_{}", name)] = or_null<ordered_json>(part->count());
    all[fmt::format("share_beyond_{}", name)] = or_null<ordered_json>(part->share());
  }
  const bool has_frame = ductility_ || drift_;
  all["runs_beyond_frame"] = has_frame ? ordered_json(n_beyond_frame_) : ordered_json(nullptr);
  all["largest_ductility"] = or_null<ordered_json>(ductility_), all["largest_drift_m"] = or_null<ordered_json>(drift_);
  return all;
}

std::vector<std::string> HitShares::doubts(bool with_frame) const {
  std::vector<std::string> found;
  const std::string speeds = fmt::format("hits come at {}", in_words(speeds_.first, speeds_.second)),
                    stated = fmt::format("a doubt above {:g} %", 100 * bound);
  if (fit_.is_above(bound))
    found.push_back(
        fmt::format("{} lie outside the speeds that the impact element was fitted to ({}): {}, their forces "
                    "and rebounds are extrapolated ({})",
                    share_in_words(fit_), in_words(known_.first, known_.second), speeds, stated));
  if (pair_.is_above(bound) && known_.second.value_or(0) == 0)
    found.push_back(fmt::format("{} are on the thesis's pair at a bearing or mass that it was not published for: "
                                "{}, their forces may be several times off; calibrate ({})",
                                share_in_words(pair_), speeds, stated));
  else if (pair_.is_above(bound))
    found.push_back(fmt::format("{} are faster than the thesis's pair is known for ({}): {}, and there its peak forces "
                                "are off by more than a fifth ({})",
                                share_in_words(pair_), in_words({}, known_.second), speeds, stated));
  if (rim_.is_above(0))
    found.push_back(fmt::format("{} press deeper into the rim than it is thick: such a rim has failed, and what comes "
                                "after is no result",
                                share_in_words(rim_)));
  if (steel_.is_above(0))
    found.push_back(fmt::format("{} strain the steel beyond its limit: cracks, which no law here has, would change the "
                                "force",
                                share_in_words(steel_)));
  if (const auto doubt = doubt_of_frame(ductility_, drift_); doubt && with_frame)
    found.push_back(fmt::format("{} of {} runs: {}", n_beyond_frame_, n_runs_, *doubt));
  return found;
}

} // namespace rimpact::fleets
