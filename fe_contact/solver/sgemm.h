/// The product of BLAS in single precision, as Fortran has it: without the lengths of texts that gfortran appends,
/// which ScaLAPACK does not pass.
#pragma once

extern "C" void sgemm_(const char *trans_a, const char *trans_b, const int *m, const int *n, const int *k,
                       const float *alpha, const float *a, const int *lda, const float *b, const int *ldb,
                       const float *beta, float *c, const int *ldc);
