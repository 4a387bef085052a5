#include "../scene/expect_error.h"
#include "studies/fleets/grid_arguments.h"
#include "studies/fleets/sweep.h"
#include <algorithm>
#include <cmath>

using namespace rimpact;
using namespace rimpact::fleets;

namespace {

double number(const Sweep &s, std::size_t run, const std::string &key) {
  const auto i = std::find(s.keys.begin(), s.keys.end(), key) - s.keys.begin();
  return std::get<double>(s.runs.at(run).at(static_cast<std::size_t>(i)).cell);
}

} // namespace

TEST(Sweep, GridIsEveryCombination) {
  const Sweep s = parse_sweep("[grid]\nexcitation.scale = [0.5, 1, 2.5]\n"
                              "bearing.surface.a_m = { from = 1.0, to = 2.0, count = 3 }\n",
                              "s.toml");
  ASSERT_EQ(s.runs.size(), 9u);
  EXPECT_EQ(s.keys, (std::vector<std::string>{"bearing.surface.a_m", "excitation.scale"}));
  EXPECT_EQ(number(s, 4, "bearing.surface.a_m"), 1.5);
  EXPECT_EQ(number(s, 4, "excitation.scale"), 1);
  EXPECT_EQ(s.assignments(8), (std::vector<std::string>{"bearing.surface.a_m=2", "excitation.scale=2.5"}));
}

TEST(Sweep, CasesGridSamplesAndProducts) {
  const Sweep s = parse_sweep(R"(
[[case]]
name = "first"
excitation.x = "a.AT2"
variable.unit = 2.0
[[case]]
name = "second"
excitation.x = "builtin:near-fault-x"
variable.unit = 4.0
[grid]
variable.intensity = [0.1, 0.2, 0.3]
[latin_hypercube]
samples = 5
seed = 7
reduced.mu_fast = { mean = 0.05, deviation = 0.02, low = 0.03, high = 0.07 }
reduced.k_i_kN_per_m = { low = 1e4, high = 1e6, log = true }
[linked]
excitation.scale = { product = ["variable.intensity", "variable.unit"] }
reduced.mu_slow = { product = [0.5, "reduced.mu_fast"] }
)",
                              "/folder/s.toml");
  ASSERT_EQ(s.runs.size(), 2u * 3 * 5);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_DOUBLE_EQ(number(s, i, "excitation.scale"), 0.1 * double(1 + i / 5 % 3) * (i < 15 ? 2 : 4));
    EXPECT_DOUBLE_EQ(number(s, i, "reduced.mu_slow"), number(s, i, "reduced.mu_fast") / 2);
    EXPECT_EQ(number(s, i, "reduced.mu_fast"), number(s, i % 5, "reduced.mu_fast")); // the same samples everywhere
  }
  const auto has = [&](std::size_t run, const std::string &text) {
    const auto all = s.assignments(run);
    return std::find(all.begin(), all.end(), text) != all.end();
  };
  EXPECT_TRUE(has(0, "excitation.x=\"/folder/a.AT2\"")); // beside the sweep file
  EXPECT_TRUE(has(29, "excitation.x=\"builtin:near-fault-x\""));
  for (const auto &assignment : s.assignments(0)) {
    EXPECT_EQ(assignment.find("variable"), std::string::npos);
    EXPECT_EQ(assignment.find("case"), std::string::npos);
  }
}

TEST(Sweep, WordsSwitchesAndListsAreValuesToo) {
  const Sweep s = parse_sweep("[grid]\nreduced.normal_force = ['static', 'inertia']\nreduced.finite_pad = [true, "
                              "false]\nexcitation.displacement_m = [[0.1, 0.0]]\n",
                              "s.toml");
  ASSERT_EQ(s.runs.size(), 4u);
  EXPECT_EQ(s.assignments(0), (std::vector<std::string>{"excitation.displacement_m=[0.1, 0]", "reduced.finite_pad=true",
                                                        "reduced.normal_force=\"static\""}));
}

