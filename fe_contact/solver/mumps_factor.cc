#include "fe_contact/solver/mumps_factor.h"

#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <array>
#include <dmumps_c.h>
#include <mpi.h>
#include <new>
#include <smumps_c.h>

namespace rimpact::fe {
namespace {

/// MUMPS's `sym` for a symmetric matrix. In single precision pivots come from the diagonal, which makes the factor a
/// fifth cheaper; where that will not do, GMRES shows it, and the factor in double precision looks for its pivots.
constexpr int diagonal_pivots = 1, any_pivots = 2;

struct Single {
  static constexpr int symmetric = diagonal_pivots;
  static constexpr int scaling = 0; // none: GMRES would show where it is missed
  using Number = float;
  using Data = SMUMPS_STRUC_C;
  static void call(Data &data) { smumps_c(&data); }
};
struct Double {
  static constexpr int symmetric = any_pivots;
  static constexpr int scaling = 77; // MUMPS chooses
  using Number = double;
  using Data = DMUMPS_STRUC_C;
  static void call(Data &data) { dmumps_c(&data); }
};

template <class Kind> class Factor : public MumpsFactor {
public:
  explicit Factor(const MatrixPattern &pattern)
      : rows_(pattern.rows), columns_(pattern.columns), values_(rows_.size()), x_(pattern.n) {
    for (int &row : rows_) ++row; // MUMPS counts from 1
    for (int &column : columns_) ++column;
    data_.comm_fortran = MPI_Comm_c2f(shared_ ? MPI_COMM_WORLD : MPI_COMM_SELF);
    data_.par = 1;
    data_.sym = pattern.symmetric ? Kind::symmetric : 0;
    run(-1);
    for (const int output : {1, 2, 3}) control(output) = -1;
    control(4) = 0; // nothing printed
    control(7) = 5; // METIS ordering
    control(8) = Kind::scaling;
    if (data_.sym == diagonal_pivots) control(13) = 1; // no ScaLAPACK, whose root would have to be positive definite
    control(14) = 50;                                  // room for pivoting [%]
    control(28) = 1;                                   // one rank orders
    data_.n = pattern.n;
    data_.rhs = x_.data();
    hand_in();
  }
  ~Factor() override { run(-2); }

  bool factorise(const double *values) override {
    std::transform(values, values + values_.size(), values_.begin(),
                   [](double v) { return static_cast<typename Kind::Number>(v); });
    if (!analysed_) run(1);
    require_memory();
    if (data_.infog[0] < 0) return false;
    analysed_ = true;
    constexpr int workspace_too_small = -9, most_room = 800;
    for (run(2); data_.infog[0] == workspace_too_small && control(14) < most_room; run(2)) control(14) *= 2;
    require_memory();
    return data_.infog[0] >= 0;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd &right_side) override {
    std::transform(right_side.begin(), right_side.end(), x_.begin(),
                   [](double v) { return static_cast<typename Kind::Number>(v); });
    run(3); // the first rank has the solution
    Eigen::VectorXd x(right_side.size());
    std::copy(x_.begin(), x_.end(), x.begin());
    if (shared_) ranks().broadcast(x);
    return x;
  }

  FactorWork work() const override {
    constexpr double millions = 1e6; // MUMPS counts in them where a number is negative
    const double entries = data_.info[26];
    return {data_.rinfo[2], entries < 0 ? -millions * entries : entries, static_cast<double>(rows_.size())};
  }

private:
  /// One rank alone hands in all entries at once, which spares MUMPS a tenth of its work; else each its own.
  void hand_in() {
    const auto n_entries = static_cast<MUMPS_INT8>(rows_.size());
    if (shared_) {
      control(18) = 3;
      data_.nnz_loc = n_entries;
      data_.irn_loc = rows_.data(), data_.jcn_loc = columns_.data(), data_.a_loc = values_.data();
    } else {
      data_.nnz = n_entries;
      data_.irn = rows_.data(), data_.jcn = columns_.data(), data_.a = values_.data();
    }
  }
  /// A matrix that cannot be factorised and memory that cannot be had want different cures.
  void require_memory() const {
    constexpr std::array no_memory{-5, -7, -13, -19};
    if (std::find(no_memory.begin(), no_memory.end(), data_.infog[0]) != no_memory.end()) throw std::bad_alloc();
  }
  int &control(int i) { return data_.icntl[i - 1]; }
  void run(int job) {
    data_.job = job;
    Kind::call(data_);
  }
  const bool shared_ = ranks().size > 1; ///< for its life
  typename Kind::Data data_{};
  bool analysed_ = false;
  std::vector<int> rows_, columns_;
  std::vector<typename Kind::Number> values_, x_;
};

} // namespace

std::unique_ptr<MumpsFactor> mumps_factor(Precision precision, const MatrixPattern &pattern) {
  if (precision == Precision::single_) return std::make_unique<Factor<Single>>(pattern);
  return std::make_unique<Factor<Double>>(pattern);
}

} // namespace rimpact::fe
