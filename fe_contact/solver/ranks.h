/// The processes that share one run (`mpirun -np N`). Each holds the mesh and the whole state; cells and slave faces
/// are shared out. What is decided on the way is decided alike on every rank, because all of them see the same numbers,
/// bit for bit. Without mpirun there is one rank, and nothing is sent.
#pragma once
#include <cstddef>
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

struct Ranks {
  int size = 1, own = 0;

  bool first() const { return own == 0; }
  /// Of n things rank r has those from offsets[r] up to offsets[r + 1].
  std::vector<std::size_t> offsets(std::size_t n) const;
  void all_reduce_sum(Eigen::VectorXd &values) const;
  double all_reduce_sum(double value) const;
  void all_reduce_max(Eigen::VectorXd &values) const;
  bool any(bool value) const;
  /// All take what the first rank has.
  void broadcast(Eigen::VectorXd &values) const;
  double broadcast(double value) const;
  /// Each rank's own share of `values` goes to all the others.
  template <class T> void all_gather(std::vector<T> &values, const std::vector<std::size_t> &offsets) const {
    if (size > 1) all_gather_bytes(values.data(), sizeof(T), offsets);
  }
  void all_gather_bytes(void *data, std::size_t bytes_each, const std::vector<std::size_t> &offsets) const;
};

/// Those of this process.
const Ranks &ranks();

/// In its life this process is on its own: what is small, or keeps no shares.
class OnOneRank {
public:
  OnOneRank();
  ~OnOneRank();
  OnOneRank(const OnOneRank &) = delete;

private:
  Ranks before_;
};

} // namespace rimpact::fe
