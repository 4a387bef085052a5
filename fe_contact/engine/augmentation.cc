#include "fe_contact/engine/augmentation.h"

#include <algorithm>
#include <cmath>
#include <Eigen/QR>

namespace rimpact::fe {

using Eigen::Vector3d;

Augmentation augmentation(const ContactSearch &search, const CoulombContact &law, int degree,
                          const SurfaceContactState &state) {
  const std::vector<FacePoint> &points = search.points();
  Augmentation next{std::vector<double>(points.size(), 0.0), std::vector<Vector3d>(points.size(), Vector3d::Zero())};
  const double normal_penalty = law.normal_penalty * state.stiffening,
               tangential_penalty = law.tangential_penalty * state.stiffening;
  const std::size_t per_face = search.points_a_face();
  for (std::size_t first = 0; first < points.size(); first += per_face) {
    std::vector<std::size_t> active;
    for (std::size_t k = first; k < first + per_face; ++k)
      if (state.pressure[k] > 0) active.push_back(k);
    // A bilinear fit asks for points on both sides of the face; where it is less than half covered, a constant.
    const int terms = degree == 2 && 2 * active.size() >= per_face ? 4 : 1;
    Eigen::MatrixXd basis(active.size(), terms), tractions(active.size(), 4);
    for (std::size_t i = 0; i < active.size(); ++i) {
      const auto &point = points[active[i]];
      const double weight = std::sqrt(point.area);
      const double values[4] = {1.0, point.xi, point.eta, point.xi * point.eta};
      for (int t = 0; t < terms; ++t) basis(i, t) = weight * values[t];
      tractions(i, 0) = weight * state.pressure[active[i]];
      tractions.row(i).tail<3>() = weight * state.friction[active[i]].transpose();
    }
    if (active.empty()) continue;
    const Eigen::MatrixXd fit = basis * basis.colPivHouseholderQr().solve(tractions);
    for (std::size_t i = 0; i < active.size(); ++i) {
      const std::size_t k = active[i];
      const double weight = std::sqrt(points[k].area);
      next.multiplier[k] = std::max(0.0, fit(i, 0) / weight);
      next.tangential[k] = fit.row(i).tail<3>().transpose() / weight;
      next.gap_left = std::max(next.gap_left, std::abs(next.multiplier[k] - state.multiplier[k]) / normal_penalty);
      if (state.status[k] == ContactStatus::stick)
        next.slip_left =
            std::max(next.slip_left, (next.tangential[k] - state.tangential[k]).norm() / tangential_penalty);
    }
  }
  return next;
}

} // namespace rimpact::fe
