// How often the 95 % intervals of measured impacts hold the truth, and what is left of it on average: a table of cells
// (law, noise of the displacement, rate, noise of the force), each with so many seeds. Seeds are 1..n, so that it can
// be made again; coverage.txt holds what it gave. A cell is good where every parameter is. A parameter is where its
// intervals cover 90 to 99 % and its bias is below a third of the stated error. So it is where the verdict says for
// most seeds that the data do not tell. Wide: more than 99 % are covered.
//   calibration_coverage [--seeds N] [--starts N] [--only WORD] [--all] [--table FILE]
// --starts 0: from the truth alone, which tells the valley's width and not whether it is found.
// Without --all a few cells, with a margin for few seeds. --table keeps finished cells, so that an interrupted run goes
// on.
#include "calibration/fit/fit.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include "measured_synthetic.h"
#include <chrono>
#include <cstdio>
#include <fstream>
#include <set>
#include <string>

namespace {
using namespace rimpact;
using namespace rimpact::calibration;
namespace testing = rimpact::calibration::testing;

struct Cell {
  std::string law;
  double displacement_mm, rate_Hz, force_percent;
  bool pulse = false; ///< two Ricker histories instead of two windows at 0.2 and 0.4 m/s
  bool two = false;   ///< the law's first two parameters alone are fitted, the others held at the truth
  std::string name() const {
    return fmt::format("{:<15} {:<8} {:>5g} mm {:>5g} Hz {:>2g} %", law,
                       pulse ? "pulse"
                       : two ? "two"
                             : "windows",
                       displacement_mm, rate_Hz, force_percent);
  }
};

std::vector<Cell> all_cells() {
  std::vector<Cell> cells;
  for (const char *law : {"no-tension", "hunt-crossley", "elastoplastic", "signed"})
    for (const double mm : {0.001, 0.005, 0.02, 0.1})
      for (const double rate : {1000.0, 5000.0})
        for (const double force : {0.0, 2.0, 5.0}) cells.push_back({law, mm, rate, force});
  for (const char *law : {"no-tension", "hunt-crossley"})
    for (const double force : {2.0, 5.0})
      for (const double rate : {1000.0, 5000.0}) cells.push_back({law, 0.02, rate, force, true});
  return cells;
}

std::vector<Cell> few_cells() {
  return {{"no-tension", 0.02, 1000, 2},       {"no-tension", 0.02, 5000, 0},
          {"hunt-crossley", 0.02, 1000, 5},    {"signed", 0.02, 1000, 5},
          {"no-tension", 0.02, 1000, 2, true}, {"elastoplastic", 0.02, 1000, 2, false, true}};
}

/// What the records are made with; a fit reports in the parameters' own units.
void set_truth(rimpact::scene::Scene &s, const std::string &law) {
  s.reduced.impact_law = &laws::impact_law(law);
  s.reduced.k_i = 3e8, s.reduced.restitution = 0.55, s.reduced.impact_exponent = 1.5;
  if (law != "elastoplastic") return;
  s.reduced.k_i = 6e8, s.reduced.yield_force = 0.6e6, s.reduced.hardening = 0.15, s.reduced.unloading_gain = 0.3;
}

struct Tally {
  double truth = 0;
  int n = 0, told = 0, inside = 0, inside_all = 0, failed = 0;
  double sum = 0, square = 0, stated = 0; ///< of relative errors of those told, found and stated
};

std::map<std::string, Tally> run_cell(const Cell &cell, int n_seeds, int n_starts,
                                      std::map<std::string, int> &counting) {
  const testing::Instruments instruments{.rate = cell.rate_Hz,
                                         .displacement = 1e-3 * cell.displacement_mm,
                                         .force = 0.01 * cell.force_percent,
                                         .before = cell.pulse ? 0.2 : 0.01};
  std::vector<rimpact::scene::Scene> scenes;
  if (cell.pulse)
    scenes = {testing::ricker(1.10), testing::ricker(1.10, 3e8, 0.4, 0.38, 1.5)};
  else
    scenes = {testing::window(0.2), testing::window(0.4)};
  for (auto &s : scenes) set_truth(s, cell.law);
  FitOptions options;
  options.parameters = rimpact::laws::impact_law(cell.law).parameters;
  if (cell.two) options.parameters.resize(2);
  options.n_starts = n_starts >= 0                              ? n_starts
                     : cell.law == "elastoplastic" && !cell.two ? FitOptions().n_starts
                                                                : 1; // four parameters have several valleys
  std::map<std::string, Tally> tallies;
  for (const auto &name : options.parameters) tallies[name].truth = parameter(name).get(scenes[0]) / parameter(name).si;
  if (n_starts == 0)
    for (const auto &[name, t] : tallies) options.start[name] = t.truth;
  for (int seed = 1; seed <= n_seeds; ++seed) {
    std::vector<StoredRun> runs;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      runs.push_back(
          testing::measured(scenes[i], instruments, 100003u * static_cast<unsigned>(i) + static_cast<unsigned>(seed)));
    for (auto &run : runs) { // their own settings must not help
      run.scene.reduced.k_i = 4.5e8, run.scene.reduced.restitution = 0.65, run.scene.reduced.impact_exponent = 1.2;
      if (!cell.two)
        run.scene.reduced.yield_force = 1e6, run.scene.reduced.hardening = 0.05, run.scene.reduced.unloading_gain = 0;
    }
    std::optional<FitResult> result;
    try {
      result = fit({&runs[0], &runs[1]}, options);
      ++counting[result->counting == SampleWeighting::sample ? "sample" : "curve"];
    } catch (const rimpact::Error &error) {
      ++counting[std::string("failed: ") + error.what()];
    }
    for (auto &[name, t] : tallies) {
      ++t.n;
      if (!result) {
        ++t.failed;
        continue;
      }
      const auto &e = result->parameters.at(name);
      const bool inside = e.interval_low <= t.truth && t.truth <= e.interval_high;
      t.inside_all += inside;
      if (!e.identifiable) continue;
      const double error = e.value / t.truth - 1;
      ++t.told, t.inside += inside, t.sum += error, t.square += error * error,
          t.stated += std::pow(e.standard_error / t.truth, 2);
    }
  }
  return tallies;
}

/// Wide: intervals that cover more than 99 %, on the safe side. `margin`: standard errors that so few seeds may be off
/// by.
enum class Grade { good, wide, bad };
Grade grade(const Tally &t, double margin) {
  if (t.failed > 0) return Grade::bad;
  if (2 * t.told < t.n) return Grade::good; // the verdict says that the data do not tell
  const double n = t.told, share = t.inside / n, bias = t.sum / n, stated = std::sqrt(t.stated / n),
               found = std::sqrt(t.square / n);
  const double slack = margin * std::sqrt(0.95 * 0.05 / n);
  if (share < 0.90 - slack || std::abs(bias) > stated / 3 + margin * found / std::sqrt(n)) return Grade::bad;
  return share <= 0.99 || margin > 0 ? Grade::good : Grade::wide;
}

/// Names of the cells a table holds.
std::set<std::string> finished(const std::string &path) {
  std::set<std::string> names;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (const auto end = line.find(" | "); end != std::string::npos) names.insert(line.substr(0, end));
  return names;
}

} // namespace

