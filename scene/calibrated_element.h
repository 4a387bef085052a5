/// The rim's law and its numbers as a calibration folder has them.
#pragma once
#include "io/files/key_list.h"
#include "scene/fitted_plates.h"
#include "scene/stack_terms.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::scene {

/// What a calibration says, as values of keys of [reduced].
struct CalibratedElement {
  std::string origin;                        ///< the file read
  std::map<std::string, std::string> values; ///< key -> TOML value
  std::string rim;                           ///< identity of the rim it was fitted to; empty: not said
  std::optional<double> capacity;            ///< where the element begins [m]
  int rims = 1;                              ///< that it is the law of, in series
  StackTerms stack;

  [[noreturn]] void fail(const std::string &what) const; ///< throws DataError
  void number(const std::string &key, std::optional<double> value);
  void text(const std::string &key, const std::string &value);
};

/// Keys of [reduced] that make the rim's element.
const std::vector<std::string> &element_keys();
/// Of them those of the plates it was fitted between, what is known of them or every one.
std::vector<KeyEntry> keys_of_plates(FittedPlates plates, bool every = false);

/// Of calibration.json's `answer`, or of calibration.toml where there is none. Throws DataError for a calibration that
/// cannot be read, or whose numbers no scene could have.
CalibratedElement calibrated_element(const std::string &folder);

} // namespace rimpact::scene
