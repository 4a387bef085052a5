#include "fe_contact/planning/machine_times.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace rimpact::planning {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double meshing = 3; // before the first iteration [s]

fs::path cache_file() {
  if (const char *cache = std::getenv("XDG_CACHE_HOME"); cache && *cache == '/')
    return fs::path(cache) / "rimpact" / "machine.json";
  const char *home = std::getenv("HOME");
  return home && *home == '/' ? fs::path(home) / ".cache" / "rimpact" / "machine.json" : fs::path();
}

std::string kind_of(const Plan &plan) {
  return fmt::format("{}-mesh{}-{}", word(plan.rung), plan.mesh, plan.half ? "half" : "whole");
}

/// Natural logarithm of the seconds an iteration and unknown take: mean and variance.
struct LogUnit {
  double mean, variance;
};

json read_cache() {
  try {
    const json cache = json::parse(read_file(cache_file().string()), nullptr, false);
    return cache.is_object() ? cache : json::object();
  } catch (const Error &) { // none yet, or not to be read
    return json::object();
  }
}

json child(const json &object, const std::string &key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : json();
}

std::optional<LogUnit> unit_in(const json &cache, const Plan &plan) {
  constexpr double least = 1e-9, most = 1; // [s]: beyond them the file was damaged
  const json entry = child(child(cache, processor_name()), kind_of(plan));
  const json unit = child(entry, "seconds_per_iteration_and_unknown"), variance = child(entry, "log_variance");
  if (!unit.is_number() || !variance.is_number()) return {};
  const double seconds = unit, spread = variance;
  if (!(seconds > least && seconds < most && spread >= 0 && spread < 10)) return {};
  return LogUnit{std::log(seconds), spread};
}

} // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (const auto colon = line.find(": "); line.rfind("model name", 0) == 0 && colon != std::string::npos)
      return line.substr(colon + 2);
  return "unknown processor";
}

void time_by_this_machine(Plan &plan) {
  const double iterations = std::log(1.25), unknown = std::log(2.0);
  double spread = std::hypot(iterations, unknown);
  const auto known = unit_in(read_cache(), plan);
  if (known && plan.expected_iterations > 0) {
    plan.timed_here = true;
    plan.expected_seconds = meshing + plan.expected_iterations * plan.expected_dofs * std::exp(known->mean);
    spread = std::hypot(iterations, 1.5 * std::sqrt(known->variance));
  }
  plan.fastest = plan.expected_seconds * std::exp(-spread);
  plan.slowest = plan.expected_seconds * std::exp(spread);
}

void remember_times(const Plan &plan, const Summary &summary) {
  constexpr long fewest = 20; // iterations that tell anything
  constexpr double weight = 0.3, first_variance = 0.04;
  double solving = 0;
  for (const auto &[part, seconds] : summary.time_split)
    if (part != "output") solving += seconds;
  const fs::path path = cache_file();
  if (path.empty() || summary.status != RunStatus::done || summary.n_newton_iterations < fewest ||
      summary.n_dofs <= 0 || !(solving > 0))
    return;
  const double unit = std::log(solving / summary.n_newton_iterations / summary.n_dofs);
  json cache = read_cache();
  LogUnit now{unit, first_variance};
  if (const auto known = unit_in(cache, plan)) {
    now.mean = (1 - weight) * known->mean + weight * unit;
    now.variance = (1 - weight) * (known->variance + weight * (unit - known->mean) * (unit - known->mean));
  }
  json &machine = cache[processor_name()];
  if (!machine.is_object()) machine = json::object();
  machine[kind_of(plan)] = {{"seconds_per_iteration_and_unknown", std::exp(now.mean)}, {"log_variance", now.variance}};
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  try {
    write_atomically(cache.dump(2) + "\n", path.string());
  } catch (const Error &) { // a read-only home is no reason to fail a run that ended well
  }
}

std::string expected_time(const Plan &plan) {
  const auto in_words = [](double seconds, bool minutes) {
    if (minutes) return fmt::format("{:g}", std::max(1.0, std::round(seconds / 60)));
    return fmt::format("{:g}", seconds < 20 ? std::max(1.0, std::round(seconds)) : 5 * std::round(seconds / 5));
  };
  constexpr double in_minutes = 90; // [s]
  const bool low = plan.fastest >= in_minutes, high = plan.slowest >= in_minutes;
  const std::string from = in_words(plan.fastest, low), to = in_words(plan.slowest, high);
  const char *unit = high ? "min" : "s", *where = plan.timed_here ? "here" : "on a machine that has not run its like";
  if (low == high && from == to) return fmt::format("about {} {} {}", to, unit, where);
  return fmt::format("about {}{} to {} {} {}", from, low == high ? "" : " s", to, unit, where);
}

} // namespace rimpact::planning
