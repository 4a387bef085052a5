// Grids given on the command line.
#include "studies/fleets/grid_arguments.h"

#include "io/files/text.h"
#include "studies/fleets/sweep_reader.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fleets {
namespace {

Axis axis_of(const std::string &argument) {
  const std::string place = "--sweep " + argument;
  const auto equals = argument.find('=');
  const std::string key = argument.substr(0, equals);
  const auto parts = equals == std::string::npos ? std::vector<std::string_view>{}
                                                 : split(std::string_view(argument).substr(equals + 1), ':');
  double number[3];
  bool readable = parts.size() == 3 && !key.empty();
  for (std::size_t i = 0; i < 3 && readable; ++i) {
    const auto value = to_number(parts[i]);
    readable = value && std::isfinite(*value);
    if (readable) number[i] = *value;
  }
  if (!readable) throw InputError(place + ": must be a sweep file or KEY=a:b:n, e.g. excitation.scale=0.5:1.5:11");
  const auto [from, to, count] = number;
  if (!(count >= 1 && count <= largest_fleet && count == std::floor(count)))
    throw InputError(fmt::format("{}: n {} must be a whole number from 1 to {}", place, count, largest_fleet));
  if (count == 1 && from != to)
    throw InputError(fmt::format("{}: one value cannot be both {} and {}; n must be 2 or more", place, from, to));
  return {key, even_values(key, from, to, static_cast<int>(count), place)};
}

} // namespace

Sweep grid_of_arguments(const std::vector<std::string> &arguments) {
  SweepParts parts;
  std::string origin = "--sweep";
  for (const auto &argument : arguments) {
    parts.grid.push_back(axis_of(argument));
    origin += " " + argument;
  }
  return combine(parts, origin);
}

} // namespace rimpact::fleets
