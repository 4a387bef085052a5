#include "fe_contact/solver/ranks.h"

#include <algorithm>
#include <limits>
#include <mpi.h>
#include <stdexcept>

namespace rimpact::fe {
namespace {

Ranks &present() {
  static Ranks found = [] {
    Ranks result;
    int started = 0;
    MPI_Initialized(&started);
    if (!started) return result;
    MPI_Comm_size(MPI_COMM_WORLD, &result.size);
    MPI_Comm_rank(MPI_COMM_WORLD, &result.own);
    return result;
  }();
  return found;
}

/// Lengths and places of the shares as MPI wants them.
struct Shares {
  std::vector<int> lengths, places;
  Shares(const std::vector<std::size_t> &offsets, std::size_t each) {
    if (offsets.back() * each > std::size_t(std::numeric_limits<int>::max()))
      throw std::runtime_error(
          "more than 2 GB to hand from rank to rank at once: the mesh is too fine for shares of this kind");
    for (std::size_t r = 0; r + 1 < offsets.size(); ++r) {
      places.push_back(static_cast<int>(offsets[r] * each));
      lengths.push_back(static_cast<int>((offsets[r + 1] - offsets[r]) * each));
    }
  }
};

constexpr std::size_t block = 32; ///< entries that travel together

/// What each rank has for the others of a long vector that is mostly nil: the blocks that are not, and their places.
struct Parcels {
  explicit Parcels(int n_ranks) : counts(n_ranks, 0) {}
  std::vector<int> counts; ///< blocks of each rank
  std::vector<int> places; ///< in the receiver's share
  std::vector<double> values;

  /// What is packed becomes nil: it is handed over.
  void pack(double *share, std::size_t n, int receiver) {
    for (std::size_t k = 0; k < n; k += block) {
      double *first = share + k, *last = share + std::min(n, k + block);
      if (std::all_of(first, last, [](double value) { return value == 0; })) continue;
      ++counts[receiver];
      places.push_back(static_cast<int>(k));
      values.insert(values.end(), first, last);
      values.resize(places.size() * block);
      std::fill(first, last, 0.0);
    }
  }
  void exchange(Parcels &got) const {
    MPI_Alltoall(counts.data(), 1, MPI_INT, got.counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
    const auto sent = ends_of(counts), due = ends_of(got.counts);
    const Shares out(sent, 1), in(due, 1), out_values(sent, block), in_values(due, block);
    got.places.resize(due.back());
    got.values.resize(got.places.size() * block);
    MPI_Alltoallv(places.data(), out.lengths.data(), out.places.data(), MPI_INT, got.places.data(), in.lengths.data(),
                  in.places.data(), MPI_INT, MPI_COMM_WORLD);
    MPI_Alltoallv(values.data(), out_values.lengths.data(), out_values.places.data(), MPI_DOUBLE, got.values.data(),
                  in_values.lengths.data(), in_values.places.data(), MPI_DOUBLE, MPI_COMM_WORLD);
  }

private:
  static std::vector<std::size_t> ends_of(const std::vector<int> &counts) {
    std::vector<std::size_t> result{0};
    for (const int count : counts) result.push_back(result.back() + count);
    return result;
  }
};

/// By way of the first rank: an all-reduce need not give every rank the same last bit.
void reduce(double *values, int n, MPI_Op operation, const Ranks &ranks) {
  if (ranks.size == 1) return;
  MPI_Reduce(ranks.first() ? MPI_IN_PLACE : values, values, n, MPI_DOUBLE, operation, 0, MPI_COMM_WORLD);
  MPI_Bcast(values, n, MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

} // namespace

const Ranks &ranks() {
  return present();
}

std::vector<std::size_t> Ranks::offsets(std::size_t n) const {
  std::vector<std::size_t> result;
  for (int r = 0; r <= size; ++r) result.push_back(n * r / size);
  return result;
}

void Ranks::all_reduce_sum(Eigen::VectorXd &values) const {
  reduce(values.data(), static_cast<int>(values.size()), MPI_SUM, *this);
}

double Ranks::all_reduce_sum(double value) const {
  reduce(&value, 1, MPI_SUM, *this);
  return value;
}

void Ranks::all_reduce_max(Eigen::VectorXd &values) const {
  reduce(values.data(), static_cast<int>(values.size()), MPI_MAX, *this);
}

bool Ranks::any(bool value) const {
  double number = value;
  reduce(&number, 1, MPI_MAX, *this);
  return number > 0;
}

void Ranks::reduce_scatter(std::vector<double> &values, const std::vector<std::size_t> &offsets) const {
  Parcels sent(size), got(size);
  for (int r = 0; r < size; ++r)
    if (r != own) sent.pack(values.data() + offsets[r], offsets[r + 1] - offsets[r], r);
  sent.exchange(got);
  double *share = values.data() + offsets[own];
  const std::size_t n = offsets[own + 1] - offsets[own];
  for (std::size_t k = 0; k < got.places.size(); ++k) {
    const std::size_t place = got.places[k], length = std::min(block, n - place);
    for (std::size_t i = 0; i < length; ++i) share[place + i] += got.values[k * block + i];
  }
}

void Ranks::all_gather_bytes(void *data, std::size_t bytes_each, const std::vector<std::size_t> &offsets) const {
  if (size == 1) return;
  const Shares shares(offsets, bytes_each);
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, data, shares.lengths.data(), shares.places.data(), MPI_BYTE,
                 MPI_COMM_WORLD);
}

OnOneRank::OnOneRank() : before_(present()) {
  present() = {};
}
OnOneRank::~OnOneRank() {
  present() = before_;
}

} // namespace rimpact::fe
