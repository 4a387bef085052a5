/// What a difference's key buys: of each of its values and each limit the reductions over all systems.
#pragma once
#include "io/files/table.h"
#include "studies/risk/evaluate.h"
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

namespace rimpact::risk {

class Reductions {
public:
  void add(const std::string &key, const Cell &value, const std::string &quantity, const LimitResult &own,
           const LimitResult &reference, const Banded &band);
  nlohmann::ordered_json json() const; ///< a list, one entry a key, value and limit

private:
  struct Sum {
    int n = 0, n_sure = 0, n_unknown = 0;
    double total = 0, low = std::numeric_limits<double>::infinity(), high = -low, at_least = low, at_most = -low;
  };
  std::map<std::tuple<std::string, Cell, std::string, double>, Sum> sums_;
};

} // namespace rimpact::risk
