// hard_cases_double_concave [--baseline FILE] [--write FILE]: the table of hard cases of the DCFP and
// LIR-DCFP models, on standard output. Exit 1: a row that must be right is not, or the table differs from the
// baseline by 1 %.
#include "reduced_models/simulate.h"
#include "tests/reduced_models/rigid_body/scenes.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <sstream>

using namespace rimpact;
using namespace rimpact::reduced::testing;

namespace {

struct Case {
  std::string name;
  scene::Scene scene;
  bool must_be_right = true; ///< false: must end as `status` says
  RunStatus status = RunStatus::done;
  std::string fact = {}; ///< a number that has to stay below the bound
  std::function<double(const reduced::ReducedRun &)> deviation = {};
  double bound = 0;
  double force_bound = 0.01; ///< of the peak force against a finer step
};

/// Fine enough for 1 % of every case.
scene::Scene finer(scene::Scene s) {
  s.isolator.step_tolerance = std::min(s.isolator.step_tolerance, 1e-5);
  return s;
}
scene::Scene in_space(scene::ModelKind model, int points, double direction_deg) {
  scene::Scene s = shaken(model, 0.4);
  s.isolator.space = scene::Space::spatial, s.isolator.points = points;
  s.excitation.direction_deg = direction_deg, s.excitation.duration = 4.5; // past the second impact
  return s;
}
scene::Scene near_interface(double mu) {
  scene::Scene s = shaken(scene::ModelKind::lir_dcfp, 0.4);
  s.isolator.mu_interface = mu;
  return s;
}
scene::Scene with_frame(double post_yield) {
  scene::Scene s = shaken(scene::ModelKind::lir_dcfp, 0.5);
  s.superstructure.kind = scene::StructureKind::bouc_wen, s.superstructure.mass_ratio = 0.7,
  s.superstructure.post_yield = post_yield;
  s.superstructure.yield = 0.005;
  return s;
}

/// Largest relative difference of peak displacement and force from the same scene otherwise.
std::function<double(const reduced::ReducedRun &)> against(const scene::Scene &other) {
  return [other](const reduced::ReducedRun &run) {
    const auto o = reduced::simulate(finer(other)).summary;
    return std::max(std::abs(run.summary.peak_displacement / o.peak_displacement - 1),
                    std::abs(run.summary.peak_lateral_force / o.peak_lateral_force - 1));
  };
}
double least_point_force(const reduced::ReducedRun &run) {
  double least = 1e300;
  for (const auto &point : run.summary.extra["isolator"]["point_forces"])
    least = std::min(least, point["min_N"].get<double>());
  return least;
}
double gap_left(const reduced::ReducedRun &run, double gap) {
  double largest = 0;
  for (const double slip : run.response.series("interface_slip_x")) largest = std::max(largest, std::abs(slip));
  return gap - largest; // below zero: pressed into the stop
}

std::vector<Case> cases() {
  const auto gap_exceeded = shaken(scene::ModelKind::lir_dcfp, 0.6);
  const double gap = gap_exceeded.isolator.gap();
  const auto printed = near_interface(0.0528);
  return {{"gap exceeded", gap_exceeded, true, RunStatus::done, "gap left [m]",
           [gap](const auto &run) { return std::max(0.0, gap_left(run, gap)); }, 0},
          {"one point lifted", slender(0.4, 0.1), true, RunStatus::done, "least N of a point", least_point_force, 0},
          {"45 degrees, DCFP, circle", in_space(scene::ModelKind::dcfp, 8, 45), true, RunStatus::done, "off 0 degrees",
           against(in_space(scene::ModelKind::dcfp, 8, 0)), 0.01},
          {"45 degrees, LIR, circle", in_space(scene::ModelKind::lir_dcfp, 8, 45), true, RunStatus::done,
           "off 0 degrees", against(in_space(scene::ModelKind::lir_dcfp, 8, 0)), 0.01},
          {"30 degrees, LIR, 8 points", in_space(scene::ModelKind::lir_dcfp, 8, 30), true, RunStatus::done,
           "off 16 points", against(in_space(scene::ModelKind::lir_dcfp, 16, 30)), 0.01},
          {"vertical acceleration > g", lifted(), true, RunStatus::done, "least N",
           [](const auto &run) { return *run.summary.min_normal_force; }, 0, 0.03}, // its peak is a landing's spike
          {"mu_s = mu_e - 0.001", near_interface(0.0518)},
          {"mu_s = mu_e", printed},
          {"mu_s = mu_e + 0.001", near_interface(0.0538)},
          {"inelastic frame above", with_frame(0.05)},
          {"softening frame above", with_frame(-0.1), false, RunStatus::stopped},
          {"overturned", slender(0.8, 0.1), false, RunStatus::stopped},
          {"low rim left", slender(1.5, 1e-4), false, RunStatus::stopped}};
}

std::string judge(const Case &hard, std::vector<std::string> &failures) {
  scene::Scene tight = finer(hard.scene);
  const auto run = reduced::simulate(tight);
  const auto &s = run.summary;
  tight.isolator.step_tolerance /= 30;
  const auto exact = hard.must_be_right ? reduced::simulate(tight).summary : s;
  const double off_u = std::abs(s.peak_displacement / exact.peak_displacement - 1),
               off_F = std::abs(s.peak_lateral_force / exact.peak_lateral_force - 1),
               energy = std::abs(s.energy->imbalance_relative());
  const auto require = [&](bool right, const std::string &what) {
    if (!right) failures.push_back(hard.name + ": " + what);
  };
  std::string text = fmt::format("{:<28} {:>8} {:>4} {:>9.1f} {:>9.0f} | {:8.1e} {:8.1e} {:8.1e}",
                                 hard.name + (hard.must_be_right ? " *" : ""), word(s.status), s.impacts.size(),
                                 1e3 * s.peak_displacement, 1e-3 * s.peak_lateral_force, off_u, off_F, energy);
  require(s.status == hard.status, "status " + word(s.status));
  require(s.status == RunStatus::done || !s.reason.empty(), "no reason given");
  if (hard.must_be_right) {
    require(off_u <= 0.01 && off_F <= hard.force_bound,
            fmt::format("off a finer step by {:.1e}, {:.1e}", off_u, off_F));
    require(energy <= 1e-4, fmt::format("imbalance {:.1e}", energy));
  }
  if (hard.deviation) {
    const double value = hard.deviation(run);
    text += fmt::format("  {} {:.1e}", hard.fact, value);
    require(value <= hard.bound, fmt::format("{} {:.1e}", hard.fact, value));
  }
  return text + (s.reason.empty() ? "\n" : "  " + s.reason + "\n");
}

/// Left of '|': words equal, numbers within 1 % (and one in the last digit).
bool same(const std::string &a, const std::string &b) {
  std::istringstream x(a.substr(0, a.find('|'))), y(b.substr(0, b.find('|')));
  for (std::string p, q; x >> p;) {
    if (!(y >> q)) return false;
    char *end_p, *end_q;
    const double u = std::strtod(p.c_str(), &end_p), v = std::strtod(q.c_str(), &end_q);
    if (*end_p || *end_q ? p != q : std::abs(u - v) > 1e-2 * std::abs(v) + 0.11) return false;
  }
  return true;
}

} // namespace

