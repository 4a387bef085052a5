#include "studies/fleets/latin_hypercube_reader.h"
#include "io/files/error.h"
#include "scene/scene.h"
#include "studies/fleets/correlation.h"
#include "studies/fleets/sweep_toml.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fleets {
namespace {

class LatinHypercubeReader : SweepToml {
public:
  LatinHypercubeReader(const TomlFile &file, const std::string &origin, SweepParts &parts)
      : SweepToml(file, origin), parts_(parts) {}

  void read() {
    const auto *node = file_.root().get("latin_hypercube");
    const toml::node *correlation = nullptr;
    each_key("latin_hypercube", [&](const std::string &key, const toml::node &leaf) {
      const auto whole = leaf.value<std::int64_t>();
      if (key == "correlation") {
        correlation = &leaf; // of keys that may stand below it
      } else if (key == "samples") {
        if (!leaf.is_integer() || *whole < 1 || *whole > static_cast<std::int64_t>(largest_fleet))
          fail(leaf, fmt::format("samples must be a whole number from 1 to {}", largest_fleet));
        parts_.samples = static_cast<int>(*whole);
      } else if (key == "seed") {
        if (!leaf.is_integer() || *whole < 0) fail(leaf, "seed must be a whole number, 0 or more");
        parts_.seed = static_cast<std::uint64_t>(*whole);
      } else {
        parts_.sampled.push_back({key, distribution(key, leaf)});
      }
    });
    if (node && parts_.samples == 0) fail(*node, "latin_hypercube needs samples, the number of its points");
    if (node && parts_.sampled.empty()) fail(*node, "latin_hypercube has no key to sample");
    if (correlation) read_correlation(*correlation);
  }

private:
  /// [["KEY", "KEY", number], ...]; pairs that are not named are not correlated.
  void read_correlation(const toml::node &node) {
    const char *form = "latin_hypercube.correlation must be a list of [\"KEY\", \"KEY\", number]";
    const auto *list = node.as_array();
    if (!list) fail(node, form);
    const std::size_t n = parts_.sampled.size();
    parts_.correlation.assign(n, std::vector<double>(n, 0));
    for (std::size_t i = 0; i < n; ++i) parts_.correlation[i][i] = 1;
    for (const auto &entry : *list) {
      const auto *triple = entry.as_array();
      if (!triple || triple->size() != 3 || !(*triple)[0].is_string() || !(*triple)[1].is_string()) fail(entry, form);
      const std::size_t a = place_of_sampled((*triple)[0]), b = place_of_sampled((*triple)[1]);
      const double value = number((*triple)[2], "latin_hypercube.correlation");
      if (a == b || parts_.correlation[a][b] != 0) fail(entry, "latin_hypercube.correlation: each pair of keys once");
      if (!(std::abs(value) < 1))
        fail(entry, fmt::format("latin_hypercube.correlation {} must lie between -1 and 1", value));
      parts_.correlation[a][b] = parts_.correlation[b][a] = value;
    }
    try {
      correlated(latin_hypercube(static_cast<int>(n), parts_.samples, parts_.seed), parts_.correlation);
    } catch (const InputError &error) {
      fail(node, fmt::format("latin_hypercube.correlation: {}", error.what()));
    }
  }
  std::size_t place_of_sampled(const toml::node &node) const {
    const std::string key = node.as_string()->get();
    for (std::size_t i = 0; i < parts_.sampled.size(); ++i)
      if (parts_.sampled[i].key == key) return i;
    fail(node, fmt::format("latin_hypercube.correlation: \"{}\" is not sampled", key));
  }

  Distribution distribution(const std::string &key, const toml::node &node) const {
    const auto *table = node.as_table();
    if (!table) fail(node, key + " must be { low = .., high = .. }, with mean and deviation for a normal one");
    only(*table, {"low", "high", "log", "mean", "deviation"}, key);
    Distribution d{.low = number_in(*table, "low", key), .high = number_in(*table, "high", key)};
    if (!(d.low < d.high)) fail(node, fmt::format("{}: low {} must be below high {}", key, d.low, d.high));
    if (const auto *log = table->get("log"); log && log->value_or(false)) {
      if (!(d.low > 0)) fail(node, fmt::format("{}: low {} must be > 0 with log = true", key, d.low));
      d.kind = Distribution::Kind::log_uniform;
    } else if (log && !log->is_boolean()) {
      fail(*log, key + ".log must be true or false");
    }
    if (table->contains("mean") || table->contains("deviation")) {
      if (d.kind == Distribution::Kind::log_uniform) fail(node, key + ": log and mean exclude each other");
      d.kind = Distribution::Kind::normal;
      d.mean = number_in(*table, "mean", key), d.deviation = number_in(*table, "deviation", key);
      if (!(d.deviation > 0)) fail(node, fmt::format("{}: deviation {} must be > 0", key, d.deviation));
      if (!(d.quantile(0.75) > d.quantile(0.25)))
        fail(node, fmt::format("{}: nothing of the normal distribution lies between {} and {}", key, d.low, d.high));
    }
    for (const double end : {d.low, d.high})
      if (!is_variable(key)) scene::check_assignment(key + "=" + number_value(end).toml, place(node));
    return d;
  }

  SweepParts &parts_;
};

} // namespace

void read_latin_hypercube(const TomlFile &file, const std::string &origin, SweepParts &parts) {
  LatinHypercubeReader(file, origin, parts).read();
}

} // namespace rimpact::fleets
