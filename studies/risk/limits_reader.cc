#include "studies/risk/limits_reader.h"
#include "io/files/toml_reader.h"
#include "studies/fleets/sweep_reader.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

std::vector<double> even(TomlReader &reader, const TomlFile &file) {
  double from = 0, to = 0;
  int count = 0;
  reader.section("values", [&] {
    reader.number({"from"}, from, si, {-huge, huge});
    reader.number({"to"}, to, si, {-huge, huge});
    reader.integer({"count"}, count, 2, 1000);
    for (const char *needed : {"from", "to", "count"})
      if (!reader.has(needed)) reader.refuse("", fmt::format("limit.values needs {}", needed));
  });
  std::vector<double> values;
  for (const auto &value : fleets::even_values("variable.limit", from, to, count, file.origin()))
    values.push_back(std::get<double>(value.cell));
  return values;
}

std::vector<double> limit_values(TomlReader &reader, const TomlFile &file) {
  const auto *node = reader.node({"values"});
  if (!node) reader.refuse("", "a limit needs values, a list or { from = .., to = .., count = .. }");
  std::vector<double> values;
  if (node->is_table())
    values = even(reader, file);
  else
    reader.numbers({"values"}, values, si, {-huge, huge});
  std::sort(values.begin(), values.end());
  if (values.empty() || !(values.front() > 0) || std::adjacent_find(values.begin(), values.end()) != values.end())
    reader.refuse("values", "limit.values must be different numbers > 0");
  return values;
}

} // namespace

std::vector<Limit> read_limits(const TomlFile &file) {
  TomlReader reader(file, "");
  std::vector<Limit> limits;
  reader.tables("limit", [&] {
    if (!reader.has("quantity")) reader.refuse("", "a limit needs quantity = \"NAME\"");
    Limit limit;
    reader.word({"quantity"}, limit.quantity, quantities());
    for (const auto &other : limits)
      if (other.quantity == limit.quantity)
        reader.refuse("quantity", fmt::format("limit: \"{}\" is given twice; put its values into one", limit.quantity));
    if (limit.quantity == collapsed) reader.node({"values"}); // which it has not
    limit.values = limit.quantity == collapsed ? std::vector<double>{1} : limit_values(reader, file);
    limits.push_back(std::move(limit));
  });
  if (limits.empty()) reader.refuse("limit", "a study needs [[limit]] with quantity and values");
  return limits;
}

} // namespace rimpact::risk
