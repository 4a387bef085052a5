/// What a fit makes small, one block an impact or a flight; see fit.h for the groups.
#pragma once
#include "calibration/fit/fit.h"
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>

namespace rimpact::calibration {

/// What is compared (fit.h); of measured impacts also how they start.
enum class Compared { force, displacement, rebound, peak, phase, flight, start, gain };

/// Residuals first .. first + count - 1 of a block share one stated uncertainty and together count as one
/// observation.
struct Group {
  Compared kind;
  int first, count;
  double weight;
  double noise = 0; ///< variance of one of its residuals by the record's noise; used of measured blocks alone
  double freedom = std::numeric_limits<double>::infinity(); ///< degrees of freedom that noise was found with
};

/// The channels of a record, each with a noise of its own. What is known of an impact's start comes from displacements.
enum class Channel { force, displacement };

class ResidualBlock {
public:
  explicit ResidualBlock(const scene::Scene &scene) : scene_(scene) {}
  virtual ~ResidualBlock() = default;
  const scene::Scene &scene() const { return scene_; }
  const std::vector<Group> &groups() const { return groups_; }
  int size() const { return groups_.empty() ? 0 : groups_.back().first + groups_.back().count; }
  /// What the impact itself leaves open (its start, its clock), in standard errors, fitted beside the parameters: each
  /// has a residual of its own size, so that it is known beforehand to +-1.
  virtual int n_nuisance() const { return 0; }
  /// What is fitted beside a law's parameters: the block's own unknowns, and the error of the force channel's gain, one
  /// for all impacts, in its standard errors.
  struct Beside {
    std::span<const double> nuisance;
    double gain = 0;
  };
  /// `scene` is scene() with trial values. May throw what the reduced model throws.
  virtual void evaluate(const scene::Scene &scene, const Beside &beside, std::span<double> residuals) const = 0;

  /// Whether the covariance of the residuals comes from the record's own noise, and not from stated uncertainties.
  virtual bool measured() const { return false; }
  /// V X with the covariance V of the residuals by the noise of one channel's samples, each independent; `X` has a row
  /// a residual.
  virtual Eigen::MatrixXd noise_times(const Eigen::MatrixXd &X, Channel) const {
    return Eigen::MatrixXd::Zero(X.rows(), X.cols());
  }
  /// Degrees of freedom the channel's noise was found with, and the record it was found in: the error of the noise is
  /// common to all impacts of a record.
  virtual double freedom(Channel) const { return std::numeric_limits<double>::infinity(); }
  virtual const void *record() const { return nullptr; }
  /// Standard error of the force channel's gain [-]; 0: it is exact.
  virtual double gain_error() const { return 0; }
  /// Derivative of the residuals by Beside::gain, where they are `residuals`.
  virtual Eigen::VectorXd gain_slope(double, const Eigen::VectorXd &residuals) const {
    return Eigen::VectorXd::Zero(residuals.size());
  }

protected:
  /// Adds a group; returns weight / (sigma sqrt(count)), what its differences are multiplied by.
  double add_group(Compared kind, int count, double weight, double sigma);
  Group &last_group() { return groups_.back(); }

private:
  scene::Scene scene_;
  std::vector<Group> groups_;
};

std::unique_ptr<ResidualBlock> impact_block(const StoredRun &run, const ImpactWindow &window,
                                            const FitOptions &options);
/// What is known of the gain beforehand: one residual, its error in standard errors.
std::unique_ptr<ResidualBlock> gain_block(const scene::Scene &scene);
/// Motion from rest to the first touch; of quasi-static scenes the force instead.
std::unique_ptr<ResidualBlock> flight_block(const StoredRun &run, const FitOptions &options);

} // namespace rimpact::calibration
