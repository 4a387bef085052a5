// The routines that stand before BLAS's: MUMPS finds them, and what they give is what Eigen gives.
#include <cmath>
#include <dlfcn.h>
#include <Eigen/Dense>
#include <gtest/gtest.h>

extern "C" {
void strsm_(const char *side, const char *uplo, const char *trans, const char *diag, const int *m, const int *n,
            const float *alpha, const float *a, const int *lda, float *b, const int *ldb);
void sgemm_(const char *trans_a, const char *trans_b, const int *m, const int *n, const int *k, const float *alpha,
            const float *a, const int *lda, const float *b, const int *ldb, const float *beta, float *c,
            const int *ldc);
}

namespace rimpact::fe {
namespace {

using Eigen::MatrixXf;
constexpr int m = 7, k = 5, lda = 9, ldb = 8;

MatrixXf numbers(int rows, int columns, float shift) {
  MatrixXf result(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) result(i, j) = std::sin(shift + 1.7f * i + 0.6f * j);
  return result;
}

TEST(OneColumnBlas, IsWhatASharedLibraryFinds) {
  EXPECT_EQ(dlsym(RTLD_DEFAULT, "strsm_"), reinterpret_cast<void *>(strsm_));
  EXPECT_EQ(dlsym(RTLD_DEFAULT, "sgemm_"), reinterpret_cast<void *>(sgemm_));
  EXPECT_NE(dlsym(RTLD_NEXT, "strsm_"), nullptr) << "the library's own, for all else";
}

TEST(OneColumnBlas, SolvesWithTrianglesAsEigenDoes) {
  for (const int n : {1, 3})
    for (const char uplo : {'L', 'U'})
      for (const char trans : {'N', 'T'})
        for (const float alpha : {1.0f, 0.5f}) {
          MatrixXf a = numbers(lda, m, 0.3f), b = numbers(ldb, n, 1.1f);
          for (int i = 0; i < m; ++i) a(i, i) = 3 + 0.1f * i;
          const MatrixXf square = a.topRows(m), right = alpha * b.topRows(m);
          MatrixXf triangle = uplo == 'L' ? MatrixXf(square.triangularView<Eigen::Lower>())
                                          : MatrixXf(square.triangularView<Eigen::Upper>());
          if (trans == 'T') triangle.transposeInPlace();
          const MatrixXf below = b.bottomRows(ldb - m);
          strsm_("L", &uplo, &trans, "N", &m, &n, &alpha, a.data(), &lda, b.data(), &ldb);
          EXPECT_LT((triangle * b.topRows(m) - right).norm(), 1e-5f) << n << uplo << trans << alpha;
          EXPECT_EQ(b.bottomRows(ldb - m), below) << "what is below the column is not its own";
        }
}

TEST(OneColumnBlas, MultipliesAsEigenDoes) {
  for (const int n : {1, 3})
    for (const char trans_a : {'N', 'T'})
      for (const char trans_b : {'N', 'T'})
        for (const float beta : {0.0f, -0.7f}) {
          const float alpha = -1.3f;
          const MatrixXf a = numbers(lda, lda, 0.2f), b = numbers(lda, lda, 0.9f);
          MatrixXf c = numbers(lda, n, 2.0f);
          const MatrixXf op_a = trans_a == 'N' ? MatrixXf(a.topLeftCorner(m, k))
                                               : MatrixXf(a.topLeftCorner(k, m).transpose()),
                         op_b = trans_b == 'N' ? MatrixXf(b.topLeftCorner(k, n))
                                               : MatrixXf(b.topLeftCorner(n, k).transpose());
          const MatrixXf due = alpha * op_a * op_b + beta * c.topRows(m);
          sgemm_(&trans_a, &trans_b, &m, &n, &k, &alpha, a.data(), &lda, b.data(), &lda, &beta, c.data(), &lda);
          EXPECT_LT((c.topRows(m) - due).norm(), 1e-5f) << n << trans_a << trans_b << beta;
        }
}

} // namespace
} // namespace rimpact::fe
