#include "fe_contact/drive/memory_limit.h"

#include "files/address_space.h"
#include "files/error.h"
#include <fmt/format.h>

namespace rimpact::fe {

void need_memory(double bytes) {
  if (const auto left = address_space_left(); left && *left < bytes)
    throw SolverStopped(fmt::format("the limit of memory (ulimit -v, {:.2g} GB) leaves {:.2g} GB and the plan asks for "
                                    "{:.2g} GB; a coarser mesh (a lower model.mesh) needs less",
                                    1e-9 * *address_space_limit(), 1e-9 * *left, 1e-9 * bytes));
}

} // namespace rimpact::fe