TEST(Sweep, SamplesAreCorrelatedAsAsked) {
  const auto values = [](const char *more) {
    const Sweep s =
        parse_sweep(std::string("[latin_hypercube]\nsamples = 200\nload.vertical_kN = { low = 600.0, high = 1100.0 }\n"
                                "reduced.mu_fast = { low = 0.03, high = 0.07 }\n") +
                        more,
                    "s.toml");
    std::vector<std::pair<double, double>> points;
    for (const auto &run : s.runs) points.emplace_back(std::get<double>(run[0].cell), std::get<double>(run[1].cell));
    return points;
  };
  const auto correlation = [](const auto &points) { // of uniform variables: near that of their normal scores
    double xx = 0, yy = 0, xy = 0;
    for (const auto &[a, b] : points) {
      const double x = a - 850, y = b - 0.05;
      xx += x * x, yy += y * y, xy += x * y;
    }
    return xy / std::sqrt(xx * yy);
  };
  EXPECT_NEAR(correlation(values("")), 0, 0.2);
  EXPECT_NEAR(correlation(values("correlation = [['load.vertical_kN', 'reduced.mu_fast', 0.8]]\n")), 0.8, 0.05);
  EXPECT_NEAR(correlation(values("correlation = [['reduced.mu_fast', 'load.vertical_kN', -0.5]]\n")), -0.5, 0.05);
}

TEST(Sweep, ErrorsNameFileLineAndWhatIsWrong) {
  const auto refused = [](const char *text, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { parse_sweep(text, "s.toml"); }, words);
  };
  refused("[grid]\nreduced.mu_fst = [0.1]\n", {"s.toml:2:", "mu_fst", "did you mean \"mu_fast\""});
  refused("[grid]\nreduced.mu_fast = [0.1, 'much']\n", {"s.toml:2:", "reduced.mu_fast", "much"});
  refused("[grid]\n\nreduced.mu_fast = [0.1,\n 3.0]\n", {"s.toml:4:", "reduced.mu_fast", "3", "2"});
  refused("[grid]\nreduced.mu_fast = []\n", {"s.toml:2:", "no values"});
  refused("[grid]\nreduced.mu_fast = 0.1\n", {"s.toml:2:", "list"});
  refused("[grid]\nreduced.mu_fast = { from = 0.1, to = 0.2 }\n", {"s.toml:2:", "count"});
  refused("[grid]\nreduced.mu_fast = { from = 0.1, to = 0.2, count = 1.5 }\n", {"s.toml:2:", "whole number"});
  refused("[grid]\nreduced.mu_fast = { from = 0.1, to = 0.2, cont = 2 }\n", {"s.toml:2:", "did you mean"});
  refused("[girds]\n", {"s.toml:1:", "girds", "grid"});
  refused("", {"s.toml", "nothing varies"});
  refused("[grid\n", {"s.toml:1:"});
  refused("[latin_hypercube]\nreduced.mu_fast = { low = 0.1, high = 0.2 }\n", {"s.toml:1:", "samples"});
  refused("[latin_hypercube]\nsamples = 5\n", {"s.toml:1:", "no key"});
  refused("[latin_hypercube]\nsamples = 0\n", {"s.toml:2:", "samples"});
  refused("[latin_hypercube]\nsamples = 5\nreduced.mu_fast = { low = 0.3, high = 0.2 }\n", {"s.toml:3:", "0.3", "0.2"});
  refused("[latin_hypercube]\nsamples = 5\nreduced.mu_fast = { low = 0.0, high = 0.2, log = true }\n",
          {"s.toml:3:", "> 0"});
  refused("[latin_hypercube]\nsamples = 5\nreduced.mu_fast = { low = 0.1, high = 3.0 }\n", {"s.toml:3:", "3"});
  const std::string two = "[latin_hypercube]\nsamples = 9\nreduced.mu_fast = { low = 0.1, high = 0.2 }\n"
                          "load.mass_kg = { low = 1e4, high = 2e4 }\ncorrelation = ";
  refused((two + "0.5\n").c_str(), {"s.toml:5:", "list"});
  refused((two + "[['reduced.mu_fast', 'load.mas_kg', 0.5]]\n").c_str(), {"s.toml:5:", "load.mas_kg", "not sampled"});
  refused((two + "[['reduced.mu_fast', 'load.mass_kg', 1.0]]\n").c_str(), {"s.toml:5:", "between -1 and 1"});
  refused((two + "[['reduced.mu_fast', 'reduced.mu_fast', 0.5]]\n").c_str(), {"s.toml:5:", "once"});
  refused("[latin_hypercube]\nsamples = 1\nreduced.mu_fast = { low = 0.1, high = 0.2 }\ncorrelation = []\n",
          {"s.toml:4:", "more samples"});
  refused("[grid]\nreduced.mu_fast = [0.1]\n[linked]\nreduced.mu_slow = { product = ['reduced.mu'] }\n",
          {"s.toml:4:", "reduced.mu"});
  refused("[grid]\nreduced.mu_fast = [1.9]\n[linked]\nreduced.mu_slow = { product = [2, 'reduced.mu_fast'] }\n",
          {"s.toml:4:", "reduced.mu_slow", "3.8"});
  refused("[grid]\nreduced.mu_fast = [0.1]\n[linked]\nreduced.mu_fast = { product = [1] }\n",
          {"s.toml:4:", "more than one part"});
  refused("[[case]]\nreduced.mu_fast = 0.1\n[[case]]\nreduced.mu_slow = 0.1\n", {"s.toml:3:", "same keys"});
  refused("[grid]\nvariable.a = {from=1,to=2,count=200000}\nvariable.b = [1, 2]\n", {"s.toml", "200000 runs"});
}