int main(int argc, char **argv) {
  std::string baseline, written, table;
  for (int i = 1; i + 1 < argc; i += 2) (std::string(argv[i]) == "--write" ? written : baseline) = argv[i + 1];
  const std::string header =
      "# Hard cases of the double concave models; rows with * must be right. Made by "
      "hard_cases_double_concave.\n"
      "# off: of peak displacement and lateral force against a 30 times finer step tolerance; energy: "
      "imbalance.\n"
      "# case                         status hits   peak mm   peak kN |   off mm   off kN   energy\n";
  std::vector<std::string> failures, rows;
  for (const auto &hard : cases()) rows.push_back(judge(hard, failures)), table += rows.back();
  fmt::print("{}{}", header, table);
  if (!written.empty()) std::ofstream(written) << header << table;
  if (!baseline.empty()) {
    std::ifstream file(baseline);
    std::size_t i = 0;
    for (std::string line; std::getline(file, line);) {
      if (line.empty() || line[0] == '#') continue;
      if (i >= rows.size() || !same(rows[i], line)) failures.push_back("baseline has: " + line);
      ++i;
    }
    if (i != rows.size()) failures.push_back("the baseline's length");
  }
  for (const auto &what : failures) fmt::print("FAILED {}\n", what);
  return failures.empty() ? 0 : 1;
}
