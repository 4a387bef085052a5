// bench_work_precision FOLDER [RECORDS]: our stepper and plain CVODE on a pulse and on a bidirectional
// record. Writes FOLDER/NAME.json (the problem, for peers in other languages), FOLDER/NAME-rows.json (times,
// errors) and FOLDER/NAME-reference.json; work_precision.py makes the table.
#include "problem.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace rimpact;
using work_precision::Problem, work_precision::Solution;

namespace {

/// Displacements at the output instants; NaN where the run stored none there (denser samples, in contact).
Solution own(scene::Scene s, double tolerance) {
  s.reduced.tolerance = tolerance;
  const auto run = reduced::simulate(s);
  const auto &r = run.response;
  const std::size_t n = static_cast<std::size_t>(std::lround(s.excitation.duration / s.reduced.output_step)) + 1;
  Solution solution{std::vector<double>(n, std::nan("")), std::vector<double>(n, std::nan("")), 0};
  const auto &t = r.series("time");
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double k = std::round(t[i] / s.reduced.output_step);
    if (std::abs(t[i] - k * s.reduced.output_step) > 1e-9) continue;
    solution.x[static_cast<std::size_t>(k)] = r.series("displacement_x")[i];
    solution.y[static_cast<std::size_t>(k)] = r.series("displacement_y")[i];
  }
  const std::clock_t begin = std::clock(); // processor time: other work on the machine does not count
  constexpr int n_repeats = 10;
  for (int i = 0; i < n_repeats; ++i) reduced::simulate_summary(s);
  solution.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / n_repeats;
  return solution;
}

/// Largest distance over the largest displacement.
double error(const Solution &a, const Solution &b) {
  double off = 0, peak = 0;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    const double here = std::hypot(a.x[i] - b.x[i], a.y[i] - b.y[i]);
    if (std::isnan(here)) continue;
    off = std::max(off, here), peak = std::max(peak, std::hypot(b.x[i], b.y[i]));
  }
  return off / peak;
}

void compare(const std::string &folder, const std::string &name, scene::Scene coulomb) {
  scene::Scene park_wen = coulomb;
  park_wen.reduced.friction = scene::Friction::park_wen;
  const Problem problem(name, park_wen);
  nlohmann::json rows;
  const auto add = [&](const char *program, double tolerance, const Solution &s, const Solution &reference) {
    rows.push_back(
        {{"program", program}, {"tolerance", tolerance}, {"seconds", s.seconds}, {"error", error(s, reference)}});
  };
  const Solution exact = own(coulomb, 1e-13), smooth = own(park_wen, 1e-12);
  for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
    add("rimpact, Coulomb", tolerance, own(coulomb, tolerance), exact);
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-8})
    add("rimpact, Park-Wen", tolerance, own(park_wen, tolerance), smooth);
  for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-10})
    add("plain CVODE, Park-Wen", tolerance, work_precision::plain_cvode(problem, tolerance), smooth);
  const auto write = [&](const std::string &what, const nlohmann::json &json) {
    std::ofstream(folder + "/" + name + what + ".json") << json;
  };
  write("", problem.to_json());
  write("-rows", rows);
  write("-reference", {{"x", smooth.x}, {"y", smooth.y}}); // NaN becomes null
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 2) return std::cerr << "bench_work_precision FOLDER [RECORDS]\n", 2;
  std::filesystem::create_directories(argv[1]);
  scene::Scene pulse; // 0.78 g, 1.0 s
  pulse.excitation.scale = 1.05, pulse.excitation.duration = 12;
  compare(argv[1], "pulse", pulse);
  const std::string records = argc > 2 ? argv[2] : "";
  if (!std::filesystem::exists(records + "/RSN1086_NORTHR_SYL360.AT2"))
    return std::cout << "no records in \"" << records << "\": the bidirectional record is left out\n", 0;
  compare(argv[1], "record",
          scene::parse_scene("[excitation]\nkind = 'record'\nduration_s = 40\nscale = 0.86\n"
                             "x = 'RSN1086_NORTHR_SYL360.AT2'\ny = 'RSN1086_NORTHR_SYL090.AT2'\n",
                             "record", {}, records));
}
