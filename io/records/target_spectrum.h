/// Elastic spectra of codes, 5 % damping, that records are selected and scaled to.
#pragma once
#include <string>

namespace rimpact {

class TargetSpectrum {
public:
  /// "asce7,S_DS=1.0,S_D1=0.6,T_L=8": the two-period design spectrum of ASCE/SEI 7-22, 11.4.5.2, accelerations in g,
  /// T_L [s] (8 where not given). "en1998,a_g=0.25,ground=C,type=1": the horizontal elastic spectrum of EN
  /// 1998-1:2004, 3.2.2.2, with a_g in g, ground types A to E of its tables 3.2 (type 1) and 3.3 (type 2). `scale`
  /// multiplies either. Throws InputError naming key, value and bound.
  explicit TargetSpectrum(const std::string &text);

  /// S_a [g] at period >= 0 [s].
  double at(double period) const;
  /// Whether the spectrum is that of the largest direction (ASCE 7-22), else of any component.
  bool is_largest_direction() const { return is_asce_; }
  const std::string &words() const { return words_; } ///< the text as understood

private:
  double asce(double period) const;
  double en1998(double period) const;
  void read_asce(const class TargetKeys &keys);
  void read_en1998(const class TargetKeys &keys);

  bool is_asce_ = true;
  double short_ = 0, one_ = 0, long_period_ = 8;               ///< S_DS, S_D1 [g], T_L [s]
  double ground_ = 0, soil_ = 1, t_b_ = 0, t_c_ = 0, t_d_ = 0; ///< a_g [g], S [-], [s]
  double scale_ = 1;
  std::string words_;
};

} // namespace rimpact
