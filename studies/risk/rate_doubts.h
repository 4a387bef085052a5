/// What a study's rates rest on besides its runs, in one sentence a quantity and cause.
#pragma once
#include "studies/risk/evaluate.h"
#include <map>
#include <string>

namespace rimpact::risk {

class RateDoubts {
public:
  /// `tail`: share of the rate from levels at which no run exceeds the limit (disaggregation.h).
  void add(std::size_t system, const std::string &quantity, const LimitResult &limit, double tail);
  std::vector<std::string> sentences(const std::vector<double> &levels_g) const;

private:
  enum class Cause { refused, falls, tail, above, across, below, between }; ///< in the order they are said
  struct Where {
    std::size_t first_system = 0, n = 0; ///< results it is said of
    double least_limit = 0, largest_limit = 0, worst = 0;
  };
  void add(Cause cause, std::size_t system, const std::string &quantity, double limit, double share);
  static std::string sentence(Cause cause, double worst, const std::vector<double> &levels_g);
  std::map<std::pair<std::string, Cause>, Where> causes_;
};

} // namespace rimpact::risk
