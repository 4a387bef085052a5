// BLAS of one column for MUMPS's solves. Debian's MUMPS calls strsm and sgemm for one right side as for many, and they
// pack the factor before they use it. The two here stand before the library's in every program with finite elements.
// They take strsv and sgemv for one column, which read the factor once: a quarter of the solves' time on processors
// without AVX-512, a twelfth on those with it. All else goes to the library.
#include "fe_contact/solver/sgemm.h"

#include <cctype>
#include <dlfcn.h>

extern "C" {
// Without the lengths of texts that gfortran appends: ScaLAPACK passes none, and what is not passed must not be
// written.
void strsv_(const char *uplo, const char *trans, const char *diag, const int *n, const float *a, const int *lda,
            float *x, const int *incx);
void sgemv_(const char *trans, const int *m, const int *n, const float *alpha, const float *a, const int *lda,
            const float *x, const int *incx, const float *beta, float *y, const int *incy);
void strsm_(const char *side, const char *uplo, const char *trans, const char *diag, const int *m, const int *n,
            const float *alpha, const float *a, const int *lda, float *b, const int *ldb);
}

namespace {

bool is(const char *option, char letter) {
  return std::toupper(static_cast<unsigned char>(*option)) == letter;
}

/// The library's own routine, behind this one.
template <class Routine> Routine *next(Routine *, const char *name) {
  return reinterpret_cast<Routine *>(dlsym(RTLD_NEXT, name));
}

constexpr int one = 1;

} // namespace

void strsm_(const char *side, const char *uplo, const char *trans, const char *diag, const int *m, const int *n,
            const float *alpha, const float *a, const int *lda, float *b, const int *ldb) {
  static auto *const library = next(strsm_, "strsm_");
  if (*n == 1 && *alpha == 1 && is(side, 'L'))
    strsv_(uplo, trans, diag, m, a, lda, b, &one);
  else
    library(side, uplo, trans, diag, m, n, alpha, a, lda, b, ldb);
}

void sgemm_(const char *trans_a, const char *trans_b, const int *m, const int *n, const int *k, const float *alpha,
            const float *a, const int *lda, const float *b, const int *ldb, const float *beta, float *c,
            const int *ldc) {
  static auto *const library = next(sgemm_, "sgemm_");
  if (*n == 1 && is(trans_b, 'N')) {
    const bool as_it_is = is(trans_a, 'N'); // gemv counts the stored matrix's rows and columns
    sgemv_(trans_a, as_it_is ? m : k, as_it_is ? k : m, alpha, a, lda, b, &one, beta, c, &one);
  } else {
    library(trans_a, trans_b, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);
  }
}
