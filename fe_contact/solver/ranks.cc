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

void Ranks::broadcast(Eigen::VectorXd &values) const {
  if (size > 1) MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

double Ranks::broadcast(double value) const {
  if (size > 1) MPI_Bcast(&value, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return value;
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
