#include "app/catalogue.h"

#include "app/command_tree.h"

namespace rimpact::app {
namespace {

// Shown in --help here, carried out by rimpact-fe (main_light.cc hands them over before parsing).
constexpr const char *run_name = "run", *run_help = "run a scene by finite elements";
constexpr const char *mesh_name = "mesh", *mesh_help = "mesh a bearing into a .msh file";
constexpr const char *curve_name = "curve", *curve_help = "push a bearing's rim once for every speed";

} // namespace

const std::vector<Verb> &light_verbs() {
  static const std::vector<Verb> verbs{
      {"main", add_main},
      {"new", add_new},
      {"check", add_check},
      {"motion", add_motion},
      {"design", add_design},
      {"reduced", add_reduced},
      {"building", add_building},
      {"reliability", add_reliability},
      {"run", [](CLI::App &app, Console &) { app.add_subcommand(run_name, run_help); }},
      {"mesh", [](CLI::App &app, Console &) { app.add_subcommand(mesh_name, mesh_help); }},
      {"curve", [](CLI::App &app, Console &) { app.add_subcommand(curve_name, curve_help); }},
      {"calibrate", add_calibrate},
      {"compare", add_compare},
      {"geometry", add_geometry},
      {"design-page", add_design_page},
      {"study", add_study},
      {"report", add_report},
      {"export", add_export},
      {"references", add_references},
      {"thesis", add_thesis},
      {"list", add_list},
      {"help", add_help},
      {"completion", add_completion},
      {"version", add_version}};
  return verbs;
}

} // namespace rimpact::app
