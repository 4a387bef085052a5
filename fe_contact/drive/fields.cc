// Pictures' data: VTU files of the deformed solids and their PVD index.
#include "fe_contact/drive/fields.h"

#include "fe_contact/engine/solid_fields.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>

namespace rimpact::fe {

void write_fields(const BearingSystem &system, const SystemState &state, const Eigen::VectorXd &displacements,
                  double time, const RunOptions &options, RunRecord &record, std::optional<double> direction) {
  if (!options.keeps_fields()) return;
  const Discretisation &space = system.space();
  SolidFields cells = fields_of(system.solid(), space, displacements, state.history);
  constexpr double none = std::numeric_limits<double>::quiet_NaN(); // nothing is opposite
  std::vector<double> pressure(space.n_nodes, 0.0), gap(space.n_nodes, none);
  for (std::size_t i = 0; i < state.contacts.size(); ++i)
    system.contact(i).nodal_fields(state.contacts[i], pressure, gap);
  for (double &value : pressure) value *= 1e-6;
  for (double &value : gap) value = std::isfinite(value) ? 1e3 * value : none;
  for (double &value : cells.von_mises) value *= 1e-6;
  const auto name = fmt::format("fields/{}_{:03d}.vtu", word(system.model().rung.name), record.fields.size());
  std::filesystem::create_directories(options.folder + "/fields");
  std::vector<Discretisation::Field> fields{
      {"displacement",
       3,
       false,
       {displacements.data(), displacements.data() + space.n_dofs()}}, // those of bodies stand behind
      {"contact_pressure_MPa", 1, false, pressure},
      {"gap_mm", 1, false, gap},
      {"von_mises_MPa", 1, true, cells.von_mises},
      {"equivalent_plastic_strain", 1, true, cells.plastic_strain},
      {"damage", 1, true, cells.damage}};
  constexpr const char *components[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  for (int i = 0; i < 6; ++i) {
    for (double &value : cells.stress[i]) value *= 1e-6;
    fields.push_back({fmt::format("stress_{}_MPa", components[i]), 1, true, cells.stress[i]});
  }
  std::vector<double> parts;
  for (const auto volume : space.volumes) parts.push_back(static_cast<double>(volume));
  fields.push_back({"part", 1, true, parts});
  if (direction) fields.push_back({"arc_direction_deg", 1, true, std::vector<double>(space.n_cells, *direction)});
  space.write_vtu(options.folder + "/" + name, fields);
  record.fields.emplace_back(time, name);
}

bool fields_due(double t, double dt, const RunOptions &options) {
  const double every = options.fields_every;
  return every > 0 && std::floor(t / every + 1e-9) > std::floor((t - dt) / every + 1e-9);
}

void write_pvd(const RunOptions &options, const RunRecord &record) {
  if (record.fields.empty()) return;
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto &[time, name] : record.fields)
    text += fmt::format("<DataSet timestep=\"{:.9g}\" file=\"{}\"/>\n", time, name);
  write_atomically(text + "</Collection>\n</VTKFile>\n", options.folder + "/fields.pvd");
}

} // namespace rimpact::fe
