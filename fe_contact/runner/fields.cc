// Pictures' data: VTU files of the deformed solids and their PVD index.
#include "fe_contact/runner/rim_run.h"

#include "scene/error.h"
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace rimpact::fe {

void write_fields(const RimSolver &solver, const ArcState &state, const RimFrame &frame, double time,
                  const RunOptions &options, RunRecord &record) {
  if (!options.keeps_fields()) return;
  const Discretisation &space = solver.space();
  const Eigen::VectorXd u = solver.displacements(state);
  const SolidFields cells = solver.solid().fields(u, state.history);
  std::vector<double> pressure, gap, stress = cells.von_mises;
  solver.contact().nodal_fields(state.contact, pressure, gap);
  for (double &value : pressure) value *= 1e-6;
  for (double &value : gap) value *= 1e3;
  for (double &value : stress) value *= 1e-6;
  std::vector<double> direction(space.n_cells, frame.direction * 180 / M_PI);
  const auto name = fmt::format("fields/rim_{:03d}.vtu", record.fields.size());
  std::filesystem::create_directories(options.folder + "/fields");
  space.write_vtu(options.folder + "/" + name, {{"displacement", 3, false, {u.data(), u.data() + u.size()}},
                                                {"contact_pressure_MPa", 1, false, pressure},
                                                {"gap_mm", 1, false, gap},
                                                {"von_mises_MPa", 1, true, stress},
                                                {"equivalent_plastic_strain", 1, true, cells.plastic_strain},
                                                {"arc_direction_deg", 1, true, direction}});
  record.fields.emplace_back(time, name);
}

void write_pvd(const RunOptions &options, const RunRecord &record) {
  if (record.fields.empty()) return;
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto &[time, name] : record.fields)
    text += fmt::format("<DataSet timestep=\"{:.9g}\" file=\"{}\"/>\n", time, name);
  scene::write_text(text + "</Collection>\n</VTKFile>\n", options.folder + "/fields.pvd");
}

} // namespace rimpact::fe
