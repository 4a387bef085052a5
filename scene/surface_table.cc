#include "scene/surface_table.h"

#include "io/files/file.h"
#include "io/files/require.h"
#include "io/files/table_lines.h"
#include "io/files/text.h"
#include "scene/surface_of_revolution.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Second derivatives at the knots of the spline with h'(0) = 0 and a last knot that is none (Thomas's
/// algorithm).
std::vector<double> second_derivatives(const std::vector<double> &x, const std::vector<double> &z) {
  const std::size_t n = x.size() - 1; // pieces
  std::vector<double> diagonal(n), upper(n), right(n), m(n + 1);
  const auto step = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto chord = [&](std::size_t i) { return (z[i + 1] - z[i]) / step(i); };
  const double ratio = step(n - 1) / step(n - 2); // m[n] = (1 + ratio) m[n-1] - ratio m[n-2]
  diagonal[0] = 2 * step(0), upper[0] = step(0), right[0] = 6 * chord(0);
  for (std::size_t i = 1; i < n; ++i) {
    double lower = step(i - 1);
    diagonal[i] = 2 * (step(i - 1) + step(i)), upper[i] = step(i), right[i] = 6 * (chord(i) - chord(i - 1));
    if (i == n - 1) diagonal[i] += (1 + ratio) * step(i), lower -= ratio * step(i), upper[i] = 0;
    const double factor = lower / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1], right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) m[i] = (right[i] - (i + 1 < n ? upper[i] * m[i + 1] : 0.0)) / diagonal[i];
  m[n] = (1 + ratio) * m[n - 1] - ratio * m[n - 2];
  return m;
}

class Table final : public SurfaceOfRevolution {
public:
  Table(const std::vector<double> &radius, const std::vector<double> &height)
      : radius_(radius), height_(height), second_(second_derivatives(radius, height)) {}

  MeridianPoint meridian(double r) const override {
    const auto above = std::upper_bound(radius_.begin() + 1, radius_.end() - 1, r);
    const auto i = static_cast<std::size_t>(above - radius_.begin() - 1);
    const double h = radius_[i + 1] - radius_[i], s = r - radius_[i];
    const double third = (second_[i + 1] - second_[i]) / h;
    const double slope = i == 0 ? 0.0 : (height_[i + 1] - height_[i]) / h - h * (2 * second_[i] + second_[i + 1]) / 6;
    const double second = second_[i] + third * s;
    const double height = height_[i] + s * (slope + s * (second_[i] / 2 + s * third / 6));
    // In the first piece h'/r needs no division: h' = m0 r + third r^2 / 2.
    const double over_radius = i == 0 ? second_[0] + third * r / 2 : (slope + s * (second_[i] + s * third / 2)) / r;
    return {height, over_radius, second};
  }
  double limit_radius() const override { return radius_.back(); }

private:
  std::vector<double> radius_, height_, second_;
};

} // namespace

std::unique_ptr<SlidingSurface> make_table(const SurfaceSpec &spec) {
  const auto &r = spec.table_radius, &z = spec.table_height;
  require(r.size() >= 4, "surface.radius_mm holds {} radii; a table needs at least 4 rows (or surface.file)", r.size());
  require(z.size() == r.size(), "surface.height_mm holds {} heights for the {} radii of surface.radius_mm", z.size(),
          r.size());
  require(r.front() == 0 && z.front() == 0,
          "surface.radius_mm starts at {} mm with a height of {} mm; both must be 0: the vertex is the origin",
          1e3 * r.front(), 1e3 * z.front());
  for (std::size_t i = 1; i < r.size(); ++i)
    require(r[i] > r[i - 1], "surface.radius_mm: row {} at {:.6g} mm does not lie beyond row {} at {:.6g} mm", i + 1,
            1e3 * r[i], i, 1e3 * r[i - 1]);
  return std::make_unique<Table>(r, z);
}

void read_surface_table(const std::string &path, SurfaceSpec &spec) {
  spec.table_radius.clear(), spec.table_height.clear();
  const std::string text = read_file(path);
  bool header = false;
  for (const auto &[line, where] : table_lines(text, path)) {
    const auto cells = split(line, ',');
    if (!header) {
      if (cells.size() != 2 || trim(cells[0]) != "radius_mm" || trim(cells[1]) != "height_mm")
        throw DataError(fmt::format("{}: the header must be \"radius_mm,height_mm\"", where));
      header = true;
      continue;
    }
    if (cells.size() != 2) throw DataError(fmt::format("{}: {} of 2 columns", where, cells.size()));
    for (const auto &cell : cells) {
      auto &column = &cell == &cells[0] ? spec.table_radius : spec.table_height;
      column.push_back(finite_number(cell, where) / 1e3);
    }
  }
  if (!header) throw DataError(fmt::format("{}: holds no header line", path));
  constexpr std::size_t most = 10000; // written out in scene.toml
  if (spec.table_radius.size() > most)
    throw DataError(fmt::format("{}: {} rows; a table has at most {}", path, spec.table_radius.size(), most));
}

} // namespace rimpact::scene
