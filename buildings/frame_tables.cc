#include "buildings/frame_tables.h"
#include "buildings/frame_source.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/table_lines.h"
#include "io/files/text.h"
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>

namespace rimpact::buildings {

namespace {
/// Columns of elements.csv that an inelastic frame has besides.
constexpr std::pair<const char *, double InelasticSection::*> inelastic_columns[] = {
    {"yield_moment_N_m", &InelasticSection::yield_moment},
    {"axial_yield_N", &InelasticSection::axial_yield},
    {"hinge_length_m", &InelasticSection::hinge_length},
    {"post_yield", &InelasticSection::post_yield},
    {"exponent", &InelasticSection::exponent},
    {"beta", &InelasticSection::beta},
    {"strength_degradation", &InelasticSection::strength_loss},
    {"stiffness_degradation", &InelasticSection::stiffness_loss}};
} // namespace

std::map<std::string, std::string> tables_of(const Frame &f) {
  std::vector<int> owner(f.nodes.size(), 0);
  std::string slabs = "diaphragm,mass_kg,x_m,y_m,inertia_kg_m2,damping_ratio\n",
              nodes = "node,x_m,y_m,z_m,diaphragm,vertical_mass_kg,bearing\n",
              elements = "element,i,j,E_Pa,G_Pa,A_m2,Iy_m4,Iz_m4,J_m4,Asy_m2,Asz_m2,up_x,up_y,up_z";
  if (f.inelastic())
    for (const auto &[column, member] : inelastic_columns) elements += fmt::format(",{}", column);
  elements += f.inelastic() ? ",load_N_per_m\n" : "\n";
  for (std::size_t d = 0; d < f.diaphragms.size(); ++d) {
    const auto &s = f.diaphragms[d];
    for (const int node : s.nodes) owner[node] = static_cast<int>(d) + 1;
    slabs += fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", d + 1, s.mass, s.centre.x(), s.centre.y(),
                         s.inertia, f.damping_ratio);
  }
  for (std::size_t i = 0; i < f.nodes.size(); ++i) {
    const auto &n = f.nodes[i];
    nodes += fmt::format("{},{:.17g},{:.17g},{:.17g},{},{:.17g},{}\n", i + 1, n.at.x(), n.at.y(), n.at.z(), owner[i],
                         n.vertical_mass, n.supported ? n.bearing.empty() ? "1" : n.bearing : "0");
  }
  for (std::size_t e = 0; e < f.elements.size(); ++e) {
    const auto &m = f.elements[e];
    const auto &s = f.sections[m.section];
    elements += fmt::format("{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{}", e + 1,
                            m.i + 1, m.j + 1, s.E, s.G, s.area, s.Iy, s.Iz, s.torsion, s.shear_y, s.shear_z, m.up.x(),
                            m.up.y(), m.up.z());
    if (s.inelastic) {
      for (const auto &[column, member] : inelastic_columns) elements += fmt::format(",{:.17g}", *s.inelastic.*member);
      elements += fmt::format(",{:.17g}", m.load);
    }
    elements += "\n";
  }
  return {{"nodes.csv", nodes}, {"elements.csv", elements}, {"diaphragms.csv", slabs}};
}

void write_tables(const Frame &frame, const std::string &folder) {
  for (const auto &[name, text] : tables_of(frame)) write_atomically(text, folder + "/" + name);
}

