#include "RimImpact.h"

#include <Channel.h>
#include <FEM_ObjectBroker.h>
#include <OPS_Globals.h>
#include <Vector.h>
#include <algorithm>
#include <classTags.h>
#include <cmath>
#include <cstring>
#include <elementAPI.h>

#ifndef MAT_TAG_RimImpact
#define MAT_TAG_RimImpact 0 // a number of classTags.h once it is there
#endif

// Reads its words; null, with a sentence that names the word, where one is not as RimImpact.h says.
void *OPS_RimImpact() {
  const char *usage = "uniaxialMaterial RimImpact tag k Fy h p a m gap <-twoSided> <-noDents>\n";
  int tag = 0, one = 1, seven = 7;
  double v[7];
  if (OPS_GetNumRemainingInputArgs() < 8 || OPS_GetIntInput(&one, &tag) != 0 || OPS_GetDoubleInput(&seven, v) != 0) {
    opserr << "WARNING RimImpact: a tag and seven numbers are wanted: " << usage;
    return 0;
  }
  RimImpact::Numbers n = {v[0], v[1], v[2], v[3], v[4], v[5], v[6], false, false};
  while (OPS_GetNumRemainingInputArgs() > 0) {
    const char *word = OPS_GetString();
    if (std::strcmp(word, "-twoSided") == 0) n.twoSided = true;
    else if (std::strcmp(word, "-noDents") == 0) n.noDents = true;
    else {
      opserr << "WARNING RimImpact " << tag << ": the word " << word << " is not known: " << usage;
      return 0;
    }
  }
  if (!(n.k > 0 && n.Fy > 0 && n.h >= 0 && n.h <= 1 && n.p > 0 && n.p <= 1 && n.a >= 0 && n.m > 0 && n.gap != 0)) {
    opserr << "WARNING RimImpact " << tag << ": wanted are k, Fy, m > 0, h in 0..1, p in (0, 1], a >= 0, gap not 0\n";
    return 0;
  }
  return new RimImpact(tag, n);
}

RimImpact::RimImpact(int tag, const Numbers &numbers) : UniaxialMaterial(tag, MAT_TAG_RimImpact), n_(numbers) {}
RimImpact::RimImpact() : UniaxialMaterial(0, MAT_TAG_RimImpact), n_() {}

RimImpact::Force RimImpact::loading(double d) const {
  const double x = n_.k * d / n_.Fy, knee = (1 - n_.h) * x, root = std::sqrt(1 + knee * knee);
  return {n_.Fy * (knee / root + n_.h / n_.p * (std::pow(1 + x, n_.p) - 1)),
          n_.k * ((1 - n_.h) / (root * root * root) + n_.h * std::pow(1 + x, n_.p - 1))};
}

RimImpact::Force RimImpact::unloading(double d, double deepest) const {
  const double top = loading(deepest).force, steep = n_.k * (1 + n_.a * std::pow(n_.k * deepest / n_.Fy, n_.m));
  const double w = std::min(0.5, steep * deepest / top - 1), length = (1 + w) * top / steep;
  const double s = 1 - (deepest - d) / length;
  if (s <= 0) return {0, 0};
  return {top * s * (1 - w + w * s), top / length * (1 - w + 2 * w * s)};
}

double RimImpact::letsGo(double deepest) const {
  const double top = loading(deepest).force, steep = n_.k * (1 + n_.a * std::pow(n_.k * deepest / n_.Fy, n_.m));
  return deepest - (1 + std::min(0.5, steep * deepest / top - 1)) * top / steep;
}

int RimImpact::setTrialStrain(double strain, double) {
  strain_ = strain, stress_ = tangent_ = 0;
  deepest_[0] = committed_[1], deepest_[1] = committed_[2];
  const int side = strain > 0, way = side ? 1 : -1;
  if (!n_.twoSided && (n_.gap > 0) != (side == 1)) return 0;
  const double d = way * strain - std::fabs(n_.gap), deepest = deepest_[side];
  if (n_.noDents && deepest > 0 && d <= letsGo(deepest)) deepest_[side] = 0;
  if (d <= 0) return 0;
  const Force now = d < deepest_[side] ? unloading(d, deepest_[side]) : loading(d);
  deepest_[side] = std::max(deepest_[side], d);
  stress_ = way * now.force, tangent_ = now.slope;
  return 0;
}

int RimImpact::commitState() {
  committed_[0] = strain_, committed_[1] = deepest_[0], committed_[2] = deepest_[1];
  return 0;
}

int RimImpact::revertToLastCommit() {
  return setTrialStrain(committed_[0]);
}

int RimImpact::revertToStart() {
  std::fill(committed_, committed_ + 3, 0.0);
  return setTrialStrain(0);
}

UniaxialMaterial *RimImpact::getCopy() {
  RimImpact *copy = new RimImpact(this->getTag(), n_);
  std::copy(committed_, committed_ + 3, copy->committed_);
  copy->setTrialStrain(strain_);
  return copy;
}

int RimImpact::sendSelf(int commitTag, Channel &channel) {
  static Vector data(13);
  const double all[13] = {double(this->getTag()), n_.k, n_.Fy, n_.h, n_.p, n_.a, n_.m, n_.gap, double(n_.twoSided),
                          double(n_.noDents), committed_[0], committed_[1], committed_[2]};
  for (int i = 0; i < 13; ++i) data(i) = all[i];
  return channel.sendVector(this->getDbTag(), commitTag, data);
}

int RimImpact::recvSelf(int commitTag, Channel &channel, FEM_ObjectBroker &) {
  static Vector data(13);
  if (channel.recvVector(this->getDbTag(), commitTag, data) < 0) return -1;
  this->setTag(int(data(0)));
  n_ = {data(1), data(2), data(3), data(4), data(5), data(6), data(7), data(8) != 0, data(9) != 0};
  for (int i = 0; i < 3; ++i) committed_[i] = data(10 + i);
  return revertToLastCommit();
}

void RimImpact::Print(OPS_Stream &stream, int) {
  stream << "RimImpact tag: " << this->getTag() << " k: " << n_.k << " Fy: " << n_.Fy << " h: " << n_.h << " p: " << n_.p
         << " a: " << n_.a << " m: " << n_.m << " gap: " << n_.gap << (n_.twoSided ? " -twoSided" : "")
         << (n_.noDents ? " -noDents" : "") << "\n";
}
