#include "responses/signals.h"

#include <array>
#include <fmt/format.h>
#include <set>
#include <tuple>

namespace rimpact {
namespace {

using List = std::vector<SignalInfo>;

void add_vector(List &list, const std::string &name, const char *units, const char *what) {
  for (const char *axis : {"x", "y", "z"})
    list.push_back({name + "_" + axis, units, fmt::format("{}, {} component", what, axis)});
}

/// Of one bearing, whichever model moves it.
void add_bearing_signals(List &list) {
  add_vector(list, "displacement", "m", "displacement of the upper slider relative to the plate");
  add_vector(list, "velocity", "m/s", "velocity of the upper slider relative to the plate");
  add_vector(list, "force", "N", "force of the bearing on the mass");
  add_vector(list, "pendular", "N", "share of the force normal to the sliding surface");
  add_vector(list, "friction", "N", "share of the force from friction");
  add_vector(list, "impact", "N", "share of the force from the rim");
  add_vector(list, "moment_below", "N m", "moment of the bearing on the node below");
  add_vector(list, "moment_above", "N m", "moment of the bearing on the node above");
  add_vector(list, "ground_acceleration", "m/s^2", "of the ground");
  add_vector(list, "acceleration", "m/s^2", "absolute, of the mass (of the top plate of a bearing of rigid bodies)");
  list.push_back({"gap", "m",
                  "L_c - |u|, u less what the slider's halves have slipped; negative while the rim is pressed; of a "
                  "triple pendulum "
                  "L_c is where the last rim is"});
  list.push_back({"normal_force", "N", "normal force of the sliding surface, never negative"});
  list.push_back({"temperature", "degC", "of the sliding steel at the dish's vertex (the bottom dish's of two)"});
  list.push_back({"temperature_top", "degC", "of the sliding steel at the top dish's vertex"});
  list.push_back({"temperature_inner", "degC", "of the steel below a triple pendulum's inner slider"});
  list.push_back({"temperature_inner_top", "degC", "of the steel above it"});
  list.push_back({"tilt", "rad", "angle of the (bottom) slider's axis to the vertical, bearings of rigid bodies"});
  for (const char *axis : {"x", "y"})
    list.push_back({fmt::format("interface_slip_{}", axis), "m", "of the top slider past the bottom one"});
}

/// Of the contact points of sliders between two plates, of the upper plate, and of a triple pendulum's four faces.
void add_rigid_body_signals(List &list) {
  constexpr int most_points = 64;
  using Set = std::pair<char, const char *>;
  for (const auto &[set, where] :
       {Set{'A', "top plate"}, Set{'B', "bottom plate"}, Set{'C', "interface, or the inner slider's lower face"},
        Set{'D', "inner slider's upper face"}})
    for (int i = 1; i <= most_points; ++i)
      list.push_back({fmt::format("normal_{}{}", set, i), "N",
                      fmt::format("normal force of contact point {} on the {}", i, where)});
  constexpr std::array faces{"bottom plate", "inner slider's lower face", "inner slider's upper face", "top plate"};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const char *axis : {"x", "y"})
      list.push_back({fmt::format("face_{}_travel_{}", i + 1, axis), "m",
                      fmt::format("part of the displacement on a triple pendulum's {}, {}", faces[i], axis)});
    list.push_back({fmt::format("face_{}_rim_force", i + 1), "N", fmt::format("of the rim at the {}", faces[i])});
    list.push_back({fmt::format("face_{}_rim_penetration", i + 1), "m", "of that rim"});
  }
  for (const char *axis : {"x", "y"})
    list.push_back({fmt::format("plate_moment_{}", axis), "N m", "of the bearing on the top plate about its vertex"});
}

/// Of a superstructure on one bearing.
void add_superstructure_signals(List &list) {
  for (const char *axis : {"x", "y"}) {
    list.push_back({fmt::format("drift_{}", axis), "m", "of the superstructure's first storey, u_s"});
    list.push_back(
        {fmt::format("storey_shear_{}", axis), "N", "force of the superstructure's first storey on the base"});
  }
  add_vector(list, "roof", "m", "displacement of the highest floor relative to the base");
  add_vector(list, "roof_acceleration", "m/s^2", "absolute acceleration of the highest floor, gravity left out");
}

void add_energies(List &list) {
  for (const auto &[name, what] : std::initializer_list<std::pair<const char *, const char *>>{
           {"external", "work of ground motion and drives"},
           {"gravity", "potential energy gained"},
           {"kinetic", "kinetic energy"},
           {"elastic", "stored elastic energy"},
           {"plastic", "dissipated by plastic flow or a hysteretic storey"},
           {"damping", "dissipated by the superstructure's dashpots and by the pad"},
           {"friction", "dissipated by friction"},
           {"impact", "dissipated by the reduced impact law"},
           {"contact", "stored in or lost by contact penalties"},
           {"integrator", "lost by the time integrator, from its own formula"}})
    list.push_back({fmt::format("energy_{}", name), "J", what});
}

