#ifndef RimImpact_h
#define RimImpact_h
// A rim that yields, as a uniaxial material of OpenSees: written to be proposed there. SI or any consistent units.
//
//   uniaxialMaterial RimImpact $tag $k $Fy $h $p $a $m $gap <-twoSided> <-noDents>
//
// Beyond the gap, at penetration d = strain - gap, x = k d / Fy and c = 1 - h, it presses with
//   F = Fy [c x / sqrt(1 + (c x)^2) + h ((1 + x)^p - 1) / p]
// and returns from its deepest penetration D with force T along
//   F = T [(1 - w) s + w s^2],  s = 1 - (D - d) / L,  L = (1 + w) T / S,  S = k (1 + a (k D / Fy)^m),
// w = 0.5, or less where the curve would reach past d = 0. It never pulls, it has no rate, and its dent stays: a second
// impact begins where the first let go.
//   k    > 0       stiffness at first touch
//   Fy   > 0       yield force
//   h    0 .. 1    tangent over k just beyond yield
//   p    0 < p <= 1 the tangent falls as (1 + x)^(p - 1)
//   a    >= 0      gain of the unloading's stiffness
//   m    > 0       its exponent
//   gap            > 0: closes in tension; < 0: closes in compression
//   -twoSided      both: each side keeps its own dent, so one zeroLength stands for both sides of a rim
//   -noDents       what lets go is new again: a round rim, of which one truss stands for every direction
// Source: rimpact, docs/theory/rim.md; the knee is that of Menegotto and Pinto (1973) with exponent 2.

#include <UniaxialMaterial.h>

class RimImpact : public UniaxialMaterial {
public:
  struct Numbers {
    double k, Fy, h, p, a, m, gap;
    bool twoSided, noDents;
  };
  RimImpact(int tag, const Numbers &numbers);
  RimImpact(); // for a channel to fill

  const char *getClassType() const { return "RimImpact"; }
  int setTrialStrain(double strain, double strainRate = 0.0);
  double getStrain() { return strain_; }
  double getStress() { return stress_; }
  double getTangent() { return tangent_; }
  double getInitialTangent() { return 0.0; }
  int commitState();
  int revertToLastCommit();
  int revertToStart();
  UniaxialMaterial *getCopy();
  int sendSelf(int commitTag, Channel &channel);
  int recvSelf(int commitTag, Channel &channel, FEM_ObjectBroker &broker);
  void Print(OPS_Stream &stream, int flag = 0);

private:
  struct Force {
    double force, slope;
  };
  Force loading(double d) const;
  Force unloading(double d, double deepest) const;
  double letsGo(double deepest) const; // penetration at which the force ends

  Numbers n_;
  double strain_ = 0.0, stress_ = 0.0, tangent_ = 0.0;
  double deepest_[2] = {0.0, 0.0};        // of the side in compression and in tension
  double committed_[3] = {0.0, 0.0, 0.0}; // strain and the two above
};

#endif
