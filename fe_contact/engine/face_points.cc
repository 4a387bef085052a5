#include "fe_contact/engine/face_points.h"

#include <cmath>
#include <Eigen/Geometry>
#include <map>

namespace rimpact::fe {
namespace {

/// Gauss-Legendre points and weights on [-1, 1], n = 2..5, by Newton on the Legendre polynomial.
void gauss(int n, std::vector<double> &points, std::vector<double> &weights) {
  for (int i = 0; i < n; ++i) {
    double x = std::cos(M_PI * (i + 0.75) / (n + 0.5)), derivative = 1;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double p0 = 1, p1 = x;
      for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      derivative = n * (x * p1 - p0) / (x * x - 1);
      const double change = p1 / derivative;
      x -= change;
      if (std::abs(change) < 1e-15) break;
    }
    points.push_back(x);
    weights.push_back(2 / ((1 - x * x) * derivative * derivative));
  }
}

} // namespace

std::vector<FacePoint> face_points(const Discretisation &space, const std::vector<const Face *> &faces, int n) {
  std::vector<double> x, w;
  gauss(n, x, w);
  std::vector<FacePoint> result;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        FacePoint point{static_cast<int>(f), x[i], x[j], face_shapes(space.degree, x[i], x[j]), 0.0, {}};
        Eigen::Vector3d t1 = Eigen::Vector3d::Zero(), t2 = t1;
        for (int a = 0; a < point.shapes.n; ++a) {
          t1 += point.shapes.dxi[a] * space.positions[faces[f]->nodes[a]];
          t2 += point.shapes.deta[a] * space.positions[faces[f]->nodes[a]];
        }
        const Eigen::Vector3d across = faces[f]->orientation * t1.cross(t2);
        point.area = w[i] * w[j] * across.norm();
        point.normal = across.normalized();
        result.push_back(point);
      }
  return result;
}

void average_to_nodes(const std::vector<FacePoint> &points, const std::vector<const Face *> &faces,
                      const std::vector<double> &values, std::vector<double> &nodal) {
  std::map<unsigned, std::pair<double, double>> sums; // weight, weighted value
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int a = 0; a < points[k].shapes.n && std::isfinite(values[k]); ++a) {
      auto &[weight, sum] = sums[faces[points[k].face]->nodes[a]];
      const double w = points[k].area * std::abs(points[k].shapes.N[a]);
      weight += w;
      sum += w * values[k];
    }
  for (const auto &[node, entry] : sums)
    if (entry.first > 0) nodal[node] = entry.second / entry.first;
}

} // namespace rimpact::fe
