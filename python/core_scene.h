/// Scene for Python: keys, files, what was assumed.
#pragma once
#include "python/core.h"

namespace rimpact::python {

void add_scene(pybind11::module_ &module); ///< Scene

} // namespace rimpact::python