namespace {

/// Rows of a CSV file, cells by the column's name.
class Rows {
public:
  Rows(const std::string &folder, const std::string &name) : path_(folder + "/" + name), text_(read_file(path_)) {
    for (const auto &[line, where] : table_lines(text_, path_)) {
      const auto cells = split(line, ',');
      if (columns_.empty()) {
        for (std::size_t i = 0; i < cells.size(); ++i) columns_[std::string(trim(cells[i]))] = i;
        continue;
      }
      if (cells.size() != columns_.size())
        throw DataError(fmt::format("{}: {} cells, the head has {}", where, cells.size(), columns_.size()));
      rows_.push_back({where, {cells.begin(), cells.end()}});
    }
    if (rows_.empty()) throw DataError(path_ + ": holds no rows");
  }
  std::size_t size() const { return rows_.size(); }
  bool has(const std::string &column) const { return columns_.count(column) > 0; }
  std::string text(std::size_t row, const std::string &column) const {
    const auto found = columns_.find(column);
    if (found == columns_.end()) throw DataError(fmt::format("{}: has no column {}", path_, column));
    auto cell = trim(rows_[row].cells[found->second]);
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    return std::string(cell);
  }
  double number(std::size_t row, const std::string &column) const {
    const auto cell = text(row, column);
    const auto value = to_number(cell);
    if (!value || !std::isfinite(*value))
      throw DataError(fmt::format("{}: {} is \"{}\", not a number", place(row), column, cell));
    return *value;
  }
  /// Counted from 1 in the file, from 0 here; every table numbers its rows 1, 2, ...
  int index(std::size_t row, const std::string &column) const {
    const double value = number(row, column);
    if (value != std::floor(value) || std::abs(value) > 1e9)
      throw DataError(fmt::format("{}: {} is {}, not a whole number", place(row), column, value));
    return static_cast<int>(value) - 1;
  }
  void check_number(std::size_t row, const std::string &column) const {
    if (index(row, column) != static_cast<int>(row))
      throw DataError(fmt::format("{}: {} is {}; rows are numbered 1, 2, ... in order", place(row), column,
                                  index(row, column) + 1));
  }
  const std::string &path() const { return path_; }
  const std::string &place(std::size_t row) const { return rows_[row].where; }

private:
  struct Row {
    std::string where;
    std::vector<std::string_view> cells;
  };
  std::string path_, text_;
  std::map<std::string, std::size_t> columns_;
  std::vector<Row> rows_;
};

int section_of(Frame &f, const Rows &rows, std::size_t e) {
  Section s;
  s.E = rows.number(e, "E_Pa"), s.G = rows.number(e, "G_Pa"), s.area = rows.number(e, "A_m2");
  s.Iy = rows.number(e, "Iy_m4"), s.Iz = rows.number(e, "Iz_m4"), s.torsion = rows.number(e, "J_m4");
  s.shear_y = rows.number(e, "Asy_m2"), s.shear_z = rows.number(e, "Asz_m2");
  const auto numbers = [](const Section &a) {
    return std::array{a.E, a.G, a.area, a.Iy, a.Iz, a.torsion, a.shear_y, a.shear_z};
  };
  for (const char *column : {"E_Pa", "G_Pa", "A_m2", "Iy_m4", "Iz_m4", "J_m4"})
    if (!(rows.number(e, column) > 0))
      throw DataError(fmt::format("{}: {} is {}; it must be above 0", rows.place(e), column, rows.number(e, column)));
  for (const char *column : {"Asy_m2", "Asz_m2"}) // 0: stiff in shear
    if (!(rows.number(e, column) >= 0))
      throw DataError(
          fmt::format("{}: {} is {}; it must be 0 or above", rows.place(e), column, rows.number(e, column)));
  if (rows.has(inelastic_columns[0].first)) {
    s.inelastic.emplace();
    for (const auto &[column, member] : inelastic_columns) *s.inelastic.*member = rows.number(e, column);
  }
  for (std::size_t i = 0; i < f.sections.size(); ++i)
    if (numbers(f.sections[i]) == numbers(s) && f.sections[i].inelastic == s.inelastic) return static_cast<int>(i);
  s.name = fmt::format("{} (of element {})", f.sections.size() + 1, e + 1);
  f.sections.push_back(s);
  return static_cast<int>(f.sections.size()) - 1;
}

/// A frame that contradicts itself, with the row that does.
void check(const Frame &f, const Rows &nodes, const Rows &elements, const Rows &slabs) {
  try {
    f.validate();
  } catch (const FrameFault &fault) {
    const Rows &rows = fault.part == FramePart::node ? nodes : fault.part == FramePart::element ? elements : slabs;
    throw DataError(fmt::format("{}: {}", rows.place(fault.index), fault.what()));
  } catch (const InputError &error) {
    throw DataError(fmt::format("{}: {}", nodes.path(), error.what()));
  }
}

/// One of the whole building, so every row has the same.
void take_damping(Frame &f, const Rows &slabs, std::size_t d) {
  const double ratio = slabs.number(d, "damping_ratio");
  if (!(ratio >= 0 && ratio <= 1) || (d > 0 && ratio != f.damping_ratio))
    throw DataError(fmt::format("{}: damping_ratio is {}; it must be between 0 and 1, the same in every row",
                                slabs.place(d), ratio));
  f.damping_ratio = ratio;
}

} // namespace

Frame read_tables(const std::string &folder) {
  Frame f;
  f.name = std::filesystem::path(folder).lexically_normal().filename().string();
  const Rows nodes(folder, "nodes.csv"), elements(folder, "elements.csv"), slabs(folder, "diaphragms.csv");
  for (std::size_t d = 0; d < slabs.size(); ++d) {
    slabs.check_number(d, "diaphragm");
    f.diaphragms.push_back({{},
                            slabs.number(d, "mass_kg"),
                            {slabs.number(d, "x_m"), slabs.number(d, "y_m")},
                            slabs.number(d, "inertia_kg_m2")});
    if (slabs.has("damping_ratio")) take_damping(f, slabs, d);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.check_number(i, "node");
    const std::string bearing = nodes.text(i, "bearing");
    if (bearing.empty())
      throw DataError(nodes.place(i) + ": bearing is empty; 0: none, 1: the scene's, or the name or file of another");
    const bool supported = bearing != "0";
    f.nodes.push_back({{nodes.number(i, "x_m"), nodes.number(i, "y_m"), nodes.number(i, "z_m")},
                       nodes.number(i, "vertical_mass_kg"),
                       supported,
                       bearing == "1" || !supported ? "" : bearing_named(bearing, folder)});
    const int slab = nodes.index(i, "diaphragm");
    if (slab < 0 || slab >= static_cast<int>(slabs.size()))
      throw DataError(fmt::format("{}: node {} stands in diaphragm {}; there are {}", nodes.place(i), i + 1, slab + 1,
                                  slabs.size()));
    f.diaphragms[slab].nodes.push_back(static_cast<int>(i));
  }
  for (std::size_t e = 0; e < elements.size(); ++e) {
    elements.check_number(e, "element");
    f.elements.push_back({elements.index(e, "i"),
                          elements.index(e, "j"),
                          section_of(f, elements, e),
                          {elements.number(e, "up_x"), elements.number(e, "up_y"), elements.number(e, "up_z")},
                          elements.has("load_N_per_m") ? elements.number(e, "load_N_per_m") : 0.0});
  }
  check(f, nodes, elements, slabs);
  return f;
}

} // namespace rimpact::buildings
