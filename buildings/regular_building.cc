#include "buildings/regular_building.h"
#include "buildings/builtin_buildings.h"
#include "buildings/frame_source.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::buildings {

double tributary(const std::vector<double> &lines, std::size_t i) {
  const double before = i > 0 ? lines[i] - lines[i - 1] : 0, after = i + 1 < lines.size() ? lines[i + 1] - lines[i] : 0;
  return (before + after) / 2;
}

void check_lines(const char *key, const std::vector<double> &lines) {
  if (lines.size() < 2)
    throw InputError(fmt::format("{} has {} lines; a building needs 2 at least", key, lines.size()));
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (!(lines[i] > lines[i - 1]))
      throw InputError(fmt::format("{} must grow: {} follows {}", key, lines[i], lines[i - 1]));
}

std::map<int, std::string> own_bearings(const TomlFile &file) {
  std::map<int, std::string> list;
  const auto *table = file.root()["bearings"].as_table();
  if (!table) {
    if (file.find("bearings")) throw InputError(file.location("bearings") + ": bearings must be a table, [bearings]");
    return list;
  }
  for (const auto &[key, value] : *table) {
    const auto node = to_number(key.str());
    const std::string place = file.location("bearings." + std::string(key.str()));
    if (!node || *node != std::floor(*node))
      throw InputError(fmt::format("{}: [bearings] has nodes' numbers for keys, not \"{}\"", place, key.str()));
    if (!value.is_string())
      throw InputError(fmt::format("{}: the bearing of node {} must be a name or a file", place, key.str()));
    list[static_cast<int>(*node)] =
        bearing_named(value.as_string()->get(), std::filesystem::path(file.origin()).parent_path().string());
  }
  return list;
}

namespace {
/// Shares of a level's weight on each line [-], > 0, of the sum 1: tributary ones tilted exponentially until their
/// centre stands `off` (a share of the length, -0.5 < off < 0.5) beside the middle.
std::vector<double> line_shares(const std::vector<double> &lines, double off) {
  const auto n = static_cast<Eigen::Index>(lines.size());
  const double length = lines.back() - lines[0], middle = lines[0] + length / 2;
  Eigen::ArrayXd at(n), even(n);
  for (Eigen::Index i = 0; i < n; ++i) at[i] = (lines[i] - middle) / length, even[i] = tributary(lines, i) / length;
  Eigen::ArrayXd shares = even;
  double tilt = 0;
  for (int step = 0; off != 0 && step < 100; ++step) { // its centre grows with the tilt, by its variance
    shares = even * (tilt * at).exp();
    shares /= shares.sum();
    const double centre = (shares * at).sum(), variance = (shares * at.square()).sum() - centre * centre;
    if (std::abs(off - centre) < 1e-14) break;
    tilt += std::clamp((off - centre) / variance, -2.0, 2.0);
  }
  return {shares.begin(), shares.end()};
}
} // namespace

Frame make_frame(const RegularBuilding &b) {
  check_lines("x_m", b.x);
  check_lines("y_m", b.y);
  const int nx = static_cast<int>(b.x.size()), ny = static_cast<int>(b.y.size()),
            levels = static_cast<int>(b.storeys.size()) + 1;
  const Eigen::Vector2d sides(b.x.back() - b.x[0], b.y.back() - b.y[0]);
  const double mass = b.load / b.gravity * sides.prod();
  const Eigen::Vector2d middle = Eigen::Vector2d(b.x[0], b.y[0]) + sides / 2, off = b.eccentricity.cwiseProduct(sides);
  Frame f;
  f.name = b.name, f.damping_ratio = b.damping_ratio;
  f.sections = {rectangle("column", b.column_x, b.column_y, b.E, b.nu),
                rectangle("beam", b.beam_width, b.beam_depth, b.E, b.nu)};
  f.sections[1].Iy *= b.beam_inertia_factor;
  if (!b.shear)
    for (auto &s : f.sections) s.shear_y = s.shear_z = 0;
  const auto along_x = line_shares(b.x, b.eccentricity.x()), along_y = line_shares(b.y, b.eccentricity.y());
  double z = 0;
  for (int level = 0; level < levels; ++level) {
    if (level > 0) z += b.storeys[level - 1];
    Diaphragm slab{{}, mass, middle + off, mass * sides.squaredNorm() / 12};
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int node = static_cast<int>(f.nodes.size());
        slab.nodes.push_back(node);
        f.nodes.push_back({{b.x[i], b.y[j], z}, mass * along_x[i] * along_y[j], level == 0});
        if (level > 0) f.elements.push_back({node - nx * ny, node, 0, Eigen::Vector3d::UnitY()});
        if (i > 0) f.elements.push_back({node - 1, node, 1, Eigen::Vector3d::UnitZ()});
        if (j > 0) f.elements.push_back({node - nx, node, 1, Eigen::Vector3d::UnitZ()});
      }
    f.diaphragms.push_back(slab);
  }
  for (const auto &[node, bearing] : b.bearings) {
    if (node < 1 || node > nx * ny)
      throw InputError(fmt::format("[bearings] names node {}; the building stands on nodes 1 to {}", node, nx * ny));
    f.nodes[node - 1].bearing = bearing;
  }
  return f;
}

void visit(KeyVisitor &v, RegularBuilding &b) {
  const Range size{0, 1e5, true};
  v.text({"name", "of the building"}, b.name);
  v.numbers({"x_m", "column lines along x, growing"}, b.x, si, {-1e4, 1e4});
  v.numbers({"y_m", "column lines along y, growing"}, b.y, si, {-1e4, 1e4});
  v.numbers({"storeys_m", "heights from the base up; none: a base alone"}, b.storeys, si, {0, 100, true});
  v.number({"load_kN_per_m2", "seismic weight on every level, the base too"}, b.load, kilo, positive);
  v.number({"gravity_m_per_s2", "makes masses of it"}, b.gravity, si, {0, 1e3, true});
  v.number({"E_GPa", "of the concrete"}, b.E, {1e9, false}, {0, 1e6, true});
  v.number({"nu", "of the concrete"}, b.nu, si, {0, 0.5});
  v.number({"column_x_mm", "side of a column along x"}, b.column_x, milli, size);
  v.number({"column_y_mm", "side of a column along y"}, b.column_y, milli, size);
  v.number({"beam_width_mm", "of every beam"}, b.beam_width, milli, size);
  v.number({"beam_depth_mm", "of every beam"}, b.beam_depth, milli, size);
  v.number({"beam_inertia_factor", "bending of a beam in the vertical plane over its rectangle's: the slab's flange"},
           b.beam_inertia_factor, si, {1, 10});
  v.flag({"shear", "members deform in shear (Timoshenko)"}, b.shear);
  v.pair({"eccentricity", "of every level's centre of mass and weight, shares of the plan's sides"}, b.eccentricity,
         {-0.45, 0.45});
  v.number({"damping_ratio", "of every mode with the base held"}, b.damping_ratio, si, {0, 1});
}

RegularBuilding parse_building(const std::string &text, const std::string &origin) {
  const TomlFile file(text, origin);
  TomlReader v(file, "");
  RegularBuilding b;
  visit(v, b);
  v.finish({"bearings"});
  b.bearings = own_bearings(file);
  try {
    check_lines("x_m", b.x), check_lines("y_m", b.y);
  } catch (const InputError &error) {
    const std::string sentence = error.what();
    throw InputError(fmt::format("{}: {}", file.location(sentence.substr(0, 3)), sentence));
  }
  return b;
}

RegularBuilding load_building(const std::string &where) {
  return parse_building(building_text(where), where);
}

} // namespace rimpact::buildings
