/// Record files of folders by PEER's record sequence number, with their spectral accelerations.
#pragma once
#include "io/records/rotated_spectrum.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::risk {

class RecordShelf {
public:
  /// Horizontal components as io/records/record_folder.h tells them. A file name that several folders have is taken
  /// from the first. Throws as read_record_folder.
  RecordShelf(const std::vector<std::string> &folders, double period_s);
  /// Paths of a record's horizontal components, sorted; none: it is not at hand.
  std::vector<std::string> components(const std::string &rsn) const;
  /// Every horizontal file, by name, but those that are another one, scaled or not.
  std::vector<std::string> all();
  /// What was recorded together: the station of its folder's list, else the file's own label.
  std::string station(const std::string &file) const;
  /// Sentences: files that all() leaves out, once it was asked.
  const std::vector<std::string> &copies() const { return copies_; }
  /// Sentences: records whose direction is not known and which are not used, one a folder.
  const std::vector<std::string> &questions() const { return questions_; }
  /// Spectral acceleration of the whole record as it is [standard g], 5 % damping. Throws DataError.
  double sa_g(const std::string &file);
  /// The same of the pair that a component belongs to, over all directions; none: it belongs to none.
  std::optional<RotatedAcceleration> rotated_g(const std::string &file);

private:
  double period_;
  std::map<std::string, std::string> files_;                  ///< name -> path
  std::map<std::string, std::vector<std::string>> by_number_; ///< RSN -> paths
  std::map<std::string, double> sa_;                          ///< by path
  std::map<std::string, std::string> stations_;               ///< by path
  std::map<std::string, std::string> pairs_;                  ///< path of the other component, by path
  std::map<std::string, RotatedAcceleration> rotated_;        ///< [standard g], by path
  std::vector<std::string> questions_, copies_;
};

} // namespace rimpact::risk
