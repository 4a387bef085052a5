#include "buildings/vtk_series.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::VectorXd;

namespace {

std::string array(const char *name, int components, const std::vector<double> &values) {
  std::string text = fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">",
                                 name, components);
  for (const double value : values) text += fmt::format("{:.7g} ", value);
  return text + "</DataArray>\n";
}

template <class Values> std::string integers(const char *name, const char *type, const Values &values) {
  std::string text = fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">", type, name);
  for (const int value : values) text += fmt::format("{} ", value);
  return text + "</DataArray>\n";
}

std::string cells(const Frame &frame, const std::vector<int> &bearings) {
  std::vector<int> ends, offsets, types;
  for (const auto &member : frame.elements)
    ends.insert(ends.end(), {member.i, member.j}), offsets.push_back(static_cast<int>(ends.size())), types.push_back(3);
  for (const int node : bearings)
    ends.push_back(node), offsets.push_back(static_cast<int>(ends.size())), types.push_back(1);
  return "<Cells>\n" + integers("connectivity", "Int32", ends) + integers("offsets", "Int32", offsets) +
         integers("types", "UInt8", types) + "</Cells>\n";
}

std::string cell_data(const Frame &frame, const VectorXd &forces, const BuildingInstant &at) {
  std::vector<double> axial, moment, normal(frame.elements.size()), rim = normal, kind = normal;
  for (std::size_t e = 0; e < frame.elements.size(); ++e) {
    const auto f = forces.segment(MemberForces::n_components * e, MemberForces::n_components);
    axial.push_back(1e-3 * f[6]); // tension is positive
    moment.push_back(1e-3 * std::max(f.segment(4, 2).norm(), f.segment(10, 2).norm()));
  }
  for (std::size_t b = 0; b < at.normal.size(); ++b) {
    axial.push_back(0), moment.push_back(0), kind.push_back(1);
    normal.push_back(1e-3 * at.normal[b]), rim.push_back(1e-3 * at.rim_force[b]);
  }
  return "<CellData>\n" + array("kind", 1, kind) + array("axial_kN", 1, axial) + array("moment_kN_m", 1, moment) +
         array("normal_force_kN", 1, normal) + array("rim_force_kN", 1, rim) + "</CellData>\n";
}

std::string grid(const Frame &frame, const BuildingModel &model, const MemberForces &members,
                 const BuildingInstant &at) {
  std::vector<double> points, moved;
  const VectorXd u = model.nodal * at.q;
  for (std::size_t i = 0; i < frame.nodes.size(); ++i)
    for (int c = 0; c < 3; ++c) points.push_back(frame.nodes[i].at[c]), moved.push_back(u[6 * i + c]);
  return fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                     "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
                     "NumberOfCells=\"{}\">\n",
                     frame.nodes.size(), frame.elements.size() + model.bearings.size()) +
         "<Points>\n" + array("Points", 3, points) + "</Points>\n" + cells(frame, model.bearings) + "<PointData>\n" +
         array("displacement", 3, moved) + "</PointData>\n" +
         cell_data(frame, at.members.size() ? at.members : members.at(at.q), at) +
         "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace

void write_vtk_series(const Frame &frame, const BuildingModel &model, const BuildingTrace &trace,
                      const std::string &folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder + "/fields", failure);
  if (failure) throw IoError(fmt::format("{}/fields: {}", folder, failure.message()));
  const MemberForces members(frame, model);
  std::string series = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  int number = 0;
  for (const auto &instant : trace.instants) {
    const std::string name = fmt::format("fields/building-{:05}.vtu", number++);
    write_atomically(grid(frame, model, members, instant), folder + "/" + name);
    series += fmt::format("<DataSet timestep=\"{:.9g}\" file=\"{}\"/>\n", instant.t, name);
  }
  write_atomically(series + "</Collection>\n</VTKFile>\n", folder + "/fields.pvd");
}

void write_elevation(const Frame &frame, const BuildingModel &model, const BuildingInstant &hardest,
                     const std::string &path) {
  const VectorXd u = model.nodal * hardest.q;
  std::string text = "time_s,node,x_m,y_m,z_m,ux_m,uy_m,uz_m,normal_force_N,rim_force_N\n";
  std::size_t bearing = 0;
  for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
    const auto &at = frame.nodes[i].at;
    text += fmt::format("{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},", hardest.t, i + 1, at[0], at[1], at[2],
                        u[6 * i], u[6 * i + 1], u[6 * i + 2]);
    if (frame.nodes[i].supported) {
      text += fmt::format("{:.6g},{:.6g}\n", hardest.normal[bearing], hardest.rim_force[bearing]);
      ++bearing;
    } else {
      text += ",\n";
    }
  }
  write_atomically(text, path);
}

} // namespace rimpact::buildings
