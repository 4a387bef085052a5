#include "buildings/plane_frame.h"
#include "buildings/frame_design.h"
#include "buildings/regular_building.h"
#include "io/files/error.h"
#include "io/files/key_list.h"
#include "io/files/toml_reader.h"
#include "scene/assumptions.h"
#include <fmt/format.h>

namespace rimpact::buildings {

namespace {

void visit_class(KeyVisitor &v, MemberClass &c) {
  v.limit({"yield_kN_m", "moment of an end section; not given: by [design]"}, c.yield_moment, kilo, {0, huge, true});
  v.limit({"axial_yield_kN", "not given: 0.85 f_c times area"}, c.axial_yield, kilo, {0, huge, true});
  if (v.wants(c.law.interaction != Interaction::none))
    v.choice(
        {.name = "interaction", .meaning = "of the moment with the axial force; yield_kN_m is then that without one"},
        c.law.interaction);
  v.number({"hinge_length_mm", "of an end section, at most a sixth of the member"}, c.law.hinge_length, milli,
           {0, 1e4, true});
  v.number({"post_yield_ratio", "stiffness after yield over before"}, c.law.post_yield, si, {0, 1});
  v.number({"exponent", "n of Bouc-Wen"}, c.law.exponent, si, {1, 100});
  v.number({"beta", "of Bouc-Wen"}, c.law.beta, si, {0.5, 1});
  v.number({"strength_degradation", "d_nu, a unit of normalised lost energy"}, c.law.strength_loss, si, {0, 1});
  v.number({"stiffness_degradation", "d_eta, a unit of normalised lost energy"}, c.law.stiffness_loss, si, {0, 2});
}

/// Keys of sections that the file leaves to their defaults, or marks.
std::vector<std::string> assumed_of(const TomlFile &file, PlaneFrame frame) {
  KeyList list;
  visit(list, frame);
  std::vector<std::string> words;
  for (const auto &entry : list.entries) {
    const std::string path = entry.path();
    const bool ours = path == "concrete_MPa" || path.starts_with("design.") || path.starts_with("column.") ||
                      path.starts_with("beam.");
    if (!ours || (file.find(path) && !scene::is_marked(file, path))) continue;
    if (path == "column.yield_kN_m" || path == "beam.yield_kN_m")
      words.push_back(path + " by [design]");
    else if (path == "column.axial_yield_kN" || path == "beam.axial_yield_kN")
      words.push_back(path + " = 0.85 f_c times area");
    else
      words.push_back(path + " = " + entry.value);
  }
  return words;
}

/// `depth`: in the plane of the frame.
Section section_of(const PlaneFrame &f, const MemberClass &c, const char *name, double y, double z, double depth) {
  Section s = rectangle(name, y, z, f.E, 0.2);
  s.shear_y = s.shear_z = 0, s.inelastic = c.law, s.inelastic->depth = depth;
  s.inelastic->yield_moment = c.yield_moment.value_or(0);
  s.inelastic->axial_yield = c.axial_yield.value_or(0.85 * f.strength * s.area);
  return s;
}

} // namespace

void visit(KeyVisitor &v, PlaneFrame &f) {
  const Range size{0, 1e5, true};
  v.text({"name", "of the frame"}, f.name);
  v.numbers({"x_m", "column lines"}, f.x, si, {-1e4, 1e4});
  v.numbers({"storeys_m", "from the base up"}, f.storeys, si, {0, 100, true});
  v.number({"load_kN_per_m", "seismic weight along the beams of every level"}, f.load, kilo, positive);
  v.number({"gravity_m_per_s2", "makes masses of it"}, f.gravity, si, {0, 1e3, true});
  v.number({"E_GPa", "of the concrete"}, f.E, {1e9, false}, {0, 1e6, true});
  v.number({"concrete_MPa", "f_c"}, f.strength, mega, {0, 1e6, true});
  v.number({"column_x_mm", "side of a column in the plane"}, f.column_x, milli, size);
  v.number({"column_y_mm", "side of a column out of the plane"}, f.column_y, milli, size);
  v.number({"beam_width_mm", "of every beam"}, f.beam_width, milli, size);
  v.number({"beam_depth_mm", "of every beam"}, f.beam_depth, milli, size);
  v.number({"damping_ratio", "of the elastic frame with its base held"}, f.damping_ratio, si, {0, 1});
  v.section("design", [&] {
    v.number({"shear", "V_st over the weight of all levels"}, f.design.shear, si, {0, 10, true});
    v.number({"height_exponent", "k of the forces w h^k"}, f.design.height_exponent, si, {0, 10});
    v.number({"overstrength", "yield moment over the largest design moment"}, f.design.overstrength, si,
             {0, 100, true});
  });
  v.section("column", [&] { visit_class(v, f.column); });
  v.section("beam", [&] { visit_class(v, f.beam); });
}

Frame make_frame(const PlaneFrame &p) {
  check_lines("x_m", p.x);
  if (p.storeys.empty()) throw InputError("storeys_m is empty; an inelastic frame has one storey at least");
  const int nx = static_cast<int>(p.x.size()), levels = static_cast<int>(p.storeys.size()) + 1;
  const double width = p.x.back() - p.x[0], mass = p.load / p.gravity * width;
  Frame f;
  f.name = p.name, f.damping_ratio = p.damping_ratio, f.assumed = p.assumed;
  f.sections = {section_of(p, p.column, "column", p.column_x, p.column_y, p.column_x),
                section_of(p, p.beam, "beam", p.beam_width, p.beam_depth, p.beam_depth)};
  double z = 0;
  for (int level = 0; level < levels; ++level) {
    if (level > 0) z += p.storeys[level - 1];
    Diaphragm slab{{}, mass, {p.x[0] + width / 2, 0}, mass * width * width / 12};
    for (int i = 0; i < nx; ++i) {
      const int node = static_cast<int>(f.nodes.size());
      slab.nodes.push_back(node);
      f.nodes.push_back({{p.x[i], 0, z}, p.load / p.gravity * tributary(p.x, i), level == 0});
      if (level > 0) f.elements.push_back({node - nx, node, 0, Eigen::Vector3d::UnitY()});
      if (i > 0) f.elements.push_back({node - 1, node, 1, Eigen::Vector3d::UnitZ(), p.load});
    }
    f.diaphragms.push_back(slab);
  }
  for (const auto &[node, bearing] : p.bearings) {
    if (node < 1 || node > nx)
      throw InputError(fmt::format("[bearings] names node {}; the frame stands on nodes 1 to {}", node, nx));
    f.nodes[node - 1].bearing = bearing;
  }
  design_yield_moments(f, p.design, p.gravity);
  return f;
}

bool is_plane_frame(const std::string &text, const std::string &origin) {
  const TomlFile file(text, origin);
  for (const char *key : {"load_kN_per_m", "design", "column", "beam"})
    if (file.find(key)) return true;
  return false;
}

PlaneFrame parse_plane_frame(const std::string &text, const std::string &origin) {
  const TomlFile file(text, origin);
  TomlReader v(file, "");
  PlaneFrame f;
  visit(v, f);
  v.finish({"bearings"});
  f.bearings = own_bearings(file), f.assumed = assumed_of(file, f);
  try {
    check_lines("x_m", f.x);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{}: {}", file.location("x_m"), error.what()));
  }
  const auto check_hinge = [&](const MemberClass &c, const std::string &name, const std::vector<double> &lengths) {
    for (const double L : lengths)
      if (!(c.law.hinge_length <= L / 6))
        throw InputError(fmt::format("{}: {}.hinge_length_mm {:g} exceeds {:g}, a sixth of its shortest member",
                                     file.location(name + ".hinge_length_mm"), name, 1e3 * c.law.hinge_length,
                                     1e3 * L / 6));
  };
  std::vector<double> bays;
  for (std::size_t i = 1; i < f.x.size(); ++i) bays.push_back(f.x[i] - f.x[i - 1]);
  check_hinge(f.column, "column", f.storeys), check_hinge(f.beam, "beam", bays);
  return f;
}

} // namespace rimpact::buildings
