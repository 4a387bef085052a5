// The part of OpenSees' interface that RimImpact needs, so that its law is tested without OpenSees. Beside OpenSees'
// sources this folder is not wanted.
#pragma once

class Channel;
class FEM_ObjectBroker;
class OPS_Stream;

class UniaxialMaterial {
public:
  UniaxialMaterial(int tag, int) : tag_(tag) {}
  virtual ~UniaxialMaterial() = default;
  virtual int setTrialStrain(double strain, double strainRate = 0.0) = 0;
  virtual double getStrain() = 0;
  virtual double getStress() = 0;
  virtual double getTangent() = 0;
  virtual int commitState() = 0;
  virtual int revertToLastCommit() = 0;
  virtual int revertToStart() = 0;
  virtual UniaxialMaterial *getCopy() = 0;
  int getTag() const { return tag_; }
  void setTag(int tag) { tag_ = tag; }
  int getDbTag() const { return 0; }

private:
  int tag_;
};