/// Of a building on many bearings: `displacement_x` ... are those of the base's mass centre, `force_x` ... sums.
void add_building_signals(List &list) {
  constexpr int most_bearings = 64, most_floors = 40, most_members = 200;
  using Row = std::tuple<const char *, const char *, const char *>;
  const auto add = [&](const char *what, int most, std::initializer_list<Row> rows) {
    for (int i = 1; i <= most; ++i)
      for (const auto &[name, units, words] : rows)
        list.push_back({fmt::format("{}_{}_{}", what, i, name), units, fmt::format("{} {}: {}", what, i, words)});
  };
  add("bearing", most_bearings,
      {{"displacement_x", "m", "slider past the plate, x"},
       {"displacement_y", "m", "slider past the plate, y"},
       {"displacement_z", "m", "slider above the vertex"},
       {"force_x", "N", "on the building, x"},
       {"force_y", "N", "on the building, y"},
       {"impact_x", "N", "of the rim on the building, x"},
       {"impact_y", "N", "of the rim on the building, y"},
       {"normal_force", "N", "of the sliding surface"},
       {"gap", "m", "L_c - |u|, negative while the rim is pressed"},
       {"interface_slip_x", "m", "top slider past the bottom one, x"},
       {"interface_slip_y", "m", "top slider past the bottom one, y"},
       {"moment_x", "N m", "on the node above it, about x"},
       {"moment_y", "N m", "on the node above it, about y"}});
  add("floor", most_floors,
      {{"displacement_x", "m", "of the mass centre relative to the ground, x"},
       {"displacement_y", "m", "of the mass centre relative to the ground, y"},
       {"rotation", "rad", "about the vertical"},
       {"drift_x", "m", "of the storey below it, x"},
       {"drift_y", "m", "of the storey below it, y"},
       {"acceleration_x", "m/s^2", "absolute, of the mass centre, x"},
       {"acceleration_y", "m/s^2", "absolute, of the mass centre, y"}});
  add("member", most_members,
      {{"moment_i", "N m", "of an inelastic one's end i, about y"},
       {"moment_j", "N m", "of an inelastic one's end j, about y"},
       {"rotation_i", "rad", "plastic, of end i, about y"},
       {"rotation_j", "rad", "plastic, of end j, about y"}});
  for (const char *axis : {"x", "y"})
    list.push_back({fmt::format("overturning_{}", axis), "N m",
                    fmt::format("moment of the bearings' forces about the {} axis through the base's centre", axis)});
  for (const char *axis : {"x", "y"})
    list.push_back({fmt::format("base_acceleration_{}", axis), "m/s^2",
                    fmt::format("absolute, of the base's mass centre, {}", axis)});
  list.push_back({"base_rotation", "rad", "of the base about the vertical"});
}

/// Of finite elements: walls, steel, pressures, the rim's foot.
void add_solid_signals(List &list) {
  list.push_back({"surface_gap", "m", "way until slider and rim walls meet, of both rims of two dishes together"});
  list.push_back({"plastic_strain_max", "1", "largest equivalent plastic strain"});
  list.push_back({"contact_pressure_max", "Pa", "largest contact pressure"});
  list.push_back({"pad_pressure_max", "Pa", "largest pressure of the pad on the dish, or of a slider between two"});
  list.push_back({"seat_pressure_max", "Pa", "largest pressure of a frictional pad on the bottom of its recess"});
  list.push_back({"recess_pressure_max", "Pa", "largest pressure of a frictional pad on the wall of its recess"});
  list.push_back({"energy_friction_seat", "J", "of energy_friction, dissipated in a frictional pad's recess"});
  list.push_back(
      {"rim_foot_normal", "N", "of the rim's wall on its plate, upwards, over the whole foot; 0 between impacts"});
  list.push_back({"rim_foot_shear", "N", "the same, horizontal"});
  list.push_back(
      {"rim_foot_moment", "N m", "the same, about the foot's middle, tipping the wall outwards, summed along the rim"});
  list.push_back(
      {"rim_foot_normal_per_length", "N/m", "upwards, where the foot's joint, or two fillet welds, is used most"});
  list.push_back({"rim_foot_shear_per_length", "N/m", "outwards, there"});
  list.push_back({"rim_foot_moment_per_length", "N", "tipping outwards, there"});
  list.push_back({"rim_foot_weld_force", "N/m", "of one of two fillet welds, there"});
  list.push_back({"rim_foot_use", "1", "of what the joint at the rim's foot bears; it goes at 1"});
}

void add_solver_signals(List &list) {
  list.push_back({"newton_iterations", "1", "Newton iterations of the step"});
  list.push_back({"augmentations", "1", "augmentations of the contact's multipliers since the row before"});
  list.push_back({"backtracks", "1", "shortened Newton steps tried since the row before"});
  list.push_back({"eliminations", "1", "times a few equations were solved by themselves, since the row before"});
  list.push_back({"linear_iterations", "1", "iterations of the linear solver since the row before"});
  list.push_back({"factorisations", "1", "factorisations since the row before"});
  list.push_back({"cuts", "1", "steps solved and not taken since the row before"});
  list.push_back({"step", "s", "time step"});
}

} // namespace

const List &known_signals() {
  static const List signals = [] {
    List list{{"time", "s", "instant, or load parameter of a quasi-static run"}};
    for (const auto add : {add_bearing_signals, add_rigid_body_signals, add_superstructure_signals, add_energies,
                           add_building_signals, add_solid_signals, add_solver_signals})
      add(list);
    return list;
  }();
  return signals;
}

bool is_signal(const std::string &name) {
  static const std::set<std::string> names = [] {
    std::set<std::string> result;
    for (const auto &signal : known_signals()) result.insert(signal.name);
    return result;
  }();
  return names.count(name) > 0;
}

} // namespace rimpact
