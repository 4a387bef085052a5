#include "studies/risk/limits_reader.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "studies/fleets/sweep_toml.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

class LimitsReader : fleets::SweepToml {
public:
  using SweepToml::SweepToml;

  std::vector<Limit> read() const {
    const auto *node = file_.find("limit");
    if (!node || !node->is_array() || node->as_array()->empty())
      throw InputError(fmt::format("{}: a study needs [[limit]] with quantity and values", file_.location("limit")));
    std::vector<Limit> limits;
    each_table(*node, "limits are written [[limit]], one table each", [&](const toml::table &entry) {
      only(entry, {"quantity", "values"}, "limit");
      const auto *quantity = entry.get("quantity");
      if (!quantity || !quantity->is_string()) fail(entry, "a limit needs quantity = \"NAME\"");
      Limit limit{quantity->as_string()->get(), {}};
      const auto &known = quantities();
      if (std::find(known.begin(), known.end(), limit.quantity) == known.end())
        fail(*quantity, "limit.quantity: " + unknown_word(limit.quantity, known));
      for (const auto &other : limits)
        if (other.quantity == limit.quantity)
          fail(*quantity, fmt::format("limit: \"{}\" is given twice; put its values into one", limit.quantity));
      limit.values = limit.quantity == collapsed ? std::vector<double>{1} : limit_values(entry);
      limits.push_back(std::move(limit));
    });
    return limits;
  }

private:
  std::vector<double> limit_values(const toml::table &limit) const {
    const auto *node = limit.get("values");
    if (!node) fail(limit, "a limit needs values, a list or { from = .., to = .., count = .. }");
    std::vector<double> values;
    if (const auto *list = node->as_array()) {
      for (const auto &value : *list) values.push_back(number(value, "limit.values"));
    } else if (const auto *table = node->as_table()) {
      only(*table, {"from", "to", "count"}, "limit.values");
      const double count = number_in(*table, "count", "limit.values");
      if (!(count >= 2 && count <= 1000 && count == std::floor(count)))
        fail(*node, "limit.values.count must be a whole number from 2 to 1000");
      for (const auto &value :
           fleets::even_values("variable.limit", number_in(*table, "from", "limit.values"),
                               number_in(*table, "to", "limit.values"), static_cast<int>(count), place(*node)))
        values.push_back(std::get<double>(value.cell));
    }
    std::sort(values.begin(), values.end());
    if (values.empty() || !(values.front() > 0) || std::adjacent_find(values.begin(), values.end()) != values.end())
      fail(*node, "limit.values must be different numbers > 0");
    return values;
  }
};

} // namespace

std::vector<Limit> read_limits(const TomlFile &file, const std::string &origin) {
  return LimitsReader(file, origin).read();
}

} // namespace rimpact::risk
