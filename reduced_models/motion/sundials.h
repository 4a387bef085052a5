/// SUNDIALS 6 and 7 by the names of 7. The only place that asks for the version.
#pragma once
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace rimpact::reduced {

/// The context that the objects of one solver share. The caller frees it, after those objects, by SUNContext_Free.
inline SUNContext sundials_context() {
  SUNContext context = nullptr;
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_Create(SUN_COMM_NULL, &context);
#else
  SUNContext_Create(nullptr, &context);
#endif
  return context;
}

/// CVODE prints nothing of its own: the caller reads what each call returns.
inline void silence([[maybe_unused]] SUNContext context, [[maybe_unused]] void *cvode_memory) {
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_ClearErrHandlers(context);
#else
  CVodeSetErrHandlerFn(
      cvode_memory, [](int, const char *, const char *, char *, void *) {}, nullptr);
#endif
}

} // namespace rimpact::reduced
