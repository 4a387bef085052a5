/// Reading a sampled signal between its samples. Times ascend; equal neighbours mark a jump.
#pragma once
#include <cstddef>
#include <vector>

namespace rimpact::calibration {

/// Index i with times[i] <= t < times[i+1], kept within the series (the ends extrapolate nothing: see *_at).
std::size_t interval_of(const std::vector<double> &times, double t);

/// Linear between samples, the end values outside.
double linear_at(const std::vector<double> &times, const std::vector<double> &values, double t);
/// Cubic through the values and rates of both neighbours, the end values outside.
double hermite_at(const std::vector<double> &times, const std::vector<double> &values, const std::vector<double> &rates,
                  double t);
/// Third-order through the four nearest samples of one pulse, from the zero where it begins to that where it ends; zero
/// outside. A jump at touch or release is kept where both of its instants are stored. Continuous in `t` and in the
/// samples: a release that passes `t` moves the value by nothing.
double pulse_at(const std::vector<double> &times, const std::vector<double> &values, double t);

/// d values / dt: at each sample the slope of the parabola through it and its neighbours, at ends and jumps
/// (equal times) of the parabola on its own side.
std::vector<double> differentiate(const std::vector<double> &times, const std::vector<double> &values);

} // namespace rimpact::calibration
