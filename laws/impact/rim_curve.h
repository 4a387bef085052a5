/// The rim's force over penetration as pushed quasi-statically by finite elements (`rimpact curve`): one loading curve,
/// and curves of unloading from some depths. SI units; forces > 0 push the slider inwards.
///
/// Between samples monotone cubics (Fritsch and Butland 1984, Boost's pchip). Unloading from D between two pushed
/// depths: the returned way L and the shape f of the force over the share x of that way are interpolated,
///   F(d) = F_load(D) f(x; D),  x = (D - d) / L(D),
/// L / D by a monotone cubic from 1 at D = 0 (elastic), f linearly in D; below the first pushed depth f is that
/// depth's.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace rimpact::laws {

/// Penetration [m] and force [N] along one push.
struct CurveSamples {
  std::vector<double> penetration, force;
};
/// As pushed along one way of the slider.
struct CurvePath {
  CurveSamples loading; ///< from (0, 0), the penetration rises
  std::vector<CurveSamples>
      unloading; ///< each from a point of the loading, the penetration falls until the force is 0; deeper and deeper
};

class RimCurve {
public:
  /// Throws InputError naming what is wrong: fewer than 4 samples a curve, an order, an end, a value that is not
  /// finite.
  explicit RimCurve(CurvePath path);
  ~RimCurve();
  RimCurve(RimCurve &&) noexcept;

  struct Force {
    double force, slope; ///< [N], [N/m]
  };
  /// First loading at d [m]; straight on beyond the range and below zero.
  Force loading(double d) const;
  /// At d <= D, D the deepest penetration so far [m], > 0; below zero force: by how much it is from pressing.
  Force unloading(double d, double deepest) const;
  double range() const;                  ///< deepest penetration that was unloaded from [m]
  double work(double d) const;           ///< taken by first loading to d, 0..range [J]
  double returned(double deepest) const; ///< by unloading from D [J]
  double residual(double deepest) const; ///< penetration left after unloading from D [m]
  double depth_of(double work) const;    ///< inverse of `work` [m]
  /// Largest relative change of the rebound speed (sqrt of the returned energy) if the unloading of one depth between
  /// the first and the last were not known. 0 with fewer than three depths.
  double left_out_rebound() const;
  const CurvePath &path() const { return path_; }

private:
  struct Interpolants;
  CurvePath path_;
  std::unique_ptr<Interpolants> by_;
};

} // namespace rimpact::laws