TEST(Sweep, ArgumentsAreTheGridOfAFile) {
  const Sweep s = grid_of_arguments({"excitation.scale=0.5:1.4:4", "reduced.mu_fast=0.05:0.05:1"});
  const Sweep same = parse_sweep("[grid]\nexcitation.scale = {from = 0.5, to = 1.4, count = 4}\n"
                                 "reduced.mu_fast = [0.05]\n",
                                 "s.toml");
  ASSERT_EQ(s.runs.size(), 4u);
  EXPECT_EQ(s.keys, same.keys);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(s.assignments(i), same.assignments(i));
  EXPECT_EQ(number(s, 0, "excitation.scale"), 0.5);
  EXPECT_DOUBLE_EQ(number(s, 1, "excitation.scale"), 0.8);
  EXPECT_EQ(number(s, 3, "excitation.scale"), 1.4);
}

TEST(Sweep, ArgumentsAreRefusedByName) {
  const auto refused = [](const std::vector<std::string> &arguments, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { grid_of_arguments(arguments); }, words);
  };
  refused({"excitation.scal=1:2:3"}, {"--sweep excitation.scal=1:2:3", "did you mean \"scale\""});
  refused({"reduced.mu_fast=0.1:3:2"}, {"--sweep reduced.mu_fast=0.1:3:2", "3", "2"});
  for (const char *bad : {"=1:2:3", "excitation.scale=1:2", "excitation.scale=1:2:3:4", "excitation.scale=a:2:3",
                          "excitation.scale=1:nan:3", "excitation.scale"})
    refused({bad}, {bad, "KEY=a:b:n"});
  refused({"excitation.scale=1:2:0"}, {"n 0", "whole number"});
  refused({"excitation.scale=1:2:2.5"}, {"n 2.5", "whole number"});
  refused({"excitation.scale=1:2:1"}, {"1", "2 or more"});
  refused({"excitation.scale=1:2:2", "excitation.scale=3:4:2"}, {"more than one part"});
}