int main(int argc, char **argv) {
  int n_seeds = 40, n_starts = -1;
  bool all = false;
  std::string only, table;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--all") all = true;
    if (i + 1 == argc) break;
    if (word == "--seeds") n_seeds = std::stoi(argv[i + 1]);
    if (word == "--starts") n_starts = std::stoi(argv[i + 1]);
    if (word == "--only") only = argv[i + 1];
    if (word == "--table") table = argv[i + 1];
  }
  const auto done = table.empty() ? std::set<std::string>() : finished(table);
  bool everything = true;
  for (const Cell &cell : all ? all_cells() : few_cells()) {
    const std::string name = cell.name();
    if ((!only.empty() && name.find(only) == std::string::npos) || done.count(name)) continue;
    const auto begin = std::chrono::steady_clock::now();
    std::map<std::string, int> counting;
    const auto tallies = run_cell(cell, n_seeds, n_starts, counting);
    std::string line = name + " |";
    Grade cell_grade = Grade::good;
    for (const auto &[parameter, t] : tallies) {
      const double n = std::max(t.told, 1);
      cell_grade = std::max(cell_grade, grade(t, all ? 0 : 3));
      line += fmt::format(" {} told {:.0f} covered {:.1f} ({:.1f}) bias {:+.2f} found {:.2f} stated {:.2f} |",
                          parameter, 100.0 * t.told / t.n, 100 * t.inside / n, 100.0 * t.inside_all / t.n,
                          100 * t.sum / n, 100 * std::sqrt(t.square / n), 100 * std::sqrt(t.stated / n));
    }
    everything = everything && cell_grade != Grade::bad;
    line += cell_grade == Grade::good ? " good" : cell_grade == Grade::wide ? " wide" : " BAD";
    std::printf("%s", line.c_str());
    for (const auto &[what, n] : counting) std::printf(" %s %d", what.c_str(), n);
    std::printf(" %.1f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    std::fflush(stdout);
    if (!table.empty()) std::ofstream(table, std::ios::app) << line << "\n";
  }
  return everything ? 0 : 1;
}
