#include "scene/flow_curve.h"

#include "io/files/file.h"
#include "io/files/require.h"
#include "io/files/table_lines.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::scene {
namespace {

constexpr std::size_t most_rows = 1000; // written out in scene.toml
constexpr double MPa = 1e6;
constexpr double least_step = 1e-6; // of plastic strain between rows: none is a jump

using Row = std::array<double, 2>;

/// Throws InputError where the rows are not those of a flow stress. `first`: number of the first one in the file.
void check_rows(const std::vector<Row> &rows, std::size_t first) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto &[strain, stress] = rows[i];
    require(stress > 0, "curve, row {}: a stress of {:g} MPa must be > 0", first + i, stress / MPa);
    if (i == 0) continue;
    const auto &[strain_before, stress_before] = rows[i - 1];
    require(strain - strain_before >= least_step,
            "curve, row {}: a plastic strain of {:g} does not lie beyond {:g} of the row before, by {:g} at least",
            first + i, strain, strain_before, least_step);
    require(stress >= stress_before,
            "curve, row {}: the true stress falls from {:g} to {:g} MPa; a flow stress that falls has no one answer. "
            "Where the test shows an upper yield point, give the lower one",
            first + i, stress_before / MPa, stress / MPa);
  }
}

/// Rows of a tensile test up to its largest stress, as plastic strain and true stress.
std::vector<Row> true_rows(const std::vector<Row> &test, std::size_t n, double E) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < n; ++i) {
    const double stress = test[i][1] * (1 + test[i][0]);
    rows.push_back({std::log1p(test[i][0]) - stress / E, stress});
  }
  return rows;
}

/// From the proof stress on.
FlowCurve from_tensile_test(const std::vector<Row> &test, double E) {
  constexpr double proof = 0.002; // plastic strain of the proof stress
  for (std::size_t i = 1; i < test.size(); ++i)
    require(test[i][0] > test[i - 1][0], "curve, row {}: a strain of {:g} does not lie beyond {:g} of the row before",
            i + 1, test[i][0], test[i - 1][0]);
  const auto largest =
      std::max_element(test.begin(), test.end(), [](const Row &a, const Row &b) { return a[1] < b[1]; });
  const auto n = static_cast<std::size_t>(largest - test.begin()) + 1;
  const std::vector<Row> rows = true_rows(test, n, E);
  const auto beyond = std::find_if(rows.begin(), rows.end(), [](const Row &row) { return row[0] >= proof; });
  require(beyond != rows.end(),
          "curve: no row up to the largest stress, {:g} MPa, strains by more than 0.2 % beyond elasticity (E_MPa {:g})",
          (*largest)[1] / MPa, E / MPa);
  double yield = (*beyond)[1];
  if (beyond != rows.begin()) {
    const Row &before = beyond[-1];
    yield = before[1] + (yield - before[1]) * (proof - before[0]) / ((*beyond)[0] - before[0]);
  }
  FlowCurve curve{{{0.0, yield}}};
  for (auto row = beyond; row != rows.end(); ++row)
    if ((*row)[1] != yield || (*row)[0] > proof) curve.rows.push_back(*row);
  check_rows(curve.rows, static_cast<std::size_t>(beyond - rows.begin()));
  curve.n_cut = test.size() - n;
  if (curve.n_cut > 0) curve.necks_at = (*largest)[0];
  return curve;
}

Row row_in(std::string_view line, const std::string &where) {
  const auto cells = split(line, ',');
  if (cells.size() != 2) throw DataError(fmt::format("{}: {} of 2 columns", where, cells.size()));
  Row row{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double value = finite_number(cells[i], where);
    if (value < 0) throw DataError(fmt::format("{}: {:g} must be >= 0", where, value));
    row[i] = i == 0 ? value : value * MPa;
  }
  return row;
}

} // namespace

FlowCurve flow_curve(const Material &material) {
  const auto &rows = material.hardening.curve.values;
  require(rows.size() >= 2, "curve has {} rows; it needs at least 2, or a CSV file's name", rows.size());
  require(rows.size() <= most_rows, "curve has {} rows; it has at most {}", rows.size(), most_rows);
  if (material.hardening.curve_kind == CurveKind::engineering) return from_tensile_test(rows, material.E);
  require(rows[0][0] == 0, "curve, row 1: a plastic strain of {:g}; the first must be 0, where the steel yields",
          rows[0][0]);
  check_rows(rows, 1);
  return {rows};
}

std::optional<double> yield_of_curve(const Material &material) {
  const Hardening &h = material.hardening;
  if (h.law == HardeningLaw::table) return flow_curve(material).rows.front()[1];
  if (h.law == HardeningLaw::swift) return h.K * std::pow(h.e0, h.n);
  return {};
}

void check_hardening(const std::string &name, const Material &material) {
  const Hardening &h = material.hardening;
  const auto &backstress = h.chaboche;
  require(backstress.file.empty(),
          "material.{}.chaboche \"{}\" must be rows [C in MPa, gamma]; it is read from no file", name,
          backstress.file.substr(0, 60));
  require(backstress.values.size() <= most_backstresses, "material.{}.chaboche has {} rows; it has at most {}", name,
          backstress.values.size(), most_backstresses);
  std::vector<std::string> missing;
  const auto need = [&](double value, const char *key) {
    if (!(value > 0)) missing.emplace_back(key);
  };
  switch (h.law) {
  case HardeningLaw::bilinear:
    return;
  case HardeningLaw::table:
    flow_curve(material);
    return;
  case HardeningLaw::swift:
    need(h.K, "hardening_K_MPa"), need(h.e0, "hardening_e0"), need(h.n, "hardening_n");
    break;
  case HardeningLaw::voce:
    need(h.Q, "hardening_Q_MPa"), need(h.b, "hardening_b");
    break;
  case HardeningLaw::ludwik:
    need(h.K, "hardening_K_MPa"), need(h.n, "hardening_n");
    break;
  }
  require(missing.empty(), "material.{}.hardening \"{}\", {}, needs {}", name, word(h.law), description(h.law),
          fmt::join(missing, " and "));
}

std::vector<std::array<double, 2>> read_curve(const std::string &path, CurveKind kind) {
  const std::string_view header =
      kind == CurveKind::engineering ? "strain,stress_MPa" : "plastic_strain,true_stress_MPa";
  std::vector<Row> rows;
  bool headed = false;
  const std::string text = read_file(path);
  for (const auto &[line, where] : table_lines(text, path)) {
    if (headed) {
      rows.push_back(row_in(line, where));
      continue;
    }
    if (trim(line) != header)
      throw DataError(fmt::format("{}: the header \"{}\" must be \"{}\" where curve_kind is \"{}\"", where,
                                  trim(line).substr(0, 60), header, word(kind)));
    headed = true;
  }
  if (!headed) throw DataError(fmt::format("{}: holds no header line, \"{}\"", path, header));
  if (rows.size() > most_rows)
    throw DataError(fmt::format("{}: {} rows; a curve has at most {}", path, rows.size(), most_rows));
  return rows;
}

} // namespace rimpact::scene
