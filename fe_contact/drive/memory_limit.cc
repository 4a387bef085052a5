#include "fe_contact/drive/memory_limit.h"

#include "fe_contact/solver/sgemm.h"
#include "io/files/address_space.h"
#include "io/files/error.h"
#include <fmt/format.h>
#include <vector>

namespace rimpact::fe {
namespace {

constexpr double blas_buffer = 135.3e6; ///< of OpenBLAS, taken at the first product that is not small [bytes]

/// A product that is large enough for OpenBLAS to take its buffer, which it keeps: later, without room for it, it would
/// ask for memory without end.
void take_blas_buffer() {
  constexpr int n = 160;
  constexpr float one = 1, nil = 0;
  const std::vector<float> a(n * n, 1.0f);
  std::vector<float> c(n * n);
  sgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &nil, c.data(), &n);
}

} // namespace

void need_memory(double bytes) {
  const auto left = address_space_left();
  if (!left) return;
  const double needed = bytes + blas_buffer;
  if (*left < needed)
    throw SolverStopped(fmt::format("the limit of memory (ulimit -v, {:.2g} GB) leaves {:.2g} GB and the plan asks for "
                                    "{:.2g} GB; a coarser mesh (a lower model.mesh) needs less",
                                    1e-9 * *address_space_limit(), 1e-9 * *left, 1e-9 * needed));
  take_blas_buffer();
}

} // namespace rimpact::fe
