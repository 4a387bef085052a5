// Numbers by their place: what RimImpact sends over a channel.
#pragma once
#include <vector>

class Vector {
public:
  explicit Vector(int size) : values_(size) {}
  double &operator()(int i) { return values_[i]; }
  double operator()(int i) const { return values_[i]; }

private:
  std::vector<double> values_;
};
