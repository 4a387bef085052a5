// Scenes for Python: read as the command reads them.
#include "python/core_scene.h"

#include "responses/build_version.h"
#include "scene/bearing_catalogue.h"
#include "scene/doubts.h"
#include "scene/toml_writer.h"
#include <pybind11/stl.h>

namespace py = pybind11;

namespace rimpact::python {
namespace {

SceneHandle load(const std::string &where, const std::vector<std::string> &settings) {
  return {std::make_shared<const scene::Scene>(scene::load_scene(where, settings))};
}

SceneHandle parse(const std::string &text, const std::vector<std::string> &settings, const std::string &folder) {
  return {std::make_shared<const scene::Scene>(scene::parse_scene(text, "scene", settings, folder))};
}

/// What the scene allows but doubts, and what its reading filled in.
std::vector<std::string> remarks(const SceneHandle &handle) {
  std::vector<std::string> sentences = handle.scene->remarks;
  for (const auto &doubt : scene::doubts(*handle.scene)) sentences.push_back(doubt);
  return sentences;
}

} // namespace

void add_scene(py::module_ &module) {
  using Guard = py::call_guard<py::gil_scoped_release>;
  py::class_<SceneHandle>(module, "Scene")
      .def_property_readonly("name", [](const SceneHandle &h) { return h.scene->name; })
      .def_property_readonly("bearing", [](const SceneHandle &h) { return h.scene->bearing_name(); })
      .def_property_readonly("model", [](const SceneHandle &h) { return word(h.scene->reduced.model); })
      .def_property_readonly("impact_law", [](const SceneHandle &h) { return h.scene->reduced.impact_law->name; })
      .def_property_readonly("mass", [](const SceneHandle &h) { return h.scene->load.mass; })
      .def_property_readonly("weight", [](const SceneHandle &h) { return h.scene->load.vertical; })
      .def_property_readonly("duration", [](const SceneHandle &h) { return h.scene->excitation.duration; })
      .def_property_readonly("lateral_capacity", [](const SceneHandle &h) { return h.scene->lateral_capacity(); })
      .def_property_readonly("remarks", &remarks)
      .def("toml", [](const SceneHandle &h) { return scene::to_toml(*h.scene); });
  module.def("load_scene", &load, py::arg("where"), py::arg("settings"), Guard());
  module.def("parse_scene", &parse, py::arg("text"), py::arg("settings"), py::arg("folder"), Guard());
  module.def("scene_names", &scene::builtin_scene_names);
  module.def("bearing_names", &scene::builtin_bearing_names);
}

} // namespace rimpact::python
