/// What a finite-element run is doing, for whoever waits for it: "pressing, 2.1 mm into the rim, 812 kN".
#pragma once
#include "fe_contact/drive/run.h"

namespace rimpact::app {

class ProgressInWords {
public:
  explicit ProgressInWords(const scene::Excitation &motion)
      : window_(motion.kind == scene::ExcitationKind::window), in_time_(motion.is_dynamic()) {}
  /// Remembers the gap: the rim is pressed while it closes and springs back while it opens. A window ends at its
  /// release, so that its time is not shown against the scene's end.
  std::string of(const fe::Progress &progress);

private:
  bool window_, in_time_;
  double last_gap_ = 0;
  bool springing_back_ = false;
};

/// "  t 0.0525 s, step 1.56e-05 s, 3 Newton iterations": what --verbose adds.
std::string numbers_of(const fe::Progress &progress);

} // namespace rimpact::app
