#include "calibration/data/flight_fit.h"
#include "calibration/data/series.h"
#include "io/files/error.h"
#include <cmath>
#include <Eigen/Dense>

namespace rimpact::calibration {

namespace {

struct ModelFlight {
  std::vector<double> times, u[2], v[2];
  Eigen::Vector2d displacement(double t) const {
    return {hermite_at(times, u[0], v[0], t), hermite_at(times, u[1], v[1], t)};
  }
  Eigen::Vector2d velocity(double t) const { return {linear_at(times, v[0], t), linear_at(times, v[1], t)}; }
};

/// The model's flight from a state, finely sampled; in a straight line where the model refuses.
ModelFlight fly(const scene::Scene &scene, double t, double end, const Eigen::Vector2d &u, const Eigen::Vector2d &v) {
  scene::Scene fine = scene;
  fine.reduced.output_step = (end - t) / 16;
  Response r;
  try {
    const reduced::PhysicalModel model(fine);
    EnergyLedger ledger;
    model.fly(
        on_the_dish(model, t, u, v), end, [](const Eigen::Vector3d &) { return 1.0; }, r, ledger);
  } catch (const Error &) {
    r = {};
  }
  ModelFlight flight;
  if (r.size() >= 2) {
    flight.times = r.series("time");
    for (int c : {0, 1})
      flight.u[c] = r.series(c ? "displacement_y" : "displacement_x"),
      flight.v[c] = r.series(c ? "velocity_y" : "velocity_x");
    return flight;
  }
  flight.times = {t, end};
  for (int c : {0, 1}) flight.u[c] = {u[c], u[c] + (end - t) * v[c]}, flight.v[c] = {v[c], v[c]};
  return flight;
}

} // namespace

reduced::BearingState on_the_dish(const reduced::PhysicalModel &model, double t, const Eigen::Vector2d &u,
                                  const Eigen::Vector2d &v) {
  reduced::BearingState s;
  s.t = t;
  s.u.head<2>() = u, s.v.head<2>() = v;
  const auto ground = model.height(u.x(), u.y());
  s.u.z() = ground.z, s.v.z() = ground.gradient.dot(v);
  if (v.norm() > 0) s.eta = v.normalized();
  return s;
}

double displacement_noise(const std::vector<double> &v, std::size_t first, std::size_t last) {
  double square = 0;
  std::size_t n = 0;
  for (std::size_t i = first + 3; i <= last && i < v.size(); ++i, ++n)
    square += std::pow(v[i] - 3 * v[i - 1] + 3 * v[i - 2] - v[i - 3], 2);
  return n > 0 ? std::sqrt(square / (20.0 * static_cast<double>(n))) : 0;
}

FlightFit fit_flight(const scene::Scene &scene, const Response &response, std::size_t first, std::size_t last,
                     double t_ref, double sigma, bool planar) {
  const auto &times = response.series("time"), &ux = response.series("displacement_x"),
             &uy = response.series("displacement_y");
  const auto n = static_cast<Eigen::Index>(last - first + 1);
  const double begin = times[first], end = times[last], T = end - begin;
  Eigen::MatrixXd A(n, 3), b(n, 2); // in shares of the whole time: 1, s / T, (s / T)^2 / 2
  for (Eigen::Index i = 0; i < n; ++i) {
    const double s = (times[first + i] - t_ref) / T;
    A.row(i) << 1, s, 0.5 * s * s;
  }
  Eigen::Vector2d u(ux[first], uy[first]), v(0, 0);
  { // a first guess: a straight line through the samples
    Eigen::MatrixXd line = A.leftCols(2), data(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) data.row(i) << ux[first + i], uy[first + i];
    const Eigen::MatrixXd c = line.householderQr().solve(data);
    v = c.row(1).transpose() / T, u = c.row(0).transpose() + (begin - t_ref) * v;
  }
  FlightFit fit;
  for (int pass = 0; pass < 3; ++pass) {
    const ModelFlight flight = fly(scene, begin, end, u, v);
    const double a = ((flight.velocity(end) - flight.velocity(begin)) / (end - begin)).norm();
    const double doubt = acceleration_doubt(a);
    for (Eigen::Index i = 0; i < n; ++i)
      b.row(i) = Eigen::RowVector2d(ux[first + i], uy[first + i]) - flight.displacement(times[first + i]).transpose();
    Eigen::Matrix3d normal = A.transpose() * A;
    normal(2, 2) += std::pow(sigma / (doubt * T * T), 2); // the prior: a T^2 is 0 +- doubt T^2
    const Eigen::Matrix3d inverse = normal.inverse();
    const Eigen::MatrixXd c = inverse * A.transpose() * b;
    const Eigen::Vector2d shift = c.row(0).transpose(), faster = c.row(1).transpose() / T;
    fit.u = flight.displacement(t_ref) + shift, fit.v = flight.velocity(t_ref) + faster;
    const Eigen::Vector2d units(1, 1 / T);
    fit.shape = units.asDiagonal() * inverse.topLeftCorner<2, 2>() * units.asDiagonal();
    const Eigen::MatrixXd left = b - A * c;
    const int components = planar ? 2 : 1;
    fit.square = left.leftCols(components).squaredNorm();
    fit.freedom = components * (static_cast<double>(n) - (inverse * A.transpose() * A).trace());
    const double along = left.col(0).head(n - 1).dot(left.col(0).tail(n - 1)), all = left.col(0).squaredNorm();
    fit.lag = all > 0 ? along / all : 0;
    u += shift + (begin - t_ref) * faster, v += faster;
  }
  return fit;
}

} // namespace rimpact::calibration
