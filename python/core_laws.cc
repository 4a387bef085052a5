// Laws of the rim for Python: the force over penetration, its rate and the deepest penetration before, element by
// element.
#include "python/core.h"

#include "files/error.h"
#include "reduced_models/impact_law.h"

namespace py = pybind11;

namespace rimpact::python {
namespace {

using reduced::RimElement;

RimElement element_of(const SceneHandle &handle) {
  const auto &settings = handle.scene->reduced;
  if (settings.impact_law == "curve")
    throw InputError("impact_law \"curve\" has no formula to call; its curve.h5 holds the samples");
  return reduced::rim_element(settings, handle.scene->load.mass);
}

/// Force [N] of the rim, zero where it is not touched.
double force(const RimElement &rim, double penetration, double rate, double deepest) {
  if (!(penetration > 0)) return 0;
  return rim.at({.d = penetration, .rate = rate, .speed = std::abs(rate), .deepest = std::max(deepest, penetration)})
      .force;
}

/// Element by element, numbers and arrays mixed as numpy does.
py::object forces(const RimElement &rim, const py::array_t<double> &penetration, const py::array_t<double> &rate,
                  const py::array_t<double> &deepest) {
  const auto one = [&rim](double d, double speed, double before) { return force(rim, d, speed, before); };
  return py::vectorize(one)(penetration, rate, deepest);
}

py::dict numbers_of(const RimElement &rim) {
  py::dict numbers;
  const auto put = [&](const char *parameter, const char *name, double value) {
    if (rim.law->reads(parameter)) numbers[name] = value;
  };
  put("k_i", "stiffness_N_per_m", rim.stiffness);
  put("e", "damping_N_s_per_m", rim.damping);
  put("exponent", "exponent", rim.exponent);
  if (rim.law->name == "hunt-crossley") numbers["dissipation_s_per_m"] = rim.dissipation;
  put("yield_force", "yield_force_N", rim.yield_force);
  put("hardening", "hardening", rim.hardening);
  put("hardening_exponent", "hardening_exponent", rim.hardening_exponent);
  put("unloading_gain", "unloading_gain", rim.unloading_gain);
  put("unloading_exponent", "unloading_exponent", rim.unloading_exponent);
  return numbers;
}

py::list laws() {
  py::list list;
  for (const auto &law : reduced::impact_laws()) list.append(py::make_tuple(law.name, law.description));
  return list;
}

} // namespace

void add_laws(py::module_ &module) {
  py::class_<RimElement>(module, "Law")
      .def(py::init(&element_of), py::arg("scene"))
      .def_property_readonly("name", [](const RimElement &rim) { return rim.law->name; })
      .def_property_readonly("description", [](const RimElement &rim) { return rim.law->description; })
      .def_property_readonly("yields", [](const RimElement &rim) { return rim.law->yields; })
      .def_property_readonly("numbers", &numbers_of)
      .def("force", &forces, py::arg("penetration"), py::arg("rate"), py::arg("deepest"));
  module.def("laws", &laws);
}

} // namespace rimpact::python
